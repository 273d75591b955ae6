#include <algorithm>
#include <array>
#include <cmath>

#include "comparisons/quantities/reference.h"
#include "comparisons/quantities/surface_fields.h"
#include "comparisons/run/figures.h"
#include "contact/half_space_scales.h"
#include "theory/oscillating_cylinder.h"

namespace tricontact::comparisons {

namespace {

using contact::Surface;

constexpr std::size_t most_line_points = 400;  // per curve: more than the picture resolves
constexpr int exact_points = 200;
constexpr double margin = 1.12;  // of the figure beside the path

/// Half width of the figure, over a: all that the contact passes.
double view(const Histories& histories) {
    double w = 0;
    for (const contact::History& history : histories) w = std::max(w, amplitude_ratio(history));
    return margin * (1 + w);
}

/// Adds a curve of a field over `unit` on the row's points, positions over a, within the figure.
void add_row(const contact::History& history, const Surface& s, std::vector<double> Surface::*field,
             double unit, report::Figure& figure) {
    report::Curve& curve = figure.curves.emplace_back(curve_of(history));
    for (const std::size_t k : report::thinned(s.size(), most_line_points)) {
        const double x = s.x(static_cast<int>(k)) / history.scales.contact_radius;
        if (std::abs(x) <= *figure.x.high) curve.add(x, (s.*field)[k] / unit);
    }
}

report::Figure turning_figure(const contact::Case& c, const Histories& histories) {
    constexpr std::array<double, 2> before_upright{0.75, 0.25};  // turning points, in periods
    const double half_view = view(histories);
    report::Figure figure{
        .id = "turning_points",
        .title = "Pressure at the turning points (as figure 3.38 (a) of the thesis)",
        .caption =
            "In the last period, positions on the substrate. What lies under both curves is in "
            "contact throughout; the lower of them bounds the traction that can stay.",
        .x = {.label = "position x/a", .low = -half_view, .high = half_view},
        .y = {"pressure p / p_0"}};
    for (std::size_t i = 0; i < histories.size(); ++i) {
        const contact::Snapshot* last = last_upright(histories[i]);
        if (!last) continue;
        for (const double before : before_upright)
            if (const auto* turn = snapshot_at(histories[i], last->phase - before))
                add_row(histories[i], turn->surface, &Surface::normal_traction,
                        histories[i].scales.peak_pressure, figure);
    }
    if (figure.curves.empty() || !constant_loads(c)) return figure;
    const double w = reference(c).amplitude_ratio;
    for (const double turn : {-w, w})
        figure.curves.emplace_back(report::Curve{.name = "Hertz (3.5.15)", .theory = true})
            .sample(-half_view, half_view, exact_points,
                    [&](double x) { return std::sqrt(std::max(0., 1 - (x - turn) * (x - turn))); });
    return figure;
}

/// With u_x/U_max of the half-space, where it is known.
report::Figure displacement_figure(const contact::Case& c, const Histories& histories) {
    const double half_view = view(histories);
    report::Figure figure{
        .id = "displacement",
        .title = "Tangential displacement of the surface (as figure 3.39 of the thesis)",
        .caption =
            "The last upright state. What has stuck since the load came is displaced as one, by "
            "the shift of the indenter. a and U_max are each model's own.",
        .x = {.label = "position x/a", .low = -half_view, .high = half_view},
        .y = {"displacement u_x / U_max"}};
    for (std::size_t i = 0; i < histories.size(); ++i)
        if (const contact::Snapshot* last = last_upright(histories[i]))
            add_row(histories[i], last->surface, &Surface::displacement_x,
                    histories[i].scales.unit_shift, figure);
    const Reference r = reference(c);
    if (figure.curves.empty() || !(r.stick_ratio > 0.)) return figure;
    const double lambda = contact::line_shift_factor(c);
    figure.curves.emplace_back(report::Curve{.name = "exact, half-space", .theory = true})
        .sample(-half_view, half_view, exact_points, [&](double x) {
            return theory::line_shakedown_displacement(x, r.amplitude_ratio, *r.stick_ratio,
                                                       lambda);
        });
    return figure;
}

}  // namespace

Figures line_contact_figures(const contact::Case& c, const Histories& histories) {
    Figures figures{turning_figure(c, histories), displacement_figure(c, histories)};
    std::erase_if(figures, [](const report::Figure& figure) { return figure.curves.empty(); });
    return figures;
}

}  // namespace tricontact::comparisons
