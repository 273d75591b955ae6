#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "comparisons/format.h"
#include "comparisons/plot_style.h"
#include "comparisons/plots.h"
#include "comparisons/surface_fields.h"
#include "theory/sharp_edge.h"

namespace tricontact::comparisons {

namespace {

/// Pressure over that in the middle of a roller, by the distance from its end over a.
struct EndCurve {
    std::vector<double> distance, pressure;
};

EndCurve end_curve(const contact::Case& c, const contact::History& history) {
    const CentreLine line = centre_line(history, c.friction_coefficient, Axis::y);
    EndCurve curve;
    double middle = 0, nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < line.position.size(); ++i)
        if (std::abs(line.position[i]) < nearest) {
            nearest = std::abs(line.position[i]);
            middle = line.bound[i];
        }
    for (std::size_t i = 0; i < line.position.size(); ++i) {
        const double end = c.indenter.length / 2 / history.scales.contact_radius;
        if (line.position[i] <= 0 || !(line.position[i] < end) || !(line.bound[i] > 0)) continue;
        curve.distance.push_back(end - line.position[i]);
        curve.pressure.push_back(line.bound[i] / middle);
    }
    return curve;
}

double edge_exponent(const contact::Case& c) {
    if (!c.indenter.material) return theory::edge_pressure_exponent(std::numbers::pi / 2, 1);
    const double roller = c.indenter.material->plane_compliance(),
                 substrate = c.substrate.plane_compliance();
    return theory::edge_pressure_exponent(std::numbers::pi / 2,
                                          (substrate - roller) / (substrate + roller));
}

/// What is known of ends: flush ones, and sharp ones on a substrate that goes on.
std::string laws(const contact::Case& c) {
    const double nu = c.substrate.poisson, exponent = edge_exponent(c);
    std::string curves =
        fmt::format(", {:.6g} with lines dashtype 3 linecolor rgb '{}' title '1 - ν^2'",
                    1 - nu * nu, theory_colour);
    if (c.indenter.chamfer == 0)
        curves += fmt::format(
            ", [0.01:0.5] (x/0.5)**({0:.6g}) with lines dashtype 2 linecolor rgb '{1}' title "
            "'slope of a sharp edge, {0:.2f}'",
            exponent, theory_colour);
    return curves;
}

}  // namespace

std::vector<Plot> end_plots(const contact::Case& c, const Histories& histories) {
    if (c.indenter.shape != contact::Case::Shape::roller) return {};
    std::string data, curves;
    for (std::size_t i = 0; i < histories.size(); ++i) {
        const EndCurve curve = end_curve(c, histories[i]);
        if (curve.distance.empty()) continue;
        data += data_block(fmt::format("$model{}", i), {curve.distance, curve.pressure});
        curves += fmt::format(
            "{}$model{} with linespoints pointtype {} pointsize 0.5 linewidth 1.5 linecolor rgb "
            "'{}' title '{}'",
            curves.empty() ? "" : ", ", i, model_marker(i), model_colour(i),
            display_name(histories[i].model));
    }
    if (curves.empty()) return {};
    const std::string script = data + plot_style() +
                               "set xlabel 'distance from the end, over a'\n"
                               "set ylabel 'p over that in the middle'\n"
                               "set logscale xy\nset key top right\nplot " +
                               curves + laws(c) + "\n";
    return {{"ends",
             "Pressure at the ends",
             "Along the line of first contact, the last upright state. Dotted: plane stress at the "
             "free face of a substrate that ends with the roller. Dashed, of sharp ends on a "
             "substrate that goes on: the slope of the edge's singularity, its height is free.",
             {640, 420, script}}};
}

}  // namespace tricontact::comparisons
