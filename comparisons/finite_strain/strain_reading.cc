// Sentences and lines for people.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "comparisons/finite_strain/strain_output.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using Standing = report::Verdict::Standing;

/// Of a deviation from which on linear elasticity is said to fail.
constexpr double tolerable_strain_error = .05;

std::string percents(double share) {
    return report::significant(100 * share, 2);
}

/// "off by 1 % from F_N = 11.9 N on, by 2 % from F_N = 25 N on, not by 5 % up to F_N = 169 N".
std::string thresholds_sentence(const std::vector<DeviationPoint>& points, bool of_force,
                                const std::string& symbol, const std::string& unit) {
    const auto shown = [&](double value) {
        return unit.empty() ? report::significant(value, 3) : report::quantity(value, unit, 3);
    };
    std::vector<std::string> parts;
    for (const double tolerance : strain_tolerances) {
        const auto threshold = strain_threshold(points, tolerance, of_force);
        if (!threshold) return {};
        const std::string off = fmt::format("by {} %", 100 * tolerance);
        if (threshold->from_begin)
            parts.push_back(fmt::format("{} from the least {} = {} on already", off, symbol,
                                        shown(points.front().at)));
        else if (threshold->at)
            parts.push_back(fmt::format("{} from {} = {} on{}", off, symbol, shown(*threshold->at),
                                        threshold->returns ? " (further on less again)" : ""));
        else {
            parts.push_back(
                fmt::format("not {} up to {} = {}", off, symbol, shown(points.back().at)));
            break;  // nor by more
        }
    }
    if (parts.size() == 1 && parts.front().starts_with("not "))
        return fmt::format("not off {}", parts.front().substr(4));
    return fmt::format("off {}", fmt::join(parts, ", "));
}

report::Verdict row_verdict(const StrainDeviation& deviation, const StrainRow& row) {
    const char* symbol = row.quantity->symbol;
    const double size = std::abs(row.deviation);
    std::string text;
    if (row.error && size <= *row.error)
        text = fmt::format(
            "Linear elasticity gives {} as finite strains do, to {} % with the numerical error",
            symbol, percents(size + *row.error));
    else
        text = fmt::format("Linear elasticity puts {} {}{} % too {} here", symbol, percents(size),
                           row.error ? " ± " + percents(*row.error) : "",
                           row.deviation > 0 ? "high" : "low");
    const std::string along = thresholds_sentence(
        deviation_along(deviation, row.quantity, StrainAxis::normal_force), true, "F_N", "N");
    if (!along.empty()) text += fmt::format("; it is {}, at this thickness", along);
    return {size > tolerable_strain_error ? Standing::violated : Standing::holds, text + "."};
}

/// Where the static shift is off over F_T and over b.
std::vector<report::Verdict> further_verdicts(const StrainDeviation& deviation) {
    const Quantity* q = &quantities::static_shift;
    std::vector<report::Verdict> verdicts;
    const auto add = [&](StrainAxis axis, const char* rest, const char* symbol, const char* unit) {
        const std::string along =
            thresholds_sentence(deviation_along(deviation, q, axis), false, symbol, unit);
        if (!along.empty())
            verdicts.push_back(
                {Standing::finding, fmt::format("{}, {} is {}.", rest, q->symbol, along)});
    };
    add(StrainAxis::tangential_ratio, "Under this normal force on this layer", "f_T", "");
    add(StrainAxis::thickness, "Under this normal force on layers of other thickness", "b", "m");
    return verdicts;
}

}  // namespace

const char* name_of(contact::Case::Law law) {
    switch (law) {
        case contact::Case::Law::linear:
            return "linear";
        case contact::Case::Law::neo_hookean:
            return "neo-Hookean";
        case contact::Case::Law::mooney_rivlin:
            break;
    }
    return "Mooney-Rivlin";
}

std::string threshold_text(const std::optional<StrainThreshold>& threshold, double first,
                           double last, const std::string& unit) {
    if (!threshold) return "–";
    if (threshold->from_begin) return "below " + report::quantity(first, unit, 3);
    if (!threshold->at) return "not up to " + report::quantity(last, unit, 3);
    const std::string text = report::quantity(*threshold->at, unit, 3);
    if (!threshold->low || !threshold->high) return text;
    const std::string low = report::quantity(*threshold->low, unit, 3),
                      high = report::quantity(*threshold->high, unit, 3);
    return low == text && high == text ? text : fmt::format("{} ({} to {})", text, low, high);
}

std::vector<report::Verdict> strain_verdicts(const StrainDeviation& deviation) {
    std::vector<report::Verdict> verdicts;
    for (const StrainRow& row : strain_rows(deviation))
        verdicts.push_back(row_verdict(deviation, row));
    for (const report::Verdict& verdict : further_verdicts(deviation)) verdicts.push_back(verdict);
    if (deviation.n_failed_runs > 0)
        verdicts.push_back(
            {Standing::fail,
             fmt::format("Failed runs: {}; their values are missing.", deviation.n_failed_runs)});
    return verdicts;
}

}  // namespace tricontact::comparisons
