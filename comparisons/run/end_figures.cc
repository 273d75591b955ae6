#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "comparisons/quantities/roller_ends.h"
#include "comparisons/quantities/surface_fields.h"
#include "comparisons/run/figures.h"
#include "theory/sharp_edge.h"

namespace tricontact::comparisons {

namespace {

double edge_exponent(const contact::Case& c) {
    if (!c.indenter.material) return theory::edge_pressure_exponent(std::numbers::pi / 2, 1);
    const double roller = c.indenter.material->plane_compliance(),
                 substrate = c.substrate.plane_compliance();
    return theory::edge_pressure_exponent(std::numbers::pi / 2,
                                          (substrate - roller) / (substrate + roller));
}

/// Adds what is known of ends: flush ones, and sharp ones on a substrate that goes on.
void add_laws(const contact::Case& c, double nearest, double farthest, report::Figure& figure) {
    const double nu = c.substrate.poisson, exponent = edge_exponent(c);
    constexpr double first = 0.01, last = 0.5;  // over a
    constexpr int n = 20;
    if (c.indenter.chamfer == 0)
        figure.curves
            .emplace_back(report::Curve{
                .name = fmt::format("slope of a sharp edge, {:.2g}", exponent), .theory = true})
            .sample_decades(first, last, n, [&](double x) { return std::pow(x / last, exponent); });
    figure.curves.push_back({.name = "1 − ν^2",
                             .x = {nearest, farthest},
                             .y = {1 - nu * nu, 1 - nu * nu},
                             .theory = true});
}

}  // namespace

Figures end_figures(const contact::Case& c, const Histories& histories) {
    if (c.indenter.shape != contact::Case::Shape::roller) return {};
    const bool sharp = c.indenter.chamfer == 0;
    const report::FigureAxis distance{"distance from the end, over a", true};
    report::Figure pressure{
        .id = "ends",
        .title = "Pressure at the ends",
        .caption =
            std::string("Along the line of first contact, the last upright state. 1 − ν^2: plane "
                        "stress at the free face of a substrate that ends with the roller.") +
            (sharp ? " Where the substrate goes on: the slope of the sharp edge's singularity, its "
                     "height is free."
                   : ""),
        .x = distance,
        .y = {"p over that in the middle", true}};
    report::Figure width{.id = "outline",
                         .title = "Half width of the contact at the ends",
                         .caption = std::string("The last upright state.") +
                                    (sharp ? " A dog-bone is wider at its ends than in the middle."
                                           : " Rounded ends close the contact."),
                         .x = distance,
                         .y = {"half width over that in the middle"}};
    double nearest = INFINITY, farthest = 0;
    for (std::size_t i = 0; i < histories.size(); ++i) {
        const contact::Snapshot* last = last_upright(histories[i]);
        if (!last) continue;
        report::Curve pressures = curve_of(histories[i]), widths = pressures;
        pressures.kind = widths.kind = report::Curve::Kind::line_and_points;
        const auto sections = roller_sections(last->surface, c.indenter.length);
        for (const RollerSection& s : sections) {
            if (!(s.distance > 0)) continue;  // the axis is logarithmic
            const double x = s.distance / histories[i].scales.contact_radius;
            pressures.add(x, s.pressure / sections.back().pressure);
            widths.add(x, s.half_width / sections.back().half_width);
            nearest = std::min(nearest, x);
            farthest = std::max(farthest, x);
        }
        if (pressures.x.empty()) continue;
        pressure.curves.push_back(pressures);
        width.curves.push_back(widths);
    }
    if (pressure.curves.empty()) return {};
    add_laws(c, nearest, farthest, pressure);
    return {pressure, width};
}

}  // namespace tricontact::comparisons
