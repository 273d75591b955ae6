#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "comparisons/run/plots.h"
#include "contact/bodies/half_space_scales.h"
#include "contact/bodies/height_spectrum.h"
#include "report/format.h"
#include "report/plot_style.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;
using contact::History;

constexpr std::size_t most_spectrum_points = 600;  // of the spectrum

std::string logarithmic() {
    return "set logscale xy\nset format '10^{%T}'\nset mxtics 10\nset mytics 10\n";
}

Plot spectrum_plot(const Case& c) {
    const contact::HeightSpectrum whole = surface_spectrum(c);
    std::vector<double> q, measured;
    for (const std::size_t i : report::thinned(whole.wave_number.size(), most_spectrum_points))
        if (whole.density[i] > 0) {
            q.push_back(whole.wave_number[i]);
            measured.push_back(whole.density[i]);
        }
    const bool prescribed = c.indenter.roughness && !c.indenter.height_map;
    std::vector<std::vector<double>> columns{q, measured};
    std::string lines = fmt::format(
        "$spectrum using 1:2 with points pointtype 7 pointsize 0.5 linecolor rgb '{}' title "
        "'{}'",
        report::model_colour(1), c.indenter.height_map ? "the map" : "the cells");
    if (prescribed) {
        columns.push_back(spectral_density(*c.indenter.roughness, q));
        // Waves that are not there have no place on a logarithmic axis; what cells make of them
        // has.
        const double least =
            1e-3 * *std::min_element(columns[2].begin(), columns[2].end(), [](double a, double b) {
                return (a > 0 ? a : INFINITY) < (b > 0 ? b : INFINITY);
            });
        for (std::size_t i = 0; i < q.size(); ++i)
            if (measured[i] < least) columns[1][i] = NAN;
        for (double& density : columns[2])
            if (density == 0) density = NAN;
        lines += fmt::format(
            ", $spectrum using 1:3 with lines linewidth 2 linecolor rgb '{}' title 'prescribed'",
            report::theory_colour);
    }
    const std::string script = report::data_block("$spectrum", columns) + report::plot_style() +
                               logarithmic() +
                               "set key top right\nset xlabel 'wave number q [1/m]'\n"
                               "set ylabel 'C(q) [m^4]'\nplot " +
                               lines + "\n";
    return {"spectrum",
            "Power spectral density of the surface",
            "Mean over all directions, ∫ C d²q being the mean square of the heights." +
                std::string(prescribed ? " Points: of the heights that the cells see." : ""),
            {640, 420, script}};
}

/// Nominal pressure over E* h' and contact area over the nominal one, while the case is pressed.
struct AreaCurve {
    std::vector<double> pressure, area;
};

AreaCurve area_curve(const Case& c, const History& history) {
    const double nominal = contact::nominal_area(c);
    const double full = 2 * contact::half_space_scales(c).peak_pressure;  // E* h'
    AreaCurve curve;
    for (const contact::StepRecord& step : history.steps) {
        if (step.phase > 0) break;
        if (!(step.contact_area > 0)) continue;
        curve.pressure.push_back(step.normal_force / nominal / full);
        curve.area.push_back(step.contact_area / nominal);
    }
    return curve;
}

/// Lines of both theories, by E* h' over the nominal pressure.
std::string theories() {
    return fmt::format(
        "sqrt(2*pi)*x with lines dashtype 2 linewidth 1.5 linecolor rgb '{0}' title 'Bush, "
        "Gibson, Thomas', erf(sqrt(2)*x) with lines dashtype 3 linewidth 1.5 linecolor rgb '{0}' "
        "title 'Persson'",
        report::theory_colour);
}

Plot area_plot(const Case& c, const Histories& histories) {
    std::string data, curves, factors;
    double lowest = INFINITY, highest = 0;
    for (std::size_t i = 0; i < histories.size(); ++i) {
        const AreaCurve curve = area_curve(c, histories[i]);
        if (curve.pressure.empty()) continue;
        const auto [low, high] = std::minmax_element(curve.pressure.begin(), curve.pressure.end());
        lowest = std::min(lowest, *low);
        highest = std::max(highest, *high);
        const std::string name = fmt::format("$area{}", i);
        data += report::data_block(name, {curve.pressure, curve.area});
        curves += fmt::format(
            ", {} with linespoints pointtype {} pointsize 0.8 linewidth 1.5 linecolor rgb '{}' "
            "title '{}'",
            name, report::model_marker(i), report::model_colour(i),
            report::display_name(histories[i].model));
        factors += fmt::format("{}{} for {}", factors.empty() ? "" : ", ",
                               report::significant(curve.area.back() / curve.pressure.back(), 3),
                               report::display_name(histories[i].model));
    }
    const std::string script =
        data + report::plot_style() + logarithmic() +
        fmt::format(
            "set key bottom right\nset xlabel \"p/(E^* h')\"\nset ylabel 'contact area, "
            "over the nominal one'\nset xrange [{:.6g}:{:.6g}]\nplot ",
            lowest / 2, 2 * highest) +
        theories() + curves + "\n";
    return {"contact_area",
            "Contact area over load",
            fmt::format("Pressing, before F_T acts; p is the nominal pressure, h' the rms slope. "
                        "κ = (area/nominal area) E* h'/p, at the last point {}; light contact of "
                        "the half-space has √(2π) = 2.51 by Bush, Gibson and Thomas, √(8/π) = 1.60 "
                        "by Persson. Whole cells are counted, half a cell too much along all "
                        "edges of contact.",
                        factors),
            {640, 420, script}};
}

}  // namespace

std::vector<Plot> rough_plots(const Case& c, const Histories& histories) {
    const bool flat = contact::is_nominally_flat(c);
    if (!flat && !c.indenter.roughness) return {};
    std::vector<Plot> plots{spectrum_plot(c)};
    const bool pressed = std::any_of(histories.begin(), histories.end(), [&](const auto& history) {
        return flat && !area_curve(c, history).pressure.empty();
    });
    if (pressed) plots.push_back(area_plot(c, histories));
    return plots;
}

}  // namespace tricontact::comparisons
