#include "experiments/records/recorded_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/base/error.h"
#include "contact/load_path.h"
#include "contact/path_cycles.h"
#include "experiments/records/experiment_run.h"
#include "experiments/records/loading_time.h"
#include "experiments/records/record_noise.h"

namespace tricontact::experiments {

namespace {

using contact::Case;
using contact::NormalControl;
using contact::TangentialControl;
using Row = contact::PrescribedPath::Row;
using Stages = std::vector<DriveTimeline::Stage>;

constexpr int rest_parts = 4;

/// A force while it rolls or rests: recorded, or what the case says.
class Force {
  public:
    Force(const Record& record, const std::vector<double>& samples, double stated)
        : record_(record), samples_(samples), stated_(stated) {
        steps_ = record.time.back() - record.time.front();
        steps_ /= static_cast<double>(record.time.size() - 1);
    }

    bool is_recorded() const { return !samples_.empty(); }
    /// By the straight line through what is within `reach` of t [s].
    double at(double t, double reach) const { return value(t, t - reach, t + reach); }
    double mean(double from, double to) const {
        if (!is_recorded()) return stated_;
        const auto [begin, end] = within(from, to);
        double sum = 0;
        for (std::size_t i = begin; i < end; ++i) sum += samples_[i];
        return sum / static_cast<double>(end - begin);
    }
    /// By the straight line through what lies between these times [s].
    double value(double t, double from, double to) const {
        if (!is_recorded()) return stated_;
        const auto [begin, end] =
            within(std::min(from, t - 2 * steps_), std::max(to, t + 2 * steps_));
        std::vector<double> times, values;
        for (std::size_t i = begin; i < end; ++i) {
            times.push_back(record_.time[i]);
            values.push_back(samples_[i]);
        }
        return weighted(weights_of_polynomial_at(t, times, 1), values);
    }

  private:
    /// At least one sample.
    std::pair<std::size_t, std::size_t> within(double from, double to) const {
        const auto begin = std::ranges::lower_bound(record_.time, from) - record_.time.begin();
        const auto end = std::ranges::upper_bound(record_.time, to) - record_.time.begin();
        const auto last = static_cast<std::ptrdiff_t>(record_.time.size());
        const auto first = std::min(begin, last - 1);
        return {static_cast<std::size_t>(first),
                static_cast<std::size_t>(std::max(end, first + 1))};
    }

    const Record& record_;
    const std::vector<double>& samples_;
    double stated_ = 0, steps_ = 0;  // mean time between samples
};

/// What one record prescribes.
class RowsOfRecord {
  public:
    RowsOfRecord(const Record& record, const Experiment& experiment, const Case& c, int steps)
        : record_(record),
          normal_(record, record.normal_force, *c.load.normal_force),
          tangential_(record, record.tangential_force, *c.load.tangential_force),
          hold_(c.load.hold),
          steps_(steps) {
        stages_ = drive_timeline(record, experiment).stages;
        if (stages_.front().amplitude == 0) stages_.front().amplitude = *c.rolling->amplitude;
        loading_ =
            experiment.loading
                ? loading_time(record, *experiment.loading, stages_.front().upright.front()).time
                : record.time.front();
        is_whole_ = experiment.loading.has_value();
    }

    const Stages& stages() const { return stages_; }

    /// Where the rest after the rolling begins [s].
    double stands_from() const {
        return stages_.back().upright.back() + stopping * stages_.back().period();
    }
    bool rests_after() const {
        return std::ranges::count_if(record_.time, [&](double t) { return t >= stands_from(); }) >=
               static_cast<std::ptrdiff_t>(fewest_rest_samples);
    }

    /// `periods` of each stage.
    void add(RecordedPath& to, const std::vector<int>& periods, bool with_rest_after) {
        path_ = &to;
        add_rest();
        for (std::size_t k = 0; k < stages_.size(); ++k) add_stage(stages_[k], periods[k]);
        if (with_rest_after) add_rest_after(periods.back());
    }

  private:
    int last_row() const { return static_cast<int>(path_->path.rows.size()) - 1; }

    void add_row(double time, double offset, double normal, double tangential) {
        Row row;
        row.time = time;
        row.offset = {offset, 0};
        row.normal = {NormalControl::Kind::force, normal};
        row.tangential[0] = {TangentialControl::Kind::force, tangential};
        path_->path.rows.push_back(row);
    }

    /// Times count from the first touch with F_N; a hold that the record does not show precedes it.
    void add_rest() {
        const double start = stages_.front().upright.front(), rest = start - loading_;
        const double first = record_.time.front();
        const bool sees_pressing = is_whole_ && loading_ > first;
        add_row(0, 0,
                sees_pressing ? normal_.mean(first, loading_) : normal_.at(loading_, rest / 8),
                sees_pressing && tangential_.is_recorded() ? tangential_.mean(first, loading_) : 0);
        // At once: within a thousandth of the rest.
        const double missing = is_whole_ ? 0 : std::max(0., hold_ - rest);
        origin_ = loading_ - missing - rest / 1000;
        const double part = rest / rest_parts;
        const auto at_rest = [&](double t, double time) {
            const double from = std::max(loading_, t - part / 2),
                         to = std::min(start, t + part / 2);
            add_row(time, 0, normal_.value(t, from, to), tangential_.value(t, from, to));
        };
        add_row(rest / 1000, 0, normal_.mean(loading_, loading_ + part),
                tangential_.mean(loading_, loading_ + part));
        for (int k = 1; k <= rest_parts; ++k) {
            at_rest(loading_ + k * part, loading_ + k * part - origin_);
            // As the record is read: a load that is applied in it has half of the rest to settle.
            if (!is_whole_ || 2 * k >= rest_parts) path_->rest.push_back(last_row());
        }
        path_->reads_zero = is_whole_;
        path_->unloaded_time = (first + loading_) / 2 - origin_;
    }

    /// Its last period may have been left out: repeats have equally many.
    void add_rest_after(int periods) {
        const double left_out = stages_.back().upright.back() -
                                stages_.back().upright[static_cast<std::size_t>(periods)];
        const double from = stands_from(), to = record_.time.back(), reach = (to - from) / 8;
        for (const double t : {from, (from + to) / 2, to}) {
            add_row(t - left_out - origin_, 0, normal_.value(t, t - reach, t + reach),
                    tangential_.value(t, t - reach, t + reach));
            path_->rest_after.push_back(last_row());
        }
    }

    void add_stage(const DriveTimeline::Stage& stage, int periods) {
        const auto& upright = stage.upright;
        const int n = 4 * steps_;
        const double reach = stage.period() / (2 * n);
        auto& rows = path_->upright.emplace_back();
        const double begin = upright.front() - origin_;
        if (begin > path_->path.rows.back().time + reach)  // it stood between two stages
            add_row(begin, 0, normal_.at(upright.front(), reach),
                    tangential_.at(upright.front(), reach));
        rows.push_back(last_row());
        for (int p = 0; p < periods; ++p) {
            const double from = upright[static_cast<std::size_t>(p)],
                         to = upright[static_cast<std::size_t>(p) + 1];
            for (int k = 1; k <= n; ++k) {
                const double phase = static_cast<double>(k) / n;
                const double t = from + phase * (to - from);
                add_row(t - origin_, stage.amplitude * contact::triangle_wave(phase),
                        normal_.at(t, reach), tangential_.at(t, reach));
            }
            rows.push_back(last_row());
        }
    }

    const Record& record_;
    Force normal_, tangential_;
    Stages stages_;
    double hold_ = 0, loading_ = 0, origin_ = 0;
    bool is_whole_ = false;
    int steps_ = 1;
    RecordedPath* path_ = nullptr;
};

/// Of all rows from the one on which F_T acts; its mean while it rolls.
template <class Of>
RecordedPath::Range range_of(const RecordedPath& recorded, const Of& of) {
    const auto& rows = recorded.path.rows;
    RecordedPath::Range range{of(rows[1]), 0, of(rows[1])};
    for (std::size_t r = 1; r < rows.size(); ++r) {
        range.low = std::min(range.low, of(rows[r]));
        range.high = std::max(range.high, of(rows[r]));
    }
    const auto first = static_cast<std::size_t>(recorded.upright.front().front()),
               end = static_cast<std::size_t>(recorded.upright.back().back()) + 1;
    for (std::size_t r = first; r < end; ++r)
        range.mean += of(rows[r]) / static_cast<double>(end - first);
    return range;
}

double normal_of(const Row& row) {
    return row.normal.value;
}
double tangential_of(const Row& row) {
    return row.tangential[0].value;
}

/// Means of paths with equally many rows.
RecordedPath mean_of_runs(std::vector<RecordedPath> runs) {
    RecordedPath mean = runs.front();
    const double n = static_cast<double>(runs.size());
    for (std::size_t r = 0; r < mean.path.rows.size(); ++r) {
        double time = 0, offset = 0, normal = 0, tangential = 0;
        for (const RecordedPath& run : runs) {
            const Row& row = run.path.rows[r];
            time += row.time / n;
            offset += row.offset[0] / n;
            normal += normal_of(row) / n;
            tangential += tangential_of(row) / n;
        }
        Row& row = mean.path.rows[r];
        row.time = time;
        row.offset[0] = offset;
        row.normal.value = normal;
        row.tangential[0].value = tangential;
    }
    return mean;
}

double ratio_to(double value, double reference) {
    return reference == 0 ? 1 : value / reference;
}

}  // namespace

bool records_forces(const Experiment& experiment) {
    return std::ranges::any_of(experiment.records, [](const Record& record) {
        return !record.normal_force.empty() || !record.tangential_force.empty();
    });
}

RecordedPath recorded_path(const Experiment& experiment, const Case& c, int steps_per_quarter) {
    std::vector<RowsOfRecord> records;
    for (const Record& record : experiment.records) {
        records.emplace_back(record, experiment, c, steps_per_quarter);
        if (experiment.kind == Experiment::Kind::limit) break;
    }
    std::vector<int> periods;
    for (const auto& stage : records.front().stages()) periods.push_back(stage.periods());
    for (const RowsOfRecord& record : records)
        periods.front() = std::min(periods.front(), record.stages().front().periods());
    std::vector<RecordedPath> runs;
    const bool all_rest = std::ranges::all_of(records, &RowsOfRecord::rests_after);
    for (RowsOfRecord& record : records) record.add(runs.emplace_back(), periods, all_rest);
    RecordedPath recorded = mean_of_runs(std::move(runs));
    recorded.normal_force = range_of(recorded, normal_of);
    recorded.normal_force.is_recorded = !experiment.records.front().normal_force.empty();
    recorded.tangential_force = range_of(recorded, tangential_of);
    recorded.tangential_force.is_recorded = !experiment.records.front().tangential_force.empty();
    return recorded;
}

Case RecordedPath::followed_by(const Case& c) const {
    Case followed = c;
    const double normal = ratio_to(*c.load.normal_force, normal_force.mean),
                 tangential = ratio_to(*c.load.tangential_force, tangential_force.mean);
    double farthest = 0;  // in the first stage
    for (int r = 0; r <= upright.front().back(); ++r)
        farthest = std::max(farthest, path.rows[static_cast<std::size_t>(r)].offset[0]);
    const double rolled = ratio_to(*c.rolling->amplitude, farthest);
    followed.prescribed_path = path;
    for (Row& row : followed.prescribed_path->rows) {
        const double along = rolled * row.offset[0];
        row.offset = {along * std::cos(c.rolling->angle), along * std::sin(c.rolling->angle)};
        row.normal.value *= normal;
        row.tangential[0].value *= tangential;
        if (!c.friction.is_coulomb()) continue;  // the model's own contact says what it carries
        const double limit = c.friction_coefficient() * row.normal.value;
        if (std::abs(row.tangential[0].value) >= limit)
            throw contact::InputError(
                fmt::format("the records: at {:.4g} s after loading F_T = {:.4g} N reaches mu F_N "
                            "= {:.4g} N, and the contact "
                            "slides; correct the forces, or friction.coefficient",
                            row.time, row.tangential[0].value, limit));
    }
    followed.rolling.reset();
    followed.load.normal_force = followed.prescribed_path->hardest_normal().value;
    followed.load.tangential_force = 0;
    followed.load.hold = 0;
    return followed;
}

std::vector<double> RecordedPath::shifts(const contact::History& history, double after,
                                         std::size_t stage) const {
    const auto steps = contact::steps_at_rows(history);
    const auto shift = [&](int row) { return steps[static_cast<std::size_t>(row)]->shift[0]; };
    const auto time = [&](int row) { return path.rows[static_cast<std::size_t>(row)].time; };
    const auto slope_of = [&](const std::vector<int>& rows) {
        std::vector<double> times, values;
        for (const int row : rows) {
            times.push_back(time(row));
            values.push_back(shift(row));
        }
        return weighted(weights_of_slope(times), values);
    };
    double slope = slope_of(rest);
    if (!rest_after.empty()) slope += after * (slope_of(rest_after) - slope);
    const double start = time(upright.front().front());
    const double zero = reads_zero ? shift(0) - slope * (unloaded_time - start) : shift(0);
    std::vector<double> shifts;
    for (const int row : upright[stage])
        shifts.push_back(shift(row) - slope * (time(row) - start) - zero);
    return shifts;
}

}  // namespace tricontact::experiments
