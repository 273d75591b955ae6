#pragma once

#include <boost/circular_buffer.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "walking/machine/motion.h"
#include "walking/machine/stretch_recorder.h"
#include "walking/machine/velocity_verlet.h"
#include "walking/run/walk.h"

namespace tricontact::walking {

/// Keeps the first and the last snapshots of a run, whenever it ends.
class SnapshotRecorder {
  public:
    /// How many are kept of its beginning and, > 0, of its end.
    SnapshotRecorder(const Machine& machine, std::size_t first, std::size_t last)
        : n_first_(first), view_(machine), last_(last) {}

    void add(const VelocityVerlet& run);

    const std::vector<Snapshot>& first() const { return first_; }
    /// The last ones, at most `count` of them, in the order of time.
    std::vector<Snapshot> last(std::size_t count) const;

  private:
    std::size_t n_first_;
    SpotView view_;
    std::vector<Snapshot> first_;
    boost::circular_buffer<Snapshot> last_;
    Snapshot now_;
};

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
    const std::vector<ExcitedPeriod>& periods() const { return periods_; }

  private:
    void end_stretch();
    void add_to_period(const Motion& motion);

    double base_velocity_;  // kappa6
    SpotView view_;
    Motion last_;
    StretchRecorder stretch_;
    std::int64_t window_;
    std::vector<WalkWindow> windows_;
    WalkWindow open_window_;
    std::vector<SectionReturn> returns_;
    std::optional<SectionReturn> open_return_;
    double start_, period_ = 0;     // of the excitation; 0: none that is followed
    int steps_ = 0, airborne_ = 0;  // of its open period
    std::vector<ExcitedPeriod> periods_;
};

}  // namespace tricontact::walking
