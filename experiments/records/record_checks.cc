#include "experiments/records/record_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/records/record_noise.h"
#include "report/format.h"
#include "statistics/estimate.h"

namespace tricontact::experiments {

namespace {

constexpr std::size_t neighbours = 3;    // to each side
constexpr double isolated = 4;           // times what the neighbours show
constexpr double improbable = 8;         // standard deviations
constexpr double to_deviation = 1.4826;  // median of absolute values of a normal variable

using FindingKind = RecordFinding::Kind;

std::string seconds(double t) {
    return report::significant(t, 4) + " s";
}
std::string micrometres(double u) {
    return report::significant(1e6 * u, 3) + " µm";
}

/// Differences between successive values, and how large those nearby are.
class Differences {
  public:
    explicit Differences(const std::vector<double>& values) {
        for (std::size_t i = 1; i < values.size(); ++i) all_.push_back(values[i] - values[i - 1]);
    }

    std::size_t size() const { return all_.size(); }
    double operator[](std::size_t i) const { return all_[i]; }
    /// Largest of those beside [first, last].
    double around(std::size_t first, std::size_t last) const {
        double largest = 0;
        for (std::size_t k = 1; k <= neighbours; ++k) {
            if (first >= k) largest = std::max(largest, std::abs(all_[first - k]));
            if (last + k < all_.size()) largest = std::max(largest, std::abs(all_[last + k]));
        }
        return largest;
    }

  private:
    std::vector<double> all_;  // [i]: from sample i to i + 1
};

/// What no noise and no motion of the contact does.
class Threshold {
  public:
    explicit Threshold(const Record& record)
        : differences_(record.shift),
          least_(std::max(improbable * usual_difference(record),
                          neighbours * smallest_step(record.shift))) {}

    const Differences& differences() const { return differences_; }
    /// The difference after sample i stands out from those beside `first` to `last`.
    bool stands_out(std::size_t i, std::size_t first, std::size_t last) const {
        const double size = std::abs(differences_[i]);
        return size > least_ && size > isolated * differences_.around(first, last);
    }

  private:
    Differences differences_;
    double least_;
};

/// Samples of an outlier that begins with sample `first`; 0: there is none.
std::size_t outlier_at(const Threshold& threshold, std::size_t first) {
    const Differences& d = threshold.differences();
    if (first == 0) return threshold.stands_out(0, 0, 0) ? 1 : 0;
    const std::size_t in = first - 1;  // the difference that leads to it
    double back = d[in];               // from before it to behind it
    for (std::size_t length = 1; length <= longest_outlier; ++length) {
        const std::size_t out = in + length;
        if (out >= d.size()) return length == 1 && threshold.stands_out(in, in, in) ? 1 : 0;
        back += d[out];
        if (d[in] * d[out] >= 0) continue;
        const double smaller = std::min(std::abs(d[in]), std::abs(d[out]));
        if (std::abs(back) < smaller / isolated && threshold.stands_out(in, in, out) &&
            threshold.stands_out(out, in, out))
            return length;
    }
    return 0;
}

Record only(const Record& record, const std::vector<bool>& kept) {
    Record result{.name = record.name, .time = {}, .shift = {}, .drive = {}};
    for (const auto column : {&Record::time, &Record::shift, &Record::drive, &Record::normal_force,
                              &Record::tangential_force})
        for (std::size_t i = 0; i < (record.*column).size(); ++i)
            if (kept[i]) (result.*column).push_back((record.*column)[i]);
    return result;
}

void refuse_dead(const Record& record) {
    const auto [low, high] = std::ranges::minmax(record.shift);
    if (low < high) return;
    refuse_record(record,
                  fmt::format("the shift is {} in all {} samples: the channel is dead",
                              micrometres(low), record.shift.size()),
                  "check the sensor, and the column shift");
}

std::size_t index_at(const Record& record, double t) {
    return static_cast<std::size_t>(std::ranges::lower_bound(record.time, t) - record.time.begin());
}

/// How often neighbours are equal among these samples.
double share_of_equals(const Record& record, std::size_t begin, std::size_t end) {
    std::size_t equal = 0, n = 0;
    for (std::size_t i = begin + 1; i < end; ++i, ++n)
        equal += record.shift[i] == record.shift[i - 1];
    return n > 0 ? static_cast<double>(equal) / static_cast<double>(n) : 1;
}

/// The largest or smallest value, if it is taken far more often than the next one.
std::optional<double> piled_up(std::vector<double> values) {
    constexpr std::ptrdiff_t fewest = 20, times = 3;
    std::ranges::sort(values);
    for (const double end : {values.front(), values.back()}) {
        const auto n = std::ranges::count(values, end);
        if (n < fewest || n == std::ssize(values)) continue;
        const double next = end == values.front()
                                ? values[static_cast<std::size_t>(n)]
                                : values[values.size() - 1 - static_cast<std::size_t>(n)];
        if (n > times * std::ranges::count(values, next)) return end;
    }
    return {};
}

bool hides_upright(const Record& record, const DriveTimeline::Stage& stage, double from, double to,
                   double upright) {
    const double reach = upright_window * stage.period();
    if (to < upright - reach || from > upright + reach) return false;
    const auto n = [&](double begin, double end) {
        return std::ranges::count_if(record.time, [&](double t) { return t >= begin && t <= end; });
    };
    return n(upright - reach, upright) < 2 || n(upright, upright + reach) < 2;
}

}  // namespace

const char* name_of(RecordFinding::Kind kind) {
    switch (kind) {
        case FindingKind::gap:
            return "gap";
        case FindingKind::jump:
            return "jump";
        case FindingKind::outlier:
            return "outlier";
        case FindingKind::stuck:
            return "stuck";
        case FindingKind::clipped:
            return "clipped";
        case FindingKind::loading:
            return "loading";
        case FindingKind::drift:
            return "drift";
        case FindingKind::delay:
            return "delay";
        case FindingKind::noise:
            return "noise";
        case FindingKind::correlation:
            return "correlation";
        case FindingKind::sign:
            return "sign";
        case FindingKind::unit:
            return "unit";
        case FindingKind::resolution:
            return "resolution";
        case FindingKind::drive:
            return "drive";
        case FindingKind::hum:
            return "hum";
    }
    return "";
}

double usual_difference(const Record& record) {
    std::vector<double> sizes;
    for (std::size_t i = 1; i < record.shift.size(); ++i)
        sizes.push_back(std::abs(record.shift[i] - record.shift[i - 1]));
    return to_deviation * statistics::median(std::move(sizes));
}

Record without_outliers(const Record& record, RecordFindings& findings) {
    refuse_dead(record);
    const Threshold threshold(record);
    std::vector<bool> kept(record.shift.size(), true);
    std::size_t n = 0, furthest = 0;
    double distance = 0;
    for (std::size_t i = 0; i < record.shift.size();) {
        const std::size_t length = outlier_at(threshold, i);
        if (length == 0) {
            ++i;
            continue;
        }
        const double off = std::abs(threshold.differences()[i == 0 ? 0 : i - 1]);
        if (off > distance) {
            distance = off;
            furthest = i;
        }
        n += length;
        for (std::size_t k = 0; k < length; ++k) kept[i + k] = false;
        i += length;
    }
    if (n == 0) return record;
    findings.push_back({FindingKind::outlier,
                        fmt::format("{} {} left out, the furthest {} off its neighbours at {}", n,
                                    n == 1 ? "sample is" : "samples are", micrometres(distance),
                                    seconds(record.time[furthest]))});
    return only(record, kept);
}

void find_repeated_values(const Record& record, const DriveTimeline& timeline, double from,
                          RecordFindings& findings) {
    const std::size_t start = index_at(record, from);
    const double equal = share_of_equals(record, start, index_at(record, timeline.start()));
    constexpr double quiet = .98;  // noise is below the resolution
    if (equal > quiet) return;
    constexpr double once_in = 1e9;
    const double longest_by_chance =
        std::max(8., equal > 0 ? -std::log(once_in) / std::log(equal) : 0.);
    const std::vector<double> values(record.shift.begin() + static_cast<std::ptrdiff_t>(start),
                                     record.shift.end());
    const auto [low, high] = std::ranges::minmax(values);
    std::size_t first = 0, most = 0, begin = 0;
    for (std::size_t i = 1; i <= values.size(); ++i) {
        if (i < values.size() && values[i] == values[i - 1]) continue;
        if (i - begin > most) {
            most = i - begin;
            first = begin;
        }
        begin = i;
    }
    const double value = values[first];
    if (static_cast<double>(most) >= longest_by_chance) {
        const bool clipped = value == low || value == high;
        findings.push_back(
            {clipped ? FindingKind::clipped : FindingKind::stuck,
             fmt::format(
                 "the shift is {} in {} samples in succession from {} on{}", micrometres(value),
                 most, seconds(record.time[start + first]),
                 clipped ? ", and never beyond: the sensor is clipped" : ": the sensor is stuck"),
             true});
    } else if (const auto end = piled_up(values)) {
        findings.push_back(
            {FindingKind::clipped,
             fmt::format("the shift is {} in {} samples, and never beyond: the sensor is clipped",
                         micrometres(*end), std::ranges::count(values, *end)),
             true});
    }
}

void find_gaps(const Record& record, const DriveTimeline& timeline, RecordFindings& findings) {
    const Differences intervals(record.time);
    std::size_t n = 0, longest = 0;
    for (std::size_t i = 0; i < intervals.size(); ++i) {
        if (intervals[i] <= gap_factor * intervals.around(i, i)) continue;
        const double from = record.time[i], to = record.time[i + 1];
        if (n++ == 0 || intervals[i] > intervals[longest]) longest = i;
        for (const auto& stage : timeline.stages)
            for (const double upright : stage.upright)
                if (hides_upright(record, stage, from, to, upright))
                    refuse_record(record,
                                  fmt::format("there is a gap of {} at {}, where the roller is "
                                              "upright and its shift is read",
                                              seconds(to - from), seconds(from)),
                                  "leave this run out, or cut the record before the gap");
    }
    if (n == 0) return;
    findings.push_back(
        {FindingKind::gap, fmt::format("there is a gap of {} at {}{}", seconds(intervals[longest]),
                                       seconds(record.time[longest]),
                                       n == 1 ? "" : fmt::format(", the longest of {}", n))});
}

}  // namespace tricontact::experiments
