#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "comparisons/run/figures.h"
#include "contact/compliances/interior.h"
#include "report/format.h"
#include "theory/half_space_interior.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;
using contact::History;
using contact::Subsurface;

constexpr double map_half_width = 2;        // of the map, over a
constexpr double deepest = 3 * (1 + 1e-9);  // over a
constexpr int axis_points = 120;
constexpr double first_depth = 1e-3;  // of the theory's curve, over a

bool has_section(const History& history) {
    return history.subsurface && !history.subsurface->x.empty();
}

report::Figure section_figure(const History& history) {
    const Subsurface& s = *history.subsurface;
    const double a = history.scales.contact_radius, p0 = history.scales.peak_pressure;
    const double x = s.peak_position[0] / a, z = s.peak_position[2] / a;
    report::ContourMap map{.label = "von Mises / p_0", .x = {}, .y = {}, .values = {}};
    for (const double place : s.x)
        if (std::abs(place) <= map_half_width * a) map.x.push_back(place / a);
    for (std::size_t k = 0; k < s.z.size(); ++k) {
        if (s.z[k] < -deepest * a) continue;
        map.y.push_back(s.z[k] / a);
        for (std::size_t i = 0; i < s.x.size(); ++i)
            if (std::abs(s.x[i]) <= map_half_width * a)
                map.values.push_back(contact::von_mises(s.at(i, k)) / p0);
    }
    return {.id = "von_mises_" + history.model,
            .title = "Von Mises' stress below the contact, " + report::display_name(history.model),
            .caption =
                fmt::format("Section through the middle of the contact, the load along x. Largest "
                            "at the marker: {} p_0 at x = {} a, {} a below the surface.",
                            report::significant(s.peak_von_mises / p0, 3),
                            report::significant(x, 2), report::significant(-z, 2)),
            .x = {.label = "x/a"},
            .y = {.label = "height/a"},
            .curves = {{.name = "largest",
                        .x = {x},
                        .y = {z},
                        .kind = report::Curve::Kind::points,
                        .theory = true}},
            .map = map,
            .equal_scales = true};
}

/// Von Mises' stress and pressure -sigma_z over p0 down to a depth over a.
struct AxisCurves {
    report::Curve von_mises, pressure;

    AxisCurves(const std::string& name, std::optional<int> colour, bool theory)
        : von_mises{.name = "von Mises, " + name, .theory = theory, .colour = colour},
          pressure{.name = "−σ_z, " + name, .theory = true, .colour = colour} {}

    void add(double depth, const std::array<double, 6>& stress, double p0) {
        von_mises.add(contact::von_mises(stress) / p0, depth);
        pressure.add(-stress[2] / p0, depth);
    }
};

AxisCurves axis_curves(const History& history) {
    const Subsurface& s = *history.subsurface;
    const double a = history.scales.contact_radius;
    AxisCurves curves(report::display_name(history.model), report::model_style(history.model),
                      false);
    for (std::size_t k = s.z.size(); k-- > 0 && -s.z[k] <= deepest * a;)
        curves.add(-s.z[k] / a, s.at(s.axis(), k), history.scales.peak_pressure);
    return curves;
}

/// Below Hertz' frictionless contact with the half-space.
AxisCurves hertz_curves(const Case& c) {
    const auto hertz = contact::half_space_scales(c);
    const double a = hertz.contact_radius;
    const auto line_load = [&](double t) {  // E* (d - t^2/R), p0 = 2 E* a/(pi R)
        return std::numbers::pi / 2 * hertz.peak_pressure * (a - t) * (a + t) / a;
    };
    AxisCurves curves("Hertz", {}, true);
    for (int i = 0; i <= axis_points; ++i) {
        const double z = first_depth + (deepest - first_depth) * i / axis_points;
        const auto response = theory::axisymmetric_interior(c.substrate, line_load, a, 0, 0, z * a);
        std::array<double, 6> stress{};
        for (int k = 0; k < 6; ++k) stress[k] = response.stress[k][2];
        curves.add(z, stress, hertz.peak_pressure);
    }
    return curves;
}

report::Figure axis_figure(const Case& c, const Histories& histories) {
    const bool hertzian =
        c.indenter.shape == Case::Shape::paraboloid || c.indenter.shape == Case::Shape::sphere;
    report::Figure figure{
        .id = "axis_stress",
        .title = "Stress below the indenter's centre",
        .caption = "Depth downwards, each model over its own a and p_0" +
                   std::string(hertzian ? "; Hertz: the frictionless half-space." : "."),
        .x = {.label = "stress / p_0", .low = 0},
        .y = {.label = "depth / a", .low = 3, .high = 0}};
    const auto add = [&](const AxisCurves& curves) {
        figure.curves.insert(figure.curves.end(), {curves.von_mises, curves.pressure});
    };
    if (hertzian) add(hertz_curves(c));
    for (const History& history : histories)
        if (has_section(history)) add(axis_curves(history));
    return figure;
}

}  // namespace

Figures subsurface_figures(const Case& c, const Histories& histories) {
    Figures figures;
    for (const History& history : histories)
        if (has_section(history)) figures.push_back(section_figure(history));
    if (!figures.empty()) figures.push_back(axis_figure(c, histories));
    return figures;
}

}  // namespace tricontact::comparisons
