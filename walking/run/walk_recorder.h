#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "walking/machine/spot_view.h"
#include "walking/machine/stretch_recorder.h"
#include "walking/machine/walk_record.h"
#include "walking/run/drift.h"

namespace tricontact::walking {

/// Follows a run step by step: windows of equal length and returns to the Poincare section.
class WalkRecorder {
  public:
    /// `start`: the machine is taken to be at rest before. `step` > 0: between two motions;
    /// `window` > 0: steps of a window.
    WalkRecorder(const Machine& machine, const Motion& start, double step, std::int64_t window);

    /// Next step of the run: of the machine's springs and what they did in it. What is recorded is
    /// that of its spots.
    void add(const Motion& spring_motion, const std::vector<SpotStep>& spring_steps);

    /// Windows so far. An unfinished one counts where it is the only one, or else lengthens the
    /// last.
    std::vector<WalkWindow> windows() const;

    /// Returns that were followed by another one.
    const std::vector<SectionReturn>& returns() const { return returns_; }

    /// Of an excitation while the base stands still, so far; else none.
    std::vector<ExcitedPeriod> periods() const;

  private:
    void end_stretch();

    double base_velocity_;  // kappa6
    SpotView view_;
    Motion last_;
    StretchRecorder stretch_;
    std::int64_t window_;
    std::vector<WalkWindow> windows_;
    WalkWindow open_window_;
    std::vector<SectionReturn> returns_;
    std::optional<SectionReturn> open_return_;
    std::optional<PeriodRecorder> periods_;
};

}  // namespace tricontact::walking
