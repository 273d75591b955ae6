#include "experiments/records/loading_time.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/records/drive_timeline.h"
#include "experiments/records/record_checks.h"
#include "report/format.h"
#include "statistics/estimate.h"

namespace tricontact::experiments {

namespace {

constexpr double negligible_rise = .005;  // of the whole
constexpr double noise_factor = 6;        // standard deviations
constexpr std::size_t first_samples = 10;

/// Of the shift in samples [from, to), at least one.
double level_of(const Record& record, std::size_t from, std::size_t to) {
    to = std::clamp(to, from + 1, record.shift.size());
    return statistics::median({record.shift.begin() + static_cast<std::ptrdiff_t>(from),
                               record.shift.begin() + static_cast<std::ptrdiff_t>(to)});
}

std::string micrometres_of(double u) {
    return report::significant(1e6 * u, 3) + " µm";
}

}  // namespace

LoadingTime loading_time(const Record& record, double stated, double start) {
    const auto index = [&](double t) {
        return static_cast<std::size_t>(std::ranges::lower_bound(record.time, t) -
                                        record.time.begin());
    };
    const std::size_t end = index(start);
    const double first = record.time.front();
    if (stated >= start)
        refuse_record(
            record,
            fmt::format("record.loading = {:.4g} s is not before the rolling, which begins at "
                        "{:.4g} s",
                        stated, start),
            "correct record.loading");
    const double low = level_of(record, 0, std::min(first_samples, end));
    const double high = level_of(record, index((std::max(stated, first) + start) / 2), end);
    const double rise = high - low, noise = usual_difference(record) / std::sqrt(2.);
    if (std::abs(rise) <= noise_factor * noise)
        refuse_record(
            record,
            fmt::format(
                "record.loading = {:.4g} s, but the shift does not rise before the rolling: it "
                "is {} at first and {} before the rolling begins at {:.4g} s",
                stated, micrometres_of(low), micrometres_of(high), start),
            "correct record.loading, or omit it if the record begins later");
    LoadingTime found;
    std::size_t k = 0;
    while (k < end && std::abs(record.shift[k] - low) < std::abs(rise) / 2) ++k;
    found.half_way = record.time[std::min(k, record.time.size() - 1)];
    const double negligible = std::max(noise_factor * noise, negligible_rise * std::abs(rise));
    const double zero = level_of(record, 0, k);
    while (k > 0 && std::abs(record.shift[k - 1] - zero) > negligible) --k;
    if (k < 3)
        refuse_record(record, "there are fewer than 3 samples before the shift rises",
                      "omit record.loading if the record begins later");
    found.n_unloaded = k;
    found.last_unloaded = record.time[k - 1];
    const double interval = (start - first) / static_cast<double>(std::max<std::size_t>(end, 1));
    found.time = found.agrees(stated, interval) ? stated : found.half_way;
    return found;
}

}  // namespace tricontact::experiments
