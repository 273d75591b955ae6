#include <fmt/format.h>

#include <array>
#include <cmath>

#include "comparisons/quantities/reference.h"
#include "comparisons/quantities/surface_fields.h"
#include "comparisons/run/plots.h"
#include "contact/bodies/half_space_scales.h"
#include "report/format.h"
#include "report/plot_style.h"
#include "theory/oscillating_cylinder.h"

namespace tricontact::comparisons {

namespace {

using contact::Surface;

constexpr std::size_t most_line_points = 400;  // per curve: more than the picture resolves
constexpr int exact_points = 200;
constexpr double margin = 1.12;  // of the plot beside the path

/// Half width of the plot, over a: all that the contact passes.
double view(const Histories& histories) {
    double w = 0;
    for (const contact::History& history : histories) w = std::max(w, amplitude_ratio(history));
    return margin * (1 + w);
}

/// Values over `unit` on the row's points, positions over a, within the plot.
std::string row_data(const std::string& name, const Surface& s, const std::vector<double>& values,
                     double a, double unit, double half_view) {
    std::vector<std::vector<double>> columns(2);
    for (const std::size_t i : report::thinned(s.size(), most_line_points)) {
        const double x = s.x(static_cast<int>(i)) / a;
        if (std::abs(x) > half_view) continue;
        columns[0].push_back(x);
        columns[1].push_back(values[i] / unit);
    }
    return report::data_block(name, columns);
}

template <class F>
std::string function_data(const std::string& name, double half_view, const F& function) {
    std::vector<std::vector<double>> columns(2);
    for (int i = 0; i <= exact_points; ++i) {
        const double x = half_view * (2.0 * i / exact_points - 1);
        columns[0].push_back(x);
        columns[1].push_back(function(x));
    }
    return report::data_block(name, columns);
}

std::string model_curve(const std::string& data, std::size_t i, const std::string& title) {
    return fmt::format("{} with lines linewidth 1.5 linecolor rgb '{}' {}", data,
                       report::model_colour(i),
                       title.empty() ? "notitle" : "title '" + title + "'");
}

std::string theory_curve(const std::string& data, const std::string& title) {
    return fmt::format("{} with lines dashtype 2 linewidth 1.4 linecolor rgb '{}' {}", data,
                       report::theory_colour, title.empty() ? "notitle" : "title '" + title + "'");
}

std::string script_of(const std::string& data, const std::string& label, double half_view,
                      const std::vector<std::string>& curves) {
    return data + report::plot_style() +
           fmt::format(
               "set xlabel 'position x/a'\nset ylabel '{}'\nset xrange [-{:.4g}:{:.4g}]\n"
               "set key outside top center horizontal maxcols 3 samplen 1.6\nplot {}\n",
               label, half_view, half_view, fmt::join(curves, ", "));
}

std::vector<Plot> turning_plot(const contact::Case& c, const Histories& histories) {
    constexpr std::array<double, 2> before_upright{0.75, 0.25};  // turning points, in periods
    const double half_view = view(histories);
    std::string data;
    std::vector<std::string> curves;
    for (std::size_t i = 0; i < histories.size(); ++i) {
        const contact::History& history = histories[i];
        const contact::Snapshot* last = last_upright(history);
        if (!last) continue;
        for (const double before : before_upright) {
            const contact::Snapshot* turn = snapshot_at(history, last->phase - before);
            if (!turn) continue;
            const std::string name = fmt::format("$model{}_{}", i, curves.size());
            data +=
                row_data(name, turn->surface, turn->surface.normal_traction,
                         history.scales.contact_radius, history.scales.peak_pressure, half_view);
            const bool first = before == before_upright.front();
            curves.push_back(
                model_curve(name, i, first ? report::display_name(history.model) : ""));
        }
    }
    if (curves.empty()) return {};
    const Reference r = reference(c);
    if (constant_loads(c))
        for (const double turn : {-r.amplitude_ratio, r.amplitude_ratio}) {
            const std::string name = turn < 0 ? "$left" : "$right";
            data += function_data(name, half_view, [&](double x) {
                return std::sqrt(std::max(0., 1 - (x - turn) * (x - turn)));
            });
            curves.push_back(theory_curve(name, turn < 0 ? "Hertz (3.5.15)" : ""));
        }
    return {{"turning_points",
             "Pressure at the turning points (as figure 3.38 (a) of the thesis)",
             "In the last period, positions on the substrate. What lies under both curves is in "
             "contact throughout; the lower of them bounds the traction that can stay.",
             {640, 400, script_of(data, "pressure p / p_0", half_view, curves)}}};
}

/// u_x/U_max of the half-space, where it is known.
std::string exact_displacement(const contact::Case& c, double half_view) {
    const Reference r = reference(c);
    const auto stick = c.rolling ? r.stick_ratio
                       : in_unit_range(r.tangential_ratio)
                           ? theory::line_stick_half_width(0, r.tangential_ratio)
                           : std::nullopt;
    if (!stick || !(*stick > 0)) return {};
    const double lambda =
        contact::line_shift_factor(c.materials(), c.indenter.length / r.hertz.contact_radius);
    const double w = c.rolling ? r.amplitude_ratio : 0;
    return function_data("$theory", half_view, [&](double x) {
        return theory::line_shakedown_displacement(x, w, *stick, lambda);
    });
}

std::vector<Plot> displacement_plot(const contact::Case& c, const Histories& histories) {
    const double half_view = view(histories);
    std::string data;
    std::vector<std::string> curves;
    for (std::size_t i = 0; i < histories.size(); ++i) {
        const contact::Snapshot* last = last_upright(histories[i]);
        if (!last) continue;
        const contact::Scales& scales = histories[i].scales;
        const std::string name = fmt::format("$model{}", i);
        data += row_data(name, last->surface, last->surface.displacement_x, scales.contact_radius,
                         scales.unit_shift, half_view);
        curves.push_back(model_curve(name, i, report::display_name(histories[i].model)));
    }
    if (curves.empty()) return {};
    const std::string exact = exact_displacement(c, half_view);
    if (!exact.empty()) curves.push_back(theory_curve("$theory", "exact, half-space"));
    return {{"displacement",
             "Tangential displacement of the surface (as figure 3.39 of the thesis)",
             "The last upright state. What has stuck since the load came is displaced as one, by "
             "the shift of the indenter. a and U_max are each model's own.",
             {640, 400, script_of(data + exact, "displacement u_x / U_{max}", half_view, curves)}}};
}

}  // namespace

std::vector<Plot> line_contact_plots(const contact::Case& c, const Histories& histories) {
    std::vector<Plot> plots;
    for (const auto maker : {turning_plot, displacement_plot})
        for (Plot& plot : maker(c, histories)) plots.push_back(std::move(plot));
    return plots;
}

}  // namespace tricontact::comparisons
