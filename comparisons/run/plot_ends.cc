#include <fmt/format.h>

#include <numbers>

#include "comparisons/half_space/roller_ends.h"
#include "comparisons/quantities/surface_fields.h"
#include "comparisons/run/plots.h"
#include "report/format.h"
#include "report/plot_style.h"
#include "theory/sharp_edge.h"

namespace tricontact::comparisons {

namespace {

/// Over those in the middle, by the distance from the end over a.
struct EndCurves {
    std::vector<double> distance, pressure, half_width;
};

EndCurves end_curves(const contact::Case& c, const contact::History& history) {
    EndCurves curves;
    const contact::Snapshot* last = last_upright(history);
    if (!last) return curves;
    const auto sections = roller_sections(last->surface, c.indenter.length);
    for (const RollerSection& s : sections) {
        if (!(s.distance > 0)) continue;  // the axis is logarithmic
        curves.distance.push_back(s.distance / history.scales.contact_radius);
        curves.pressure.push_back(s.pressure / sections.back().pressure);
        curves.half_width.push_back(s.half_width / sections.back().half_width);
    }
    return curves;
}

double edge_exponent(const contact::Case& c) {
    if (!c.indenter.material) return theory::edge_pressure_exponent(std::numbers::pi / 2, 1);
    const double roller = c.indenter.material->plane_compliance(),
                 substrate = c.substrate.plane_compliance();
    return theory::edge_pressure_exponent(std::numbers::pi / 2,
                                          (substrate - roller) / (substrate + roller));
}

bool has_sharp_ends(const contact::Case& c) {
    return c.indenter.chamfer == 0;
}

/// What is known of ends: flush ones, and sharp ones on a substrate that goes on.
std::string laws(const contact::Case& c) {
    const double nu = c.substrate.poisson, exponent = edge_exponent(c);
    std::string curves =
        fmt::format(", {:.6g} with lines dashtype 3 linecolor rgb '{}' title '1 - ν^2'",
                    1 - nu * nu, report::theory_colour);
    if (has_sharp_ends(c))
        curves += fmt::format(
            ", [0.01:0.5] (x/0.5)**({0:.6g}) with lines dashtype 2 linecolor rgb '{1}' title "
            "'slope of a sharp edge, {0:.2g}'",
            exponent, report::theory_colour);
    return curves;
}

}  // namespace

std::vector<Plot> end_plots(const contact::Case& c, const Histories& histories) {
    if (c.indenter.shape != contact::Case::Shape::roller) return {};
    std::string data, pressures, widths;
    for (std::size_t i = 0; i < histories.size(); ++i) {
        const EndCurves curves = end_curves(c, histories[i]);
        if (curves.distance.empty()) continue;
        data += report::data_block(fmt::format("$model{}", i),
                                   {curves.distance, curves.pressure, curves.half_width});
        const auto curve = [&](int column) {
            return fmt::format(
                "{}$model{} using 1:{} with linespoints pointtype {} pointsize 0.5 linewidth 1.5 "
                "linecolor rgb '{}' title '{}'",
                (column == 2 ? pressures : widths).empty() ? "" : ", ", i, column,
                report::model_marker(i), report::model_colour(i),
                report::display_name(histories[i].model));
        };
        pressures += curve(2);
        widths += curve(3);
    }
    if (pressures.empty()) return {};
    const std::string axes = data + report::plot_style() +
                             "set xlabel 'distance from the end, over a'\nset logscale x\n"
                             "set key top right\n";
    return {{"ends",
             "Pressure at the ends",
             std::string("Along the line of first contact, the last upright state. Dotted: plane "
                         "stress at the free face of a substrate that ends with the roller.") +
                 (has_sharp_ends(c) ? " Dashed, where the substrate goes on: the slope of the "
                                      "sharp edge's singularity, its height is free."
                                    : ""),
             {640, 420,
              axes + "set ylabel 'p over that in the middle'\nset logscale y\nplot " + pressures +
                  laws(c) + "\n"}},
            {"outline",
             "Half width of the contact at the ends",
             std::string("The last upright state.") +
                 (has_sharp_ends(c) ? " A dog-bone is wider at its ends than in the middle."
                                    : " Rounded ends close the contact."),
             {640, 380,
              axes + "set ylabel 'half width over that in the middle'\nplot " + widths + "\n"}}};
}

}  // namespace tricontact::comparisons
