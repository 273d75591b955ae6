#include "comparisons/half_space/deviation_rows.h"

#include <fmt/format.h>

#include <algorithm>

#include "report/format.h"

namespace tricontact::comparisons {

namespace {

const RolledCurve* curve_here(const HalfSpaceDeviation& deviation) {
    const auto found = std::find_if(deviation.rolled.begin(), deviation.rolled.end(),
                                    [&](const RolledCurve& curve) {
                                        return curve.poisson == deviation.c.substrate.poisson &&
                                               curve.coupled == deviation.c.contact.coupling;
                                    });
    return found == deviation.rolled.end() ? nullptr : &*found;
}

}  // namespace

std::vector<DeviationRow> rows_here(const HalfSpaceDeviation& deviation) {
    std::vector<DeviationRow> rows;
    const ExactCurve& exact = deviation.curves.front();
    for (const ExactQuantity q : exact_quantities()) {
        const auto i = static_cast<std::size_t>(q);
        if (deviation.here.at(i))
            rows.push_back(
                {&describe(q), false, RolledRatio{*deviation.here.at(i), 0}, exact.needed.at(i)});
    }
    const RolledDeviation* computed = rolled_here(deviation);
    if (!computed) return rows;
    for (const RolledQuantity q : rolled_quantities()) {
        const auto i = static_cast<std::size_t>(q);
        const auto& needed = curve_here(deviation)->needed.at(i);
        if (computed->ratios.at(i) || needed)
            rows.push_back({&describe(q), true, computed->ratios.at(i), needed});
    }
    return rows;
}

double thinnest_of(const HalfSpaceDeviation& deviation, const DeviationRow& row) {
    if (!row.computed) return deviation.curves.front().thickness_ratios.front();
    return curve_here(deviation)->points.front().body.thickness_ratio;
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
