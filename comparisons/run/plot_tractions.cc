#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "comparisons/quantities/reference.h"
#include "comparisons/quantities/surface_fields.h"
#include "comparisons/run/plots.h"
#include "report/format.h"
#include "report/plot_style.h"
#include "theory/cattaneo_mindlin.h"
#include "theory/oscillating_cylinder.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::comparisons {

namespace {

using contact::History;

constexpr std::size_t most_points = 400;  // per curve: more than the picture resolves
constexpr int theory_points = 400;
constexpr double plot_half_width = 1.12;  // of the plot, over a

std::string curve_data(const std::string& name, const CentreLine& line) {
    std::vector<std::vector<double>> columns(3);
    for (const std::size_t i : report::thinned(line.position.size(), most_points)) {
        if (std::abs(line.position[i]) > plot_half_width) continue;
        columns[0].push_back(line.position[i]);
        columns[1].push_back(line.traction[i]);
        columns[2].push_back(line.bound[i]);
    }
    return report::data_block(name, columns);
}

/// A function of x/a, sampled.
template <class F>
std::string function_data(const std::string& name, const F& function) {
    std::vector<std::vector<double>> columns(2);
    for (int i = 0; i <= theory_points; ++i) {
        const double x = plot_half_width * (2.0 * i / theory_points - 1);
        columns[0].push_back(x);
        columns[1].push_back(function(std::abs(x)));
    }
    return report::data_block(name, columns);
}

/// Least Hertzian bound p/p0 at `position` on an axis at `angle` to the rolling: whichever turning
/// point is farther.
double least_bound(double position, double w, double angle) {
    const double r2 = position * position + w * w + 2 * std::abs(position * w * std::cos(angle));
    return r2 < 1 ? std::sqrt(1 - r2) : 0;
}

std::string zone_fill(Zone zone) {
    switch (zone) {
        case Zone::stick:
            return report::zone_colour::stick;
        case Zone::slip:
            return report::zone_colour::slip;
        case Zone::zero:
            return report::zone_colour::zero;
        case Zone::open:
            break;
    }
    return report::zone_colour::open;
}

/// Traction vanishes for good on released points only after shakedown.
const char* zone_name(Zone zone, bool shaken_down) {
    switch (zone) {
        case Zone::stick:
            return "stick";
        case Zone::slip:
            return "slip";
        case Zone::zero:
            return shaken_down ? "zero" : "released";
        case Zone::open:
            break;
    }
    return "";
}

constexpr double strip_pitch = 0.105;  // of the axis of the traction

/// Where the strips begin: below the curves, which coupling may take below zero.
double strip_top(const std::vector<CentreLine>& lines) {
    double least = 0;
    for (const CentreLine& line : lines)
        for (const double traction : line.traction) least = std::min(least, traction);
    return least - 0.06;
}

/// One strip per model under the curves, a box per zone with its name where it fits.
std::string zone_strip(std::size_t row, double first, const History& history,
                       const CentreLine& line) {
    constexpr double height = 0.085, letter_width = 0.042;
    const double top = first - strip_pitch * static_cast<double>(row), bottom = top - height;
    std::string script = fmt::format(
        "set label '{}' at graph -0.015, first {:.4g} right textcolor rgb '{}'\n",
        report::display_name(history.model), (top + bottom) / 2, report::model_colour(row));
    for (const Stretch& stretch : stretches(line)) {
        if (stretch.zone == Zone::open) continue;
        script += fmt::format(
            "set object rectangle from {:.5g},{:.4g} to {:.5g},{:.4g} fillcolor rgb '{}' "
            "fillstyle solid border linecolor rgb '#ffffff' front\n",
            stretch.begin, bottom, stretch.end, top, zone_fill(stretch.zone));
        const std::string name =
            zone_name(stretch.zone, history.verdict.state == contact::State::shakedown);
        if (stretch.end - stretch.begin < letter_width * static_cast<double>(name.size())) continue;
        script += fmt::format("set label '{}' at {:.5g},{:.4g} center front textcolor rgb '{}'\n",
                              name, (stretch.begin + stretch.end) / 2, (top + bottom) / 2,
                              stretch.zone == Zone::stick ? "#ffffff" : "#111111");
    }
    return script;
}

/// What makes up the picture: inline data, commands before the plot, and its curves.
struct Parts {
    std::string data, strips, curves;
    std::size_t models = 0;
    double bottom = 0;  // of the picture

    void add_curve(const std::string& curve) { curves += (curves.empty() ? "" : ", ") + curve; }
};

void add_models(const contact::Case& c, const Histories& histories, Axis axis, Parts& parts) {
    std::vector<CentreLine> lines;
    for (const History& history : histories)
        lines.push_back(centre_line(history, c.friction_coefficient, axis));
    const double top = strip_top(lines);
    for (std::size_t k = 0; k < lines.size(); ++k) {
        const History& history = histories[k];
        if (lines[k].position.empty()) continue;
        const std::size_t i = parts.models++;
        parts.data += curve_data(fmt::format("$model{}", i), lines[k]);
        parts.strips += zone_strip(i, top, history, lines[k]);
        parts.add_curve(fmt::format(
            "$model{0} using 1:2 with lines linewidth 2 linecolor rgb '{1}' title '{2}'", i,
            report::model_colour(i), report::display_name(history.model)));
    }
    parts.bottom = top - 0.01 - strip_pitch * static_cast<double>(parts.models);
}

void add_bounds(const contact::Case& c, const Reference& r, Axis axis, Parts& parts) {
    if (!contact::is_hertz_round(c) && !c.is_cylindrical()) return;
    parts.data += function_data("$bound", [](double x) { return least_bound(x, 0, 0); });
    parts.add_curve(
        "$bound with lines linewidth 1 linecolor rgb '#888888' title 'bound μp, upright'");
    if (!c.rolling || !constant_loads(c)) return;
    const double angle =
        axis == Axis::x ? c.rolling->angle : std::numbers::pi / 2 - c.rolling->angle;
    parts.data +=
        function_data("$least", [&](double x) { return least_bound(x, r.amplitude_ratio, angle); });
    parts.add_curve(
        "$least with lines dashtype 3 linewidth 1.2 linecolor rgb '#888888' title "
        "'least μp of a period'");
}

/// The closed form for the state drawn, if there is one.
void add_theory(const contact::Case& c, const Reference& r, Parts& parts) {
    const double f = r.tangential_ratio;
    if (!in_unit_range(f) || f == 0 || !contact::is_hertz_round(c)) return;
    std::string title;
    if (!c.rolling) {
        title = "Cattaneo–Mindlin";
        parts.data += function_data(
            "$theory", [&](double x) { return theory::cattaneo_mindlin_traction(x, f); });
    } else if (r.shakedown_shift_ratio) {
        title = "MDR closed form";
        parts.data += function_data("$theory", [&](double x) {
            return theory::mdr_shakedown_traction(x, r.amplitude_ratio, *r.shakedown_shift_ratio);
        });
    }
    if (!title.empty())
        parts.add_curve(
            fmt::format("$theory with lines dashtype 2 linewidth 1.4 linecolor rgb '{}' title '{}'",
                        report::theory_colour, title));
}

/// The same of a line contact; w = 0 is Cattaneo's.
void add_line_theory(const contact::Case& c, const Reference& r, Parts& parts) {
    const auto stick = c.rolling ? r.stick_ratio
                       : in_unit_range(r.tangential_ratio)
                           ? theory::line_stick_half_width(0, r.tangential_ratio)
                           : std::nullopt;
    if (!stick) return;
    parts.data += function_data("$theory", [&](double x) {
        return theory::line_shakedown_traction(x, r.amplitude_ratio, *stick);
    });
    parts.add_curve(
        fmt::format("$theory with lines dashtype 2 linewidth 1.4 linecolor rgb '{}' title "
                    "'exact, half-space'",
                    report::theory_colour));
    const bool ellipses = c.rolling && r.amplitude_ratio + *stick < 1;
    const auto of_thesis =
        ellipses ? theory::thesis_line_stick_half_width(r.amplitude_ratio, r.tangential_ratio)
                 : std::nullopt;
    if (!of_thesis) return;
    parts.data += function_data("$thesis", [&](double x) {
        return theory::thesis_line_traction(x, r.amplitude_ratio, *of_thesis);
    });
    parts.add_curve(
        "$thesis with lines dashtype 4 linewidth 1 linecolor rgb '#555555' title "
        "'thesis (3.5.22)'");
}

std::vector<Plot> traction_plot(const contact::Case& c, const Histories& histories, Axis axis) {
    const Reference r = reference(c);
    Parts parts;
    add_models(c, histories, axis, parts);
    if (parts.models == 0) return {};
    add_bounds(c, r, axis, parts);
    if (c.is_line_contact())
        add_line_theory(c, r, parts);
    else
        add_theory(c, r, parts);
    const char* letter = axis == Axis::x ? "x" : "y";
    // The axis' name stands beside the curves, above the names of the strips.
    const double strips_share = -parts.bottom / (1.03 - parts.bottom);
    const int height = 460 + 28 * std::max(0, static_cast<int>(parts.models) - 3);
    const std::string script =
        parts.data + report::plot_style() + parts.strips +
        fmt::format(
            "set xlabel 'position {0}/a'\n"
            "set ylabel 'traction τ_x / (μ p_0)' offset 0,graph {4:.3f}\n"
            "set xrange [-{1}:{1}]\nset yrange [{2:.4g}:1.03<*] noextend\n"
            "set xtics 0.5\nset ytics 0,0.2\n"
            "set key outside top center horizontal maxcols 3 samplen 1.6 width -3\n"
            "set lmargin 9\nplot {3}\n",
            letter, plot_half_width, parts.bottom, parts.curves, strips_share / 2);
    return {{fmt::format("traction_{}", letter),
             fmt::format("Traction on the centre line along {}", letter),
             "The last upright state. Strips: what each point does during the last period. Black, "
             "stick: always in contact, below the friction bound; grey, slip: at the bound μp at "
             "some instant; light, zero or released: out of contact at some instant, after "
             "shakedown no traction is left there (in coupled contact what the pressure drags). a "
             "and p₀ are each model's own.",
             {640, height, script}}};
}

}  // namespace

std::vector<Plot> traction_plots(const contact::Case& c, const Histories& histories) {
    std::vector<Plot> plots;
    for (const Axis axis : {Axis::x, Axis::y}) {
        if (axis == Axis::y && c.is_line_contact()) continue;  // uniform
        for (Plot& plot : traction_plot(c, histories, axis)) plots.push_back(std::move(plot));
    }
    return plots;
}

}  // namespace tricontact::comparisons
