#pragma once

#include <cstdint>
#include <vector>

#include "dynamics/contact_element.h"
#include "dynamics/machine.h"
#include "dynamics/motion.h"
#include "dynamics/stretch_sums.h"

namespace tricontact::dynamics {

/// Sums up the steps of a run, stretch by stretch. The velocities of the spots, central
/// differences, are known a step later: what depends on them lags one step behind the rest.
class StretchRecorder {
  public:
    /// `start`: the machine is taken to be at rest before. `step` > 0: between two motions.
    StretchRecorder(const Machine& machine, const Motion& start, double step);

    /// Next step of the run; `spot_steps` are what the spots did in it.
    void add(const Motion& motion, const std::vector<SpotStep>& spot_steps);

    std::int64_t steps() const { return sums_.steps; }
    /// Sums since the start or the last take.
    const StretchSums& sums() const { return sums_; }
    /// The same, to start anew.
    StretchSums take();

  private:
    struct SpotPath {
        double before = 0, now = 0;  // s at the last two steps
        double normal = 0;           // n at the last step
    };

    Machine machine_;
    double step_;
    double rotational_;  // kappa7/kappa3^2
    std::vector<SpotPath> paths_;
    StretchSums sums_;
};

}  // namespace tricontact::dynamics
