#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "dynamics/stretch_recorder.h"
#include "dynamics/walk_record.h"

namespace tricontact::dynamics {

/// Follows a run step by step: windows of equal length and returns to the Poincare section.
class WalkRecorder {
  public:
    /// `start`: the machine is taken to be at rest before. `step` > 0: between two motions;
    /// `window` > 0: steps of a window.
    WalkRecorder(const Machine& machine, const Motion& start, double step, std::int64_t window);

    /// Next step of the run; `spot_steps` are what the spots did in it.
    void add(const Motion& motion, const std::vector<SpotStep>& spot_steps);

    /// Windows so far. An unfinished one counts where it is the only one, or else lengthens the
    /// last.
    std::vector<WalkWindow> windows() const;

    /// Returns that were followed by another one.
    const std::vector<SectionReturn>& returns() const { return returns_; }

  private:
    void end_stretch();

    double base_velocity_;  // kappa6
    StretchRecorder stretch_;
    std::int64_t window_;
    std::vector<WalkWindow> windows_;
    WalkWindow open_window_;
    std::vector<SectionReturn> returns_;
    std::optional<SectionReturn> open_return_;
    Motion last_;
};

}  // namespace tricontact::dynamics
