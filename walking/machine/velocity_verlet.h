#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "walking/machine/machine.h"
#include "walking/machine/motion.h"

namespace tricontact::walking {

/// What a contact spot did in a step.
struct SpotStep {
    bool sticks = false;    ///< in contact, below its friction bound; a released spot does not
    double slip = 0;        ///< increment of slip along the motion: trial minus new deflection
    double flank_slip = 0;  ///< along the flank of a prism
};

/// Spring with a Coulomb slider: a new approach and an increment of tangential displacement. A spot
/// in the air has no deflection, and lands with none. Wetter (2016), eqs. B.4.1 to B.4.4.
/// `bound`: friction bound over tangential stiffness, mu kappa2 times the normal deflection.
inline SpotStep advance_flat(SpotDeflection& spot, double approach, double bound,
                             double tangential_increment) {
    spot.normal = std::max(0., approach);
    const double trial = spot.tangential + tangential_increment;
    spot.tangential = std::clamp(trial, -bound, bound);
    return {.sticks = std::abs(trial) < bound, .slip = trial - spot.tangential};
}

/// The same on a flank: two tangential directions under one bound, radial return. Wetter (2016),
/// eqs. B.4.5 to B.4.9, with the sign of the flank's deflection that follows from its geometry.
/// `approach` and its bound: normal to the flank.
inline SpotStep advance_on_flank(SpotDeflection& spot, double approach, double bound,
                                 double tangential_increment, double flank_increment) {
    spot.normal = std::max(0., approach);
    const double x = spot.tangential + tangential_increment, s = spot.flank + flank_increment;
    const double length = std::hypot(x, s);
    const double factor = length < bound ? 1 : bound / length;
    spot.tangential = length > 0 ? factor * x : 0;
    spot.flank = length > 0 ? factor * s : 0;
    return {.sticks = length < bound, .slip = x - spot.tangential, .flank_slip = s - spot.flank};
}

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
