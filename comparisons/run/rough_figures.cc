#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "comparisons/run/figures.h"
#include "contact/half_space_scales.h"
#include "contact/height_spectrum.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;
using contact::History;

constexpr std::size_t most_spectrum_points = 600;

report::Figure spectrum_figure(const Case& c) {
    const bool prescribed = c.indenter.roughness && !c.indenter.height_map;
    report::Figure figure{
        .id = "spectrum",
        .title = "Power spectral density of the surface",
        .caption = "Mean over all directions, ∫ C d²q being the mean square of the heights." +
                   std::string(prescribed ? " Points: of the heights that the cells see." : ""),
        .x = {"wave number q [1/m]", true},
        .y = {"C(q) [m^4]", true}};
    const contact::HeightSpectrum whole = surface_spectrum(c);
    report::Curve measured{.name = c.indenter.height_map ? "the map" : "the cells",
                           .kind = report::Curve::Kind::points,
                           .colour = 1};
    for (const std::size_t i : report::thinned(whole.wave_number.size(), most_spectrum_points))
        if (whole.density[i] > 0) measured.add(whole.wave_number[i], whole.density[i]);
    figure.curves = {measured};
    if (!prescribed) return figure;
    report::Curve& law = figure.curves.emplace_back(
        report::Curve{.name = "prescribed", .x = measured.x, .theory = true});
    law.y = spectral_density(*c.indenter.roughness, law.x);
    // Waves that are not there have no place on a logarithmic axis; what cells make of them has.
    const double least = 1e-3 * *std::ranges::min_element(law.y, {}, [](double density) {
                             return density > 0 ? density : INFINITY;
                         });
    for (double& density : figure.curves.front().y)
        if (density < least) density = NAN;
    for (double& density : law.y)
        if (density == 0) density = NAN;
    return figure;
}

/// Nominal pressure over E* h' and contact area over the nominal one, while the case is pressed.
report::Curve area_curve(const Case& c, const History& history) {
    const double nominal = contact::nominal_area(c);
    const double full = 2 * contact::half_space_scales(c).peak_pressure;  // E* h'
    report::Curve curve = curve_of(history);
    curve.kind = report::Curve::Kind::line_and_points;
    for (const contact::StepRecord& step : history.steps) {
        if (step.phase > 0) break;
        if (step.contact_area > 0)
            curve.add(step.normal_force / nominal / full, step.contact_area / nominal);
    }
    return curve;
}

/// Adds both theories, by the nominal pressure over E* h'.
void add_theories(report::Figure& figure) {
    const auto add = [&](const char* name, const auto& area) {
        figure.curves.emplace_back(report::Curve{.name = name, .theory = true})
            .sample_decades(*figure.x.low, *figure.x.high, 60, area);
    };
    add("Bush, Gibson, Thomas", [](double x) { return std::sqrt(2 * std::numbers::pi) * x; });
    add("Persson", [](double x) { return std::erf(std::numbers::sqrt2 * x); });
}

/// Without curves where nothing was pressed step by step.
report::Figure area_figure(const Case& c, const Histories& histories) {
    report::Figure figure{.id = "contact_area",
                          .title = "Contact area over load",
                          .x = {"p/(E* h')", true},
                          .y = {"contact area, over the nominal one", true}};
    std::vector<std::string> factors;
    double lowest = INFINITY, highest = 0;
    for (std::size_t i = 0; i < histories.size(); ++i) {
        const report::Curve curve = area_curve(c, histories[i]);
        if (curve.x.empty()) continue;
        const auto [low, high] = std::ranges::minmax(curve.x);
        lowest = std::min(lowest, low);
        highest = std::max(highest, high);
        factors.push_back(report::significant(curve.y.back() / curve.x.back(), 3) + " for " +
                          curve.name);
        figure.curves.push_back(curve);
    }
    if (figure.curves.empty()) return figure;
    figure.x.low = lowest / 2;
    figure.x.high = 2 * highest;
    add_theories(figure);
    figure.caption = fmt::format(
        "Pressing, before F_T acts; p is the nominal pressure, h' the rms slope. κ = "
        "(area/nominal area) E* h'/p, at the last point {}; light contact of the half-space has "
        "√(2π) = 2.51 by Bush, Gibson and Thomas, √(8/π) = 1.60 by Persson. Whole cells are "
        "counted, half a cell too much along all edges of contact.",
        fmt::join(factors, ", "));
    return figure;
}

}  // namespace

Figures rough_figures(const Case& c, const Histories& histories) {
    const bool flat = contact::is_nominally_flat(c);
    if (!flat && !c.indenter.roughness) return {};
    Figures figures{spectrum_figure(c)};
    if (flat) figures.push_back(area_figure(c, histories));
    if (figures.back().curves.empty()) figures.pop_back();
    return figures;
}

}  // namespace tricontact::comparisons
