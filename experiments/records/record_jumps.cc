#include "experiments/records/record_jumps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "experiments/records/record_noise.h"
#include "report/format.h"
#include "statistics/estimate.h"

namespace tricontact::experiments {

namespace {

constexpr std::size_t beside = 3;           // samples to each side
constexpr std::size_t phase_tolerance = 2;  // samples to each side of the same phase
constexpr std::size_t settling = 4;         // periods
constexpr double at_first = 4, while_settling = 2,
                 settled = 1.25;               // times those of the periods beside
constexpr double visible = 6, beyond = 4;      // standard deviations of differences
constexpr double visible_steps = 3;            // of the resolution
constexpr double usual_part = .9;              // of the changes
constexpr double to_deviation_of_all = 1.521;  // mean size of the smaller 90 % of normal values

/// Standard deviation of most; steps of the resolution average out, unlike in a median.
double deviation_of_most(std::vector<double> sizes) {
    if (sizes.empty()) return 0;
    std::ranges::sort(sizes);
    sizes.resize(std::max<std::size_t>(
        1, static_cast<std::size_t>(usual_part * static_cast<double>(sizes.size()))));
    return to_deviation_of_all * std::accumulate(sizes.begin(), sizes.end(), 0.) /
           static_cast<double>(sizes.size());
}

/// From upright to upright [s].
struct Rolled {
    double begin = 0, end = 0;
    std::size_t count = 0;  // of the same amplitude before it
};

/// Changes from sample i to sample i + 1, beside those nearby and at the same phase.
class Changes {
  public:
    Changes(const Record& record, const DriveTimeline& timeline) : time_(record.time) {
        for (std::size_t i = 1; i < time_.size(); ++i)
            all_.push_back(record.shift[i] - record.shift[i - 1]);
        for (const auto& stage : timeline.stages)
            for (std::size_t n = 1; n < stage.upright.size(); ++n)
                periods_.push_back({stage.upright[n - 1], stage.upright[n], n - 1});
        at_rest_ = std::max(usual_step() * visible_steps / visible, noise_at_rest());
        rolling_ = std::max(at_rest_, noise_while_rolling());
    }

    std::size_t size() const { return all_.size(); }
    double operator[](std::size_t i) const { return all_[i]; }
    std::size_t n_periods() const { return periods_.size(); }

    bool is_jump(std::size_t i) const {
        const double sign = all_[i] < 0 ? -1 : 1, size = std::abs(all_[i]);
        const auto n = period_of(i);
        const double noise = n ? rolling_ : at_rest_;
        if (size < visible * noise || is_gap(i)) return false;
        return size - largest_expected(i, n, sign) > beyond * noise && stays(i);
    }

  private:
    double length(std::size_t i) const { return time_[i + 1] - time_[i]; }
    double middle(std::size_t i) const { return (time_[i] + time_[i + 1]) / 2; }

    std::optional<std::size_t> period_of(std::size_t i) const {
        const double t = middle(i);
        const auto after = std::ranges::upper_bound(periods_, t, {}, &Rolled::begin);
        if (after == periods_.begin() || (after - 1)->end < t) return {};
        return static_cast<std::size_t>(after - periods_.begin()) - 1;
    }

    /// The change at the same phase of another period.
    std::size_t same_phase(std::size_t i, std::size_t period, std::size_t other) const {
        const Rolled &from = periods_[period], &to = periods_[other];
        const double t =
            to.begin + (middle(i) - from.begin) / (from.end - from.begin) * (to.end - to.begin);
        const auto k = std::ranges::upper_bound(time_, t) - time_.begin();
        return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(k - 1, 0, std::ssize(all_) - 1));
    }

    bool is_gap(std::size_t i) const {
        double longest = 0;
        for (std::size_t k = 1; k <= beside; ++k)
            longest = std::max({longest, length(i - k), length(i + k)});
        return length(i) > gap_factor * longest;
    }

    /// Of change k in this sense, in the time that change i takes.
    double scaled(std::size_t k, std::size_t i, double sign) const {
        return sign * all_[k] * std::max(1., length(i) / length(k));
    }

    double largest_expected(std::size_t i, std::optional<std::size_t> n, double sign) const {
        double largest = 0;
        for (std::size_t k = 1; k <= beside; ++k)
            largest = std::max({largest, scaled(i - k, i, sign), scaled(i + k, i, sign)});
        if (!n) return largest;
        const std::size_t last_period = periods_.size() - 1;
        const std::size_t count = periods_[*n].count;
        const double factor = count == 0 ? at_first : count < settling ? while_settling : settled;
        const auto add = [&](std::size_t other) {
            const std::size_t same = same_phase(i, *n, other);
            const std::size_t last = std::min(same + phase_tolerance, all_.size() - 1);
            for (std::size_t k = same - std::min(same, phase_tolerance); k <= last; ++k)
                largest = std::max(largest, factor * scaled(k, i, sign));
        };
        if (*n > 0) add(*n - 1);
        if (*n < last_period) add(*n + 1);
        if (*n == 0 && last_period > 1) add(2);
        if (*n == last_period && last_period > 1) add(last_period - 2);
        return largest;
    }

    /// Nor do the changes beside it undo it, but for what is usual there.
    bool stays(std::size_t i) const {
        double usual = 0;
        for (std::size_t k = 2; k <= beside; ++k) usual += all_[i - k] + all_[i + k];
        usual /= 2. * (beside - 1);
        return (all_[i - 1] + all_[i] + all_[i + 1] - 2 * usual) / all_[i] > .5;
    }

    /// Of the rest: that of the resolution, where the noise is below it.
    double usual_step() const {
        std::vector<double> sizes;
        for (std::size_t i = 0; i < all_.size(); ++i)
            if (all_[i] != 0 && !period_of(i)) sizes.push_back(std::abs(all_[i]));
        return sizes.empty() ? 0 : statistics::median(std::move(sizes));
    }

    double noise_at_rest() const {
        std::vector<double> sizes;
        for (std::size_t i = 0; i < all_.size(); ++i)
            if (!period_of(i)) sizes.push_back(std::abs(all_[i]));
        return deviation_of_most(std::move(sizes));
    }

    double noise_while_rolling() const {
        std::vector<double> sizes;
        for (std::size_t i = 0; i < all_.size(); ++i)
            if (const auto n = period_of(i); n && *n > 0)
                sizes.push_back(std::abs(all_[i] - all_[same_phase(i, *n, *n - 1)]));
        return deviation_of_most(std::move(sizes)) / std::sqrt(2.);
    }

    const std::vector<double>& time_;
    std::vector<double> all_;
    std::vector<Rolled> periods_;
    double at_rest_ = 0, rolling_ = 0;  // standard deviations of the changes
};

}  // namespace

namespace {

/// Without pairs that lead there and back: outliers.
std::vector<std::size_t> without_returns(const std::vector<std::size_t>& found,
                                         const Changes& changes) {
    constexpr double agreement = 4;
    std::vector<std::size_t> kept;
    for (std::size_t k = 0; k < found.size(); ++k) {
        const double there = changes[found[k]];
        const bool is_next = k + 1 < found.size() && found[k + 1] - found[k] <= longest_outlier;
        const double back = is_next ? changes[found[k + 1]] : 0;
        if (there * back < 0 &&
            std::abs(there + back) < std::min(std::abs(there), std::abs(back)) / agreement)
            ++k;
        else
            kept.push_back(found[k]);
    }
    return kept;
}

}  // namespace

void find_jumps(const Record& record, const DriveTimeline& timeline, std::optional<double> loading,
                RecordFindings& findings) {
    const Changes changes(record, timeline);
    std::vector<std::size_t> jumps;
    for (std::size_t i = beside; i + beside < changes.size(); ++i) {
        const bool is_loading =
            loading && record.time[i] <= *loading && *loading <= record.time[i + 1];
        if (!is_loading && changes.is_jump(i)) jumps.push_back(i);
    }
    jumps = without_returns(jumps, changes);
    if (jumps.empty()) return;
    const bool recurs = 2 * jumps.size() > changes.n_periods();
    const std::size_t most =
        *std::ranges::max_element(jumps, {}, [&](std::size_t i) { return std::abs(changes[i]); });
    findings.push_back(
        {RecordFinding::Kind::jump,
         fmt::format(
             "the shift jumps by {} µm from one sample to the next at {} s{}, and stays there{}",
             report::significant(1e6 * changes[most], 3),
             report::significant(record.time[most + 1], 4),
             jumps.size() == 1 ? "" : fmt::format(", the largest of {} jumps", jumps.size()),
             recurs ? ": if the contact does not slip at once, the record is wrong"
                    : ": correct the record, or give record.loading if F_T was applied then"),
         !recurs});
}

}  // namespace tricontact::experiments
