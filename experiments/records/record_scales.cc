#include "experiments/records/record_scales.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "experiments/records/record_noise.h"
#include "report/format.h"

namespace tricontact::experiments {

namespace {

using ScaleKind = RecordFinding::Kind;

constexpr double clearly_coarser = 1.5;  // than stated
constexpr double equal_steps = .02;      // of a power of a thousand
constexpr double surely_negative = 5;    // standard errors
constexpr double uneven = .05;           // of W; a triangle clipped at .9 W on one side has .045
constexpr double aside = .1;             // of W
constexpr double half_a_sample = 2;      // W: how far below W the sample nearest to its tip may be

std::string length(double u) {
    return report::quantity(u, "m", 3);
}

/// Behind the last period the drive stands still, but not upright.
void find_end_aside(const Record& record, const DriveTimeline& timeline, RecordFindings& findings) {
    const auto behind = std::ranges::upper_bound(record.time, timeline.end()) - record.time.begin();
    std::vector<double> offsets(timeline.offset.begin() + behind, timeline.offset.end());
    if (offsets.size() < fewest_samples) return;
    const double last = offsets.back(), largest = timeline.stages.back().amplitude;
    const auto stands = std::ranges::count_if(
        offsets, [&](double w) { return std::abs(w - last) < aside * largest; });
    if (std::abs(last) < aside * largest || 2 * stands < std::ssize(offsets)) return;
    findings.push_back(
        {ScaleKind::drive,
         fmt::format("behind the last period the drive stands at {} and not upright: it is stuck, "
                     "or more was rolled than is counted",
                     length(last))});
}

}  // namespace

std::optional<double> power_of_thousand(double ratio, double tolerance) {
    if (!(ratio > 0)) return {};
    const double power = std::pow(1000, std::round(std::log10(ratio) / 3));
    if (power == 1 || std::abs(ratio / power - 1) > tolerance) return {};
    return power;
}

double resolution_of(const Record& record, std::optional<double> stated, RecordFindings& findings) {
    const double seen = smallest_step(record.shift);
    if (!stated) return seen;
    if (*stated > 0 && power_of_thousand(seen / *stated, equal_steps))
        findings.push_back(
            {ScaleKind::unit,
             fmt::format("the shift changes in steps of {}, record.resolution says {}: the unit of "
                         "one of them is wrong; correct the column's, or record.resolution",
                         length(seen), length(*stated))});
    else if (seen > clearly_coarser * *stated)
        findings.push_back(
            {ScaleKind::resolution,
             fmt::format("the shift changes in steps of {}, record.resolution says {}: the record "
                         "counts",
                         length(seen), length(*stated))});
    return std::max(*stated, seen > clearly_coarser * *stated ? seen : 0);
}

void find_sign(const Record& record, double static_shift, double standard_error,
               RecordFindings& findings) {
    if (static_shift > -surely_negative * standard_error || static_shift >= 0) return;
    const auto& force = record.tangential_force;
    if (std::accumulate(force.begin(), force.end(), 0.) < 0) return;
    findings.push_back(
        {ScaleKind::sign,
         fmt::format("the shift under F_T is {} before it rolls: U counts along F_T from the "
                     "unsheared contact; turn the sign of the column shift, or give record.loading",
                     length(static_shift)),
         true});
}

void find_uneven_drive(const Record& record, const DriveTimeline& timeline,
                       RecordFindings& findings) {
    find_end_aside(record, timeline, findings);
    for (const auto& stage : timeline.stages) {
        if (stage.extent == 0 || stage.amplitude == 0) continue;
        const auto from = std::ranges::lower_bound(record.time, stage.upright.front());
        const auto to = std::ranges::lower_bound(record.time, stage.upright.back());
        const double per_period = static_cast<double>(to - from) / stage.periods();
        const double allowed = uneven + half_a_sample / per_period;
        if (std::abs(stage.extent / stage.amplitude - 1) <= allowed) continue;
        findings.push_back(
            {.kind = ScaleKind::drive,
             .sentence = fmt::format(
                 "the drive turns {} from upright, and twice its mean distance is {}, which is the "
                 "same at constant speed: it is clipped, or its speed is not constant; correct the "
                 "column drive, or replace it by [record.drive] with the amplitude",
                 length(stage.extent), length(stage.amplitude)),
             .hides_amplitude = true});
        return;
    }
}

}  // namespace tricontact::experiments
