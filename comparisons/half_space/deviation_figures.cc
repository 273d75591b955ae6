#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "comparisons/half_space/deviation_output.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using theory::LayerBase;

const report::FigureAxis thickness_axis{"thickness over contact width b/D_c", true};

/// A quantity along a curve; `percent`: 100 |ratio - 1|.
report::Curve exact_line(const ExactCurve& curve, const Quantity* q, const std::string& name,
                         bool percent) {
    report::Curve line{.name = name};
    for (std::size_t i = 0; i < curve.ratios.size(); ++i) {
        const double* ratio = found(curve.ratios[i], q);
        if (ratio)
            line.add(curve.thickness_ratios[i], percent ? 100 * std::abs(*ratio - 1) : *ratio);
    }
    return line;
}

/// Where the case is.
report::Curve here(const HalfSpaceDeviation& deviation, double low, double high) {
    return {.name = "this layer",
            .x = {deviation.thickness_ratio, deviation.thickness_ratio},
            .y = {low, high},
            .theory = true};
}

report::Figure over_thickness(const std::string& id, const std::string& title,
                              const std::string& caption, const report::FigureAxis& y) {
    return {.id = id, .title = title, .caption = caption, .x = thickness_axis, .y = y};
}

/// A computed quantity along a curve; `percent`: 100 |ratio - 1|, gaps where that is no more than
/// its error and has no place on a logarithmic axis.
report::Curve computed_line(const RolledCurve& curve, const Quantity* q, const std::string& name,
                            bool percent) {
    report::Curve line{.name = name, .kind = report::Curve::Kind::line_and_points};
    for (const RolledDeviation& point : curve.points) {
        const RolledRatio* ratio = found(point.ratios, q);
        if (!ratio || (percent && std::abs(ratio->value - 1) <= ratio->error)) continue;
        line.add(point.body.thickness_ratio,
                 percent ? 100 * std::abs(ratio->value - 1) : ratio->value);
        line.y_error.push_back(percent ? 100 * ratio->error : ratio->error);
    }
    return line;
}

bool is_own(const HalfSpaceDeviation& deviation, const RolledCurve& curve) {
    return curve.poisson == deviation.c.substrate.poisson;
}

report::Figure material_figure(const HalfSpaceDeviation& deviation, const Quantity* q) {
    report::Figure figure = over_thickness(
        fmt::format("materials_{}", ratio_key(*q)),
        fmt::format("{} by Poisson's ratio and base", q->symbol),
        fmt::format("Exact {} of the layer over that of the half-space of the same material under "
                    "the same force; bonded base unless stated otherwise.",
                    q->name),
        {fmt::format("{} over half-space [-]", q->symbol)});
    for (const ExactCurve& curve : deviation.curves)
        if (curve.ratios.front().contains(q)) {
            const std::string name = curve.base == LayerBase::frictionless
                                         ? "frictionless base, any nu"
                                         : "nu = " + report::as_given(curve.poisson);
            figure.curves.push_back(exact_line(curve, q, name, false));
        }
    figure.curves.push_back(here(deviation, 0, 1));
    return figure;
}

/// Levels of a map [%], beyond which its colours do not reach.
const std::vector<double> map_levels{-60, -40, -20, -10, -5, -2, -1, 1, 2, 5, 10, 20, 40, 60};

report::Figure map_figure(const HalfSpaceDeviation& deviation, const Quantity* q) {
    const ExactMap& map = deviation.map;
    report::Figure figure = over_thickness(
        fmt::format("map_{}", ratio_key(*q)), fmt::format("{}: {}", q->symbol, q->name),
        "Layer over half-space minus 1 in percent, exact, bonded base, same force.",
        {"Poisson ratio nu [-]"});
    figure.map = {"deviation [%]", map.thickness_ratios, map.poissons, {}, map_levels};
    for (const ExactRatios& ratios : map.ratios)
        figure.map->values.push_back(100 * (ratios.at(q) - 1));
    if (deviation.base == LayerBase::bonded && deviation.c.substrate.poisson >= 0)
        figure.curves.push_back({.name = "this layer",
                                 .x = {deviation.thickness_ratio},
                                 .y = {deviation.c.substrate.poisson},
                                 .kind = report::Curve::Kind::points});
    return figure;
}

}  // namespace

std::vector<report::Figure> thickness_figures(const HalfSpaceDeviation& deviation) {
    const ExactCurve& curve = deviation.curves.front();
    report::Figure ratios = over_thickness(
        "ratios", "Layer over half-space",
        fmt::format("Exact theory, same force, nu = {}, {} base. What lies at 1 is that of a "
                    "half-space; the dashed line is the case's layer.",
                    report::as_given(deviation.c.substrate.poisson), name_of(deviation.base)),
        {"layer over half-space [-]", true});
    report::Figure percents = over_thickness(
        "deviations", "Deviation from the half-space",
        std::string("The same as |ratio - 1|") +
            (deviation.rolled.empty()
                 ? ""
                 : ", with what boundary elements computed (points, numerical error as bars; left "
                   "out where the error is larger)") +
            ". Thick layers fall by the powers of theory: d, U_max and the stiffnesses as D_c/b, a "
            "and p0 as its third, the limits as its fifth.",
        {"deviation [%]", true});
    for (const Quantity* q : exact_quantities) {
        if (!curve.ratios.front().contains(q)) continue;
        ratios.curves.push_back(exact_line(curve, q, q->symbol, false));
        percents.curves.push_back(exact_line(curve, q, q->symbol, true));
        // Below 1e-6 % only rounding is left.
        for (double& y : percents.curves.back().y)
            if (y < 1e-6) y = std::numeric_limits<double>::quiet_NaN();
    }
    for (const RolledCurve& rolled : deviation.rolled) {
        if (!is_own(deviation, rolled) || rolled.coupled != deviation.c.contact.coupling) continue;
        for (const Quantity* q :
             {&quantities::static_shift, &quantities::settled_shift,
              &quantities::settled_shift_ratio, &quantities::shift_increment_ratio}) {
            report::Curve points = computed_line(rolled, q, q->symbol, true);
            points.kind = report::Curve::Kind::points;
            if (!points.x.empty()) percents.curves.push_back(points);
        }
    }
    ratios.curves.push_back(here(deviation, .1, 10));
    percents.curves.push_back(here(deviation, 1e-3, 1e3));
    return {ratios, percents};
}

std::vector<report::Figure> map_figures(const HalfSpaceDeviation& deviation) {
    std::vector<report::Figure> figures;
    for (const Quantity* q : exact_quantities)
        if (deviation.map.ratios.front().contains(q)) figures.push_back(map_figure(deviation, q));
    for (const Quantity* q : {&quantities::indentation, &quantities::unit_shift})
        figures.push_back(material_figure(deviation, q));
    return figures;
}

std::vector<report::Figure> rolled_figures(const HalfSpaceDeviation& deviation) {
    std::vector<report::Figure> figures;
    for (const Quantity* q : rolled_quantities) {
        const bool unrolled =
            q == &quantities::static_shift || q == &quantities::static_shift_ratio;
        const double w =
            is_of_ratcheting(q) ? deviation.amplitudes.ratcheting : deviation.amplitudes.settling;
        report::Figure figure = over_thickness(
            fmt::format("computed_{}", ratio_key(*q)), fmt::format("{}: {}", q->symbol, q->name),
            fmt::format("Boundary elements of the bonded layer over those of the half-space, "
                        "coupled unless stated otherwise, f_T = {}, {}; bars: numerical error.",
                        report::significant(deviation.contact.tangential_ratio, 3),
                        unrolled ? "before rolling" : "w = " + report::significant(w, 3)),
            {fmt::format("{} over half-space [-]", q->symbol)});
        for (const RolledCurve& curve : deviation.rolled) {
            if (!curve.coupled && !is_own(deviation, curve)) continue;
            const std::string name = fmt::format("nu = {}{}", report::as_given(curve.poisson),
                                                 curve.coupled ? "" : ", uncoupled");
            const report::Curve line = computed_line(curve, q, name, false);
            if (!line.x.empty()) figure.curves.push_back(line);
        }
        if (!figure.curves.empty()) figures.push_back(figure);
    }
    return figures;
}

}  // namespace tricontact::comparisons
