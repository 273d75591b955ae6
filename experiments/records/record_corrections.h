#pragma once

#include <vector>

#include "experiments/records/drive_timeline.h"
#include "experiments/records/experiment_run.h"
#include "experiments/records/loading_time.h"

namespace tricontact::experiments {

/// Successive samples.
struct RecordPart {
    std::vector<double> time, shift, offset;
};

/// Noise, drift and zero of a record, found in its rests, and values that are rid of them.
class RecordCorrections {
  public:
    /// Tells `run` what it finds. Throws contact::InputError where the rest before rolling is too
    /// short, or nothing rises though record.loading says when F_T was applied.
    RecordCorrections(const Record& record, const Experiment& experiment,
                      const DriveTimeline& timeline, RunEvaluation& run);

    /// Mean time between samples of the rest [s].
    double mean_interval() const;
    /// Before the first period.
    void add_static(StageEvaluation& stage) const;
    /// Near an instant with the roller upright: the value at offset 0 of the parabola over the
    /// offset, free of what the table adds in proportion to it, and of what the contact adds to
    /// both sides alike.
    void add_upright(StageEvaluation& stage, double upright, double period);
    /// Noise while it rolls over that of the rest: of what parabolas over the offset leave.
    double noise_ratio() const;
    /// What a drift that changed before rolling does to the zero [m].
    double drifted_zero() const { return drifted_zero_; }
    double loading() const { return loading_; }
    RecordPart rest(double from, double to) const;

  private:
    LoadingTime found_loading(double stated);
    void know_noise(double resolution);
    void subtract_zero(std::size_t n_unloaded);
    void add(StageEvaluation& stage, double at, const RecordPart& part,
             const std::vector<double>& weights) const;
    void add_residuals(const RecordPart& part);

    const Record& record_;
    const DriveTimeline& timeline_;
    RunEvaluation& run_;
    RecordPart rest_;
    double loading_ = 0, zero_error_ = 0, drifted_zero_ = 0;
    double squares_ = 0, freedom_ = 0;  // of residuals while it rolls
    double reference_ = 0;              // where the drift has no error [s]
};

}  // namespace tricontact::experiments
