#pragma once

#include <cstdint>
#include <vector>

#include "walking/machine/contact_element.h"
#include "walking/machine/forces.h"
#include "walking/machine/machine.h"
#include "walking/machine/motion.h"

namespace tricontact::walking {

/// Velocity Verlet of fixed step: second order where no spot changes its state. Wetter (2016),
/// section B.3, with the contacts of section B.4 after the positions.
class VelocityVerlet {
  public:
    /// `step` > 0, in units of sqrt(m/k_x), below stable_step. `start` has the springs of the
    /// machine. Throws std::invalid_argument if it has not.
    VelocityVerlet(Machine machine, Motion start, double step);

    void advance();

    const Machine& machine() const { return machine_; }
    const Motion& motion() const { return motion_; }
    double step() const { return step_; }
    /// What the springs did in the last step, in the order of springs_of.
    const std::vector<SpotStep>& spot_steps() const { return spot_steps_; }
    /// springs_of the machine.
    const std::vector<Spot>& spots() const { return spots_; }

  private:
    void advance_spots(double dx, double dz, double dphi);

    Machine machine_;
    std::vector<Spot> spots_;
    double rest_;  // static displacement
    Motion motion_;
    double step_;
    double start_time_, start_base_;
    std::int64_t n_steps_ = 0;
    Acceleration acceleration_;
    std::vector<SpotStep> spot_steps_;
};

}  // namespace tricontact::walking
