// Sentences and lines for people.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/half_space/deviation_output.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using Standing = report::Verdict::Standing;

/// Of a deviation from which on a half-space is said to fail.
constexpr double tolerable = .05;

/// The case's own layer among the computed ones; null without.
const RolledDeviation* rolled_here(const HalfSpaceDeviation& deviation) {
    for (const RolledCurve& curve : deviation.rolled)
        for (const RolledDeviation& point : curve.points)
            if (curve.poisson == deviation.c.substrate.poisson &&
                curve.coupled == deviation.c.contact.coupling &&
                point.body.thickness_ratio == deviation.thickness_ratio)
                return &point;
    return nullptr;
}

report::Verdict layer_verdict(const HalfSpaceDeviation& deviation) {
    const auto beside = [&](const Quantity& q) {
        return report::apart(deviation.here.at(&q), "above", "below");
    };
    std::string text = fmt::format(
        "The layer is {} widths of Hertz' contact thick ({}, {} base, nu = {}): on it the "
        "indentation is {} that of a half-space under the same force, the contact radius {}, the "
        "peak pressure {}, the normal stiffness {}",
        report::significant(deviation.thickness_ratio, 3),
        report::given_quantity(*deviation.c.layer.thickness, "m"), name_of(deviation.base),
        report::as_given(deviation.c.substrate.poisson), beside(quantities::indentation),
        beside(quantities::contact_radius), beside(quantities::peak_pressure),
        beside(quantities::normal_stiffness));
    if (deviation.base == theory::LayerBase::bonded)
        text += fmt::format(", U_max {}", beside(quantities::unit_shift));
    const bool fails = std::ranges::any_of(
        deviation.here, [](const auto& one) { return std::abs(one.second - 1) > tolerable; });
    return {fails ? Standing::violated : Standing::holds, text + "."};
}

report::Verdict modulus_verdict(const HalfSpaceDeviation& deviation) {
    const double young = deviation.c.substrate.young;
    const ApparentModuli& apparent = deviation.apparent;
    const auto off = [&](double modulus) {
        return report::apart(modulus / young, "too high", "too low");
    };
    std::string text = fmt::format(
        "Identified by Hertz' theory, E would be {} from force and indentation, {} from the "
        "contact radius",
        off(apparent.from_indentation), off(apparent.from_contact_radius));
    if (apparent.from_unit_shift)
        text += fmt::format(", {} from U_max", off(*apparent.from_unit_shift));
    return {Standing::finding, text + "."};
}

std::optional<report::Verdict> needed_verdict(const HalfSpaceDeviation& deviation) {
    std::vector<std::string> parts;
    for (const DeviationRow& row : rows_here(deviation)) {
        if (row.computed || !row.needed) continue;
        parts.push_back(fmt::format("{} in {}", needed_text(row.needed->front(), row.thinnest),
                                    row.quantity->symbol));
    }
    if (parts.empty()) return {};
    return report::Verdict{
        Standing::finding,
        fmt::format("For 1 % the layer has to be so many contact widths thick: {}.",
                    fmt::join(parts, ", "))};
}

/// "U_stat 12.1 ± 0.2 % below, ...": what is more than its error.
std::optional<report::Verdict> rolled_verdict(const HalfSpaceDeviation& deviation) {
    const RolledDeviation* point = rolled_here(deviation);
    if (!point) return {};
    std::vector<std::string> differs, same;
    for (const Quantity* q : rolled_quantities) {
        const RolledRatio* ratio = found(point->ratios, q);
        if (!ratio) continue;
        const double size = std::abs(ratio->value - 1);
        if (size <= ratio->error)
            same.push_back(fmt::format("{} (to {} %)", q->symbol,
                                       report::significant(100 * (size + ratio->error), 2)));
        else
            differs.push_back(fmt::format(
                "{} {} ± {} % {}", q->symbol, report::significant(100 * size, 3),
                report::significant(100 * ratio->error, 2), ratio->value < 1 ? "lower" : "higher"));
    }
    std::string text = "Friction and rolling on the layer against the half-space: ";
    text += differs.empty() ? "nothing differs by more than its numerical error"
                            : fmt::format("{}", fmt::join(differs, ", "));
    if (!same.empty()) text += fmt::format("; no difference in {}", fmt::join(same, ", "));
    if (point->state == contact::State::ratcheting &&
        point->half_space_state == contact::State::shakedown)
        text += "; at w = " + report::significant(deviation.amplitudes.settling, 3) +
                " it ratchets, the half-space shakes down";
    return report::Verdict{Standing::finding, text + "."};
}

}  // namespace

std::vector<report::Verdict> deviation_verdicts(const HalfSpaceDeviation& deviation) {
    std::vector<report::Verdict> verdicts{layer_verdict(deviation), modulus_verdict(deviation)};
    for (const auto& verdict : {needed_verdict(deviation), rolled_verdict(deviation)})
        if (verdict) verdicts.push_back(*verdict);
    if (deviation.n_failed_runs > 0)
        verdicts.push_back(
            {Standing::fail,
             fmt::format("Failed runs: {}; their values are missing.", deviation.n_failed_runs)});
    return verdicts;
}

std::vector<DeviationRow> rows_here(const HalfSpaceDeviation& deviation) {
    std::vector<DeviationRow> rows;
    const ExactCurve& exact = deviation.curves.front();
    for (const Quantity* q : exact_quantities)
        if (const double* ratio = found(deviation.here, q))
            rows.push_back({q, false, RolledRatio{*ratio, 0}, found(exact.needed, q),
                            exact.thickness_ratios.front()});
    const auto curve = std::ranges::find_if(deviation.rolled, [&](const RolledCurve& one) {
        return one.poisson == deviation.c.substrate.poisson &&
               one.coupled == deviation.c.contact.coupling;
    });
    const RolledDeviation* computed = rolled_here(deviation);
    if (!computed) return rows;
    for (const Quantity* q : rolled_quantities) {
        const auto* ratio = found(computed->ratios, q);
        const auto* needed = found(curve->needed, q);
        if (ratio || needed)
            rows.push_back({q, true, ratio ? std::optional(*ratio) : std::nullopt, needed,
                            curve->points.front().body.thickness_ratio});
    }
    return rows;
}

std::string needed_text(const NeededThickness& needed, double thinnest) {
    if (!needed.ratio && !needed.high) return "below " + report::significant(thinnest, 2);
    if (!needed.ratio) return "at most " + report::significant(needed.high, 3);
    const std::string text = report::significant(needed.ratio, 3);
    const std::string low = needed.low ? report::significant(needed.low, 3)
                                       : "below " + report::significant(thinnest, 2);
    const std::string high = report::significant(needed.high, 3);
    const bool exact = !needed.high && !needed.low;
    if (!exact && (low != text || high != text))
        return fmt::format("{} ({} to {})", text, low, high);
    return text;
}

const char* name_of(theory::LayerBase base) {
    return base == theory::LayerBase::bonded ? "bonded" : "frictionless";
}

}  // namespace tricontact::comparisons
