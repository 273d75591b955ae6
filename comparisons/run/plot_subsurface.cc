#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "comparisons/run/plots.h"
#include "contact/solvers/interior.h"
#include "report/format.h"
#include "report/plot_style.h"
#include "theory/half_space_interior.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;
using contact::History;
using contact::Subsurface;

constexpr double map_half_width = 2;           // of the map, over a
constexpr double deepest = 3;                  // over a
constexpr int margins = 130, map_width = 400;  // of the map, above, below and across [pixels]
constexpr int axis_points = 120;
constexpr double first_depth = 1e-3;  // of the theory's curve, over a

bool has_section(const History& history) {
    return history.subsurface && !history.subsurface->x.empty();
}

/// Points (x/a, z/a, von Mises/p0) in rows.
std::string section_data(const Subsurface& s, double a, double p0) {
    fmt::memory_buffer text;
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "$section << EOD\n");
    for (std::size_t k = 0; k < s.z.size(); ++k) {
        if (s.z[k] < -deepest * a * (1 + 1e-9)) continue;
        for (std::size_t i = 0; i < s.x.size(); ++i)
            if (std::abs(s.x[i]) <= map_half_width * a)
                fmt::format_to(out, "{:.5g} {:.5g} {:.5g}\n", s.x[i] / a, s.z[k] / a,
                               contact::von_mises(s.at(i, k)) / p0);
        fmt::format_to(out, "\n");
    }
    fmt::format_to(out, "EOD\n");
    return fmt::to_string(text);
}

Plot section_plot(const History& history) {
    const Subsurface& s = *history.subsurface;
    const double a = history.scales.contact_radius, p0 = history.scales.peak_pressure;
    const double bottom = std::max(-deepest, s.z.front() / a);
    const double x = s.peak_position[0] / a, z = s.peak_position[2] / a;
    const std::string script =
        section_data(s, a, p0) + report::plot_style() +
        fmt::format(
            "unset key\nset border 15\nunset grid\nset pm3d map interpolate 2,2\n"
            // Viridis (van der Walt and Smith 2015), as in the maps of the surface.
            "set palette defined (0 '#440154', 1 '#46327e', 2 '#365c8d', 3 '#277f8e', "
            "4 '#1fa187', 5 '#4ac16d', 6 '#a0da39', 7 '#fde725')\n"
            "set xrange [-{0}:{0}]\nset yrange [{1:.4g}:0]\nset cbrange [0:*]\n"
            "set size ratio {2:.4g}\nset xlabel 'x/a'\nset ylabel 'z/a' offset -1,0\n"
            "set cblabel 'von Mises / p_0'\n"
            "set label 1 '' at {3:.5g},{4:.5g},0 point pointtype 1 pointsize 1.4 linecolor rgb "
            "'#000000' front\n"
            "splot $section using 1:2:3 with pm3d\n",
            map_half_width, bottom, -bottom / (2 * map_half_width), x, z);
    return {"von_mises_" + history.model,
            "Von Mises' stress below the contact, " + report::display_name(history.model),
            fmt::format("Section through the middle of the contact, the load along x. Largest at "
                        "the cross: {} p_0 at x = {} a, z = {} a.",
                        report::significant(s.peak_von_mises / p0, 3), report::significant(x, 2),
                        report::significant(z, 2)),
            {600, margins + static_cast<int>(map_width * -bottom / (2 * map_half_width)), script},
            report::ImageFormat::png};
}

/// Depth over a, von Mises' stress and pressure -sigma_z over p0.
using AxisCurve = std::vector<std::vector<double>>;

AxisCurve axis_curve(const History& history) {
    const Subsurface& s = *history.subsurface;
    const double a = history.scales.contact_radius, p0 = history.scales.peak_pressure;
    AxisCurve curve(3);
    for (std::size_t k = s.z.size(); k-- > 0;) {
        if (-s.z[k] > deepest * a * (1 + 1e-9)) break;
        const auto& stress = s.at(s.axis(), k);
        curve[0].push_back(-s.z[k] / a);
        curve[1].push_back(contact::von_mises(stress) / p0);
        curve[2].push_back(-stress[2] / p0);
    }
    return curve;
}

/// Below Hertz' frictionless contact with the half-space.
AxisCurve hertz_curve(const Case& c) {
    const auto hertz = contact::half_space_scales(c);
    const double a = hertz.contact_radius;
    const auto line_load = [&](double t) {  // E* (d - t^2/R), p0 = 2 E* a/(pi R)
        return std::numbers::pi / 2 * hertz.peak_pressure * (a - t) * (a + t) / a;
    };
    AxisCurve curve(3);
    for (int i = 0; i <= axis_points; ++i) {
        const double z = first_depth + (deepest - first_depth) * i / axis_points;
        const auto response = theory::axisymmetric_interior(c.substrate, line_load, a, 0, 0, z * a);
        std::array<double, 6> stress{};
        for (int k = 0; k < 6; ++k) stress[k] = response.stress[k][2];
        curve[0].push_back(z);
        curve[1].push_back(contact::von_mises(stress) / hertz.peak_pressure);
        curve[2].push_back(-stress[2] / hertz.peak_pressure);
    }
    return curve;
}

bool is_hertzian(const Case& c) {
    return c.indenter.shape == Case::Shape::paraboloid || c.indenter.shape == Case::Shape::sphere;
}

std::string line(const std::string& data, int column, const std::string& colour, int dash,
                 const std::string& title) {
    return fmt::format(
        "{} using {}:1 with lines linewidth 2 dashtype {} linecolor rgb '{}' title '{}'", data,
        column, dash, colour, title);
}

Plot axis_plot(const Case& c, const Histories& histories) {
    std::string script;
    std::vector<std::string> lines;
    const auto add = [&](const AxisCurve& curve, const std::string& colour,
                         const std::string& name) {
        const std::string data = fmt::format("$axis{}", lines.size());
        script += report::data_block(data, curve);
        lines.push_back(line(data, 2, colour, 1, "von Mises, " + name));
        lines.push_back(line(data, 3, colour, 2, "−σ_z, " + name));
    };
    if (is_hertzian(c)) add(hertz_curve(c), report::theory_colour, "Hertz");
    for (std::size_t i = 0; i < histories.size(); ++i)
        if (has_section(histories[i]))
            add(axis_curve(histories[i]), report::model_colour(i),
                report::display_name(histories[i].model));
    script +=
        report::plot_style() + fmt::format(
                                   "set key outside right\nset xrange [0:*]\nset yrange [{}:0]\n"
                                   "set xlabel 'stress / p_0'\nset ylabel 'depth / a'\nplot {}\n",
                                   deepest, fmt::join(lines, ", "));
    return {"axis_stress",
            "Stress below the indenter's centre",
            "Depth downwards, each model over its own a and p_0" +
                std::string(is_hertzian(c) ? "; Hertz: the frictionless half-space." : "."),
            {720, 420, script}};
}

}  // namespace

std::vector<Plot> subsurface_plots(const Case& c, const Histories& histories) {
    std::vector<Plot> plots;
    for (const History& history : histories)
        if (has_section(history)) plots.push_back(section_plot(history));
    if (!plots.empty()) plots.push_back(axis_plot(c, histories));
    return plots;
}

}  // namespace tricontact::comparisons
