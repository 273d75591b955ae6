#include <fmt/format.h>

#include "experiments/records/experiment_report.h"
#include "experiments/records/record_scales.h"
#include "report/format.h"

// Measured beside computed, one statement and one row of a table each.
namespace tricontact::experiments {

namespace {

using report::Verdict;
using enum Verdict::Standing;

// Of a Deviation or a SeriesDeviation that cannot tell.
template <class D>
std::string why_not_compared(const D& d, double creep) {
    if (!d.has_errors)
        return "the case states no uncertainty of its numbers: whether they differ is not resolved";
    if (d.rest_is_missing)
        return "how long F_T acted before the rolling is not known: whether they differ is not "
               "resolved";
    if (d.is_spoilt) return "a record is damaged, see below: whether they differ is not resolved";
    if (d.slides)
        return "within the uncertainty of the case the contact slides: whether they differ is "
               "not resolved";
    return fmt::format(
        "{}; but not if the drift that was subtracted, {} µm, is creep of the substrate",
        statement(d.error, "m"), report::significant(um * creep, 2));
}

/// The largest difference that agrees [m].
std::string allowed(double half_width, bool has_errors) {
    return has_errors ? fmt::format("within {} µm", report::significant(um * half_width, 2)) : "";
}

std::string seen(double resolution, const ComparisonError& error) {
    return fmt::format("would have seen {} %; uncertain by {}",
                       report::significant(100 * resolution, 2), largest_contributors(error, 3));
}

Verdict::Standing standing_of(std::optional<bool> differs) {
    return !differs ? not_resolved : *differs ? fail : pass;
}

/// Of a quantity that is off by a power of a thousand, to a factor of two.
std::string doubted_unit(const Deviation& d) {
    constexpr double factor = .5;
    const auto power = power_of_thousand(d.ratio(), factor);
    if (!power) return "";
    return fmt::format(
        " It was measured some {:g} times as large: is the unit of the column shift "
        "right?",
        *power);
}

Verdict deviation_verdict(const Deviation& d) {
    const auto differs = d.differs();
    const std::string computed = d.has_errors ? shift_text(d.predicted)
                                              : report::significant(um * d.predicted.value) + " µm";
    const std::string model = report::display_name(d.model), measured = shift_text(d.measured),
                      ratio = report::percent(d.ratio());
    Verdict verdict{
        standing_of(differs),
        fmt::format("{}: {} = {}, measured {} ({}); {}.{}", model, d.quantity, computed, measured,
                    ratio, differs ? statement(d.error, "m") : why_not_compared(d, d.creep),
                    doubted_unit(d))};
    verdict.subject = model + ": " + d.quantity;
    verdict.number = fmt::format("{}, measured {} ({})", computed, measured, ratio);
    verdict.threshold = allowed(d.error.half_width(), d.has_errors);
    verdict.effect =
        (differs ? seen(d.error.resolution(), d.error) : why_not_compared(d, d.creep)) +
        doubted_unit(d);
    return verdict;
}

Verdict series_verdict(const SeriesDeviation& d) {
    const auto differs = d.differs();
    const std::size_t n = d.error.furthest();
    const std::string model = report::display_name(d.model);
    Verdict verdict{standing_of(differs), fmt::format("{}, all periods: {}.", model,
                                                      differs ? statement(d.error, "m")
                                                              : why_not_compared(d, d.creep(n)))};
    verdict.subject = model + ": U over all periods";
    verdict.number = fmt::format("furthest at n = {}: {}, measured {} µm", n,
                                 report::significant(um * d.error.values[n].computed, 4),
                                 report::significant(um * d.error.values[n].measured, 4));
    verdict.threshold = allowed(d.error.half_width(n), d.has_errors);
    verdict.effect =
        differs ? seen(d.error.resolution, d.error.values[n]) : why_not_compared(d, d.creep(n));
    return verdict;
}

}  // namespace

std::string shift_text(const Estimate& e) {
    return report::with_error(um * e.value, um * e.half_width(), 4) + " µm";
}

std::vector<Verdict> comparison_verdicts(const ExperimentEvaluation& e) {
    std::vector<Verdict> verdicts;
    for (const SeriesDeviation& d : e.series) verdicts.push_back(series_verdict(d));
    for (const Deviation& d : e.deviations) verdicts.push_back(deviation_verdict(d));
    return verdicts;
}

}  // namespace tricontact::experiments
