#include "experiments/records/drive_timeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "statistics/estimate.h"

namespace tricontact::experiments {

namespace {

using Stage = DriveTimeline::Stage;

constexpr double same_amplitude = 0.01;  // relative; stages of the rig differ by 3 % and more
constexpr double gap_share = 1. / 12;    // of a period: sampling that suffices has a 32nd
constexpr double hiding_share = .4;      // of a period: a gap that may hide half of it

/// From the roller upright to the roller upright.
struct Period {
    double begin = 0, end = 0;  // [s]
    double amplitude = 0;       // [m]
    double extent = 0;          // half the distance of its turning points [m]
};

/// Periods in a recorded drive.
class RecordedDrive {
  public:
    explicit RecordedDrive(const Record& record) : time_(record.time), offset_(record.drive) {
        for (const double w : offset_) largest_ = std::max(largest_, std::abs(w));
        if (largest_ == 0)
            refuse_record(record, "the drive does not move", "check the column drive");
        refuse_rest_aside(record);
        // Rest is where the drive is nearer to upright than a tenth of its largest amplitude.
        const auto first = std::ranges::find_if(
            offset_, [this](double w) { return std::abs(w) > threshold() * largest_; });
        if (*first < 0)
            for (double& w : offset_) w = -w;
    }

    // Out to one side, across to the other, and back.
    std::vector<Period> periods() const {
        std::vector<Period> found;
        const double far = threshold() * largest_;
        std::size_t i = 0;
        for (;;) {
            const std::size_t out = next(i, [far](double w) { return w > far; });
            const std::size_t across = next(out, [far](double w) { return w < -far; });
            const std::size_t back = next(across, [far](double w) { return w > -far; });
            if (back == offset_.size()) break;
            Period period;
            const double top = *std::max_element(at(out), at(across));
            const double bottom = *std::min_element(at(across), at(back));
            period.begin = upright_before(out, top);
            period.end = upright_after(back, bottom);
            period.extent = (top - bottom) / 2;
            if (period.end > time_.back()) break;
            found.push_back(period);
            i = back;
        }
        fill_in(found);
        for (Period& period : found) period.amplitude = 2 * mean_distance(period);
        return found;
    }

  private:
    static constexpr double threshold() { return 0.1; }

    // What stands aside before it rolls counts from elsewhere than upright.
    void refuse_rest_aside(const Record& record) const {
        constexpr std::size_t n_first = 8;
        constexpr double still = .02, not_upright = .05;
        if (offset_.size() < n_first) return;
        const auto [low, high] = std::minmax_element(at(0), at(n_first));
        const double aside = std::min(std::abs(*low), std::abs(*high));
        if (*high - *low > still * largest_ || aside < not_upright * largest_) return;
        refuse_record(
            record,
            fmt::format("the drive stands at {:.4g} mm before it rolls: its offsets count "
                        "from the roller upright, at which periods begin and end",
                        1e3 * *low),
            "subtract that from the column drive, or record from upright");
    }

    std::vector<double>::const_iterator at(std::size_t i) const {
        return offset_.begin() + static_cast<std::ptrdiff_t>(i);
    }
    template <class Condition>
    std::size_t next(std::size_t from, Condition condition) const {
        return static_cast<std::size_t>(std::find_if(at(from), offset_.end(), condition) -
                                        offset_.begin());
    }

    // Ends whose flanks fell into a gap of the record: from the next flank, else from the periods
    // beside them.
    static void fill_in(std::vector<Period>& periods) {
        double usual = 0;
        int n = 0;
        for (const Period& period : periods)
            if (std::isfinite(period.end - period.begin)) {
                usual += period.end - period.begin;
                ++n;
            }
        usual /= n;
        if (!periods.empty() && !std::isfinite(periods.front().begin))
            periods.front().begin = periods.front().end - usual;
        for (std::size_t k = 0; k < periods.size(); ++k) {
            Period& period = periods[k];
            if (!std::isfinite(period.begin)) period.begin = periods[k - 1].end;
            if (std::isfinite(period.end)) continue;
            const bool leads_on = k + 1 < periods.size() && std::isfinite(periods[k + 1].begin);
            period.end = leads_on ? periods[k + 1].begin : period.begin + usual;
        }
    }

    // Where the straight line through a flank, between a tenth and a half of its height, is zero;
    // NaN where fewer than two samples lie on it.
    double zero_of(std::size_t from, std::size_t to, double height) const {
        double n = 0, t = 0, w = 0, tt = 0, tw = 0;
        const double origin = time_[from];
        for (std::size_t k = from; k <= to; ++k) {
            const double ratio = offset_[k] / height;
            if (ratio < 0.1 || ratio > 0.5) continue;
            const double x = time_[k] - origin;
            n += 1, t += x, w += offset_[k], tt += x * x, tw += x * offset_[k];
        }
        const double slope = (n * tw - t * w) / (n * tt - t * t);
        return n < 2 ? contact::undefined : origin + (t - w / slope) / n;
    }
    // The flank that leads to the turning point beyond sample i.
    double upright_before(std::size_t i, double height) const {
        std::size_t from = i;
        while (from > 0 && offset_[from - 1] / height > 0.1) --from;
        std::size_t to = i;
        while (to + 1 < offset_.size() && offset_[to + 1] / height < 0.5) ++to;
        return zero_of(from, to + 1 < offset_.size() ? to + 1 : to, height);
    }
    // The flank that ends before sample i.
    double upright_after(std::size_t i, double height) const {
        std::size_t from = i;
        while (from > 0 && offset_[from - 1] / height < 0.5) --from;
        return zero_of(from, i, height);
    }

    // A drive of constant speed is W/2 away on the average; gaps count in neither.
    double mean_distance(const Period& period) const {
        const double duration = period.end - period.begin;
        const double longest = gap_share * duration;
        double sum = 0, left_out = 0, t_before = period.begin, w_before = 0;
        const auto add = [&](double t, double w) {
            if (t - t_before > longest)
                left_out += distance_until((t - period.begin) / duration) -
                            distance_until((t_before - period.begin) / duration);
            else
                sum += (t - t_before) * (w + w_before) / 2;
            t_before = t;
            w_before = w;
        };
        for (std::size_t k = 0; k < time_.size() && time_[k] < period.end; ++k)
            if (time_[k] > period.begin) add(time_[k], std::abs(offset_[k]));
        add(period.end, 0);
        return sum / (duration * (1 - left_out));
    }

    // What a drive of constant speed has behind it at a phase of its distances over a whole period.
    static double distance_until(double phase) {
        const double half = 2 * phase, part = half - std::floor(half);
        return (std::floor(half) +
                (part < .5 ? 2 * part * part : 1 - 2 * (1 - part) * (1 - part))) /
               2;
    }

    const std::vector<double>& time_;
    std::vector<double> offset_;
    double largest_ = 0;
};

std::vector<Stage> stages_of(const std::vector<Period>& periods) {
    std::vector<Stage> stages;
    std::vector<double> extents;
    double sum = 0;
    for (const Period& period : periods) {
        const double mean = stages.empty() ? 0 : sum / stages.back().periods();
        if (stages.empty() || std::abs(period.amplitude - mean) > same_amplitude * mean) {
            stages.push_back({0, {period.begin}});
            sum = 0;
            extents.clear();
        }
        stages.back().upright.push_back(period.end);
        sum += period.amplitude;
        stages.back().amplitude = sum / stages.back().periods();
        extents.push_back(period.extent);
        stages.back().extent = statistics::median(extents);
    }
    return stages;
}

Stage known_stage(const Record& record, const Experiment& experiment) {
    const auto& drive = experiment.drive;
    const double period = drive.period  ? *drive.period
                          : drive.speed ? 4 * *drive.amplitude / *drive.speed
                                        : shift_period(record, *drive.start, *drive.periods);
    Stage stage{drive.amplitude.value_or(0), {}};
    for (int n = 0; n <= *drive.periods; ++n) stage.upright.push_back(*drive.start + n * period);
    if (stage.upright.front() < record.time.front() || stage.upright.back() > record.time.back())
        refuse_record(record,
                      fmt::format("{} periods of {:.4g} s from {:.4g} s on do not lie in the "
                                  "record, which is from {:.4g} s to {:.4g} s",
                                  *drive.periods, period, *drive.start, record.time.front(),
                                  record.time.back()),
                      "correct start, period or periods in [drive]");
    return stage;
}

// Out, back, to the other side, and back at constant speed; 1 at the turning points.
double triangle(double phase) {
    const double part = phase - std::floor(phase);
    return part < 0.25 ? 4 * part : part < 0.75 ? 2 - 4 * part : 4 * part - 4;
}

std::vector<double> known_offsets(const std::vector<double>& time, const Stage& stage) {
    std::vector<double> offset;
    const double amplitude = stage.amplitude > 0 ? stage.amplitude : 1;
    for (const double t : time) {
        const bool rolling = t > stage.upright.front() && t < stage.upright.back();
        const double phase = (t - stage.upright.front()) / stage.period();
        offset.push_back(rolling ? amplitude * triangle(phase) : 0);
    }
    return offset;
}

// A gap that may hide half a period; a shorter one leaves samples on both sides of upright.
void check_gaps(const Record& record, const DriveTimeline& timeline) {
    double shortest = timeline.stages.front().period();
    for (const Stage& stage : timeline.stages)
        for (std::size_t n = 1; n < stage.upright.size(); ++n)
            shortest = std::min(shortest, stage.upright[n] - stage.upright[n - 1]);
    for (std::size_t k = 1; k < record.time.size(); ++k) {
        const double from = record.time[k - 1], to = record.time[k];
        if (to - from <= hiding_share * shortest || to < timeline.start() || from > timeline.end())
            continue;
        if (from < timeline.start() && to <= timeline.start() + gap_share * shortest) continue;
        if (to - from < 2 * (record.time.back() - record.time.front()) /
                            static_cast<double>(record.time.size()))
            continue;  // sampled as slowly throughout
        refuse_record(
            record,
            fmt::format("there is a gap of {:.3g} s at {:.4g} s: what the drive did there "
                        "is not known",
                        to - from, from),
            "leave this run out, or cut the record before the gap");
    }
}

void check_sampling(const Record& record, const DriveTimeline& timeline) {
    for (const Stage& stage : timeline.stages)
        for (int n = 1; n <= stage.periods(); ++n) {
            const auto k = static_cast<std::size_t>(n);
            const auto from = std::ranges::lower_bound(record.time, stage.upright[k - 1]);
            const auto to = std::ranges::lower_bound(record.time, stage.upright[k]);
            if (to - from < fewest_samples)
                refuse_record(
                    record,
                    fmt::format(
                        "the period from {:.4g} s to {:.4g} s has {} samples, fewer than {}",
                        stage.upright[k - 1], stage.upright[k], to - from, fewest_samples),
                    "sample faster");
        }
}

}  // namespace

void refuse_record(const Record& record, const std::string& rule, const std::string& remedy) {
    throw contact::InputError(fmt::format("{}: {}; {}", record.name, rule, remedy));
}

DriveTimeline drive_timeline(const Record& record, const Experiment& experiment) {
    DriveTimeline timeline;
    if (record.drive.empty()) {
        timeline.stages = {known_stage(record, experiment)};
        timeline.offset = known_offsets(record.time, timeline.stages.front());
    } else {
        timeline.stages = stages_of(RecordedDrive(record).periods());
        timeline.offset = record.drive;
        if (timeline.stages.empty())
            refuse_record(record, "the drive completes no period", "record at least one");
    }
    check_gaps(record, timeline);
    check_sampling(record, timeline);
    return timeline;
}

}  // namespace tricontact::experiments
