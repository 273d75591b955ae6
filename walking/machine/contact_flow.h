#pragma once

#include <array>
#include <vector>

#include "walking/machine/machine.h"
#include "walking/machine/motion.h"
#include "walking/machine/walk_record.h"

namespace tricontact::walking {

/// What a spot does until the next event.
struct ContactMode {
    bool touches = false;  ///< the ground; else it has no normal deflection
    /// Released: no friction. A spot whose friction bound is constant (Mechanisms::coupling false)
    /// sticks or slips in the air as well.
    SpotState state = SpotState::released;
    std::array<double, 2> direction = {0, 0};  ///< of slip, along the motion and the flank
};

/// A quantity that stays positive until an event, and its rate; infinite where there is none.
struct Guard {
    double value = 0, rate = 0;
};

/// Equations of motion between two events: smooth, as every spot stays in its mode. A sticking
/// spot's deflection follows the body, u' = v; a slipping one lies on its bound,
/// u' = bound' e + (v - e (e v)), e = u/|u|: the limit of the contact element for small steps.
class ContactFlow {
  public:
    /// y = x_s - x, z, phi, x', z', phi', two deflections of each spot, and the works of base,
    /// excitation, geometric moment and slip, over kappa4. Displacements in units of b.
    using State = std::vector<double>;
    static constexpr std::size_t n_works = 4;

    /// `smallest`: deflection [b] below which the stored direction of slip is taken, not u/|u|.
    ContactFlow(Machine machine, double smallest);

    static State state_of(const Motion& motion);
    /// `base`: x_s, which a state is relative to.
    Motion motion_of(const State& state, const std::vector<ContactMode>& modes, double time,
                     double base) const;

    /// Modes in which a motion goes on. Throws std::invalid_argument where a deflection exceeds
    /// its bound.
    std::vector<ContactMode> modes_of(const State& state) const;

    void derivative(const State& state, const std::vector<ContactMode>& modes, double time,
                    State& rate) const;

    /// Two of each spot: its touching the ground or not, and its friction.
    std::vector<Guard> guards(const State& state, const std::vector<ContactMode>& modes,
                              double time) const;

    /// What follows when a guard has fallen below zero.
    void pass(std::size_t guard, State& state, std::vector<ContactMode>& modes) const;

    const Machine& machine() const { return machine_; }
    const std::vector<Spot>& spots() const { return spots_; }

  private:
    struct Kinematics;
    static void land(const Kinematics& spot, ContactMode& mode);
    Kinematics kinematics(const State& state, const ContactMode& mode, std::size_t spot) const;

    Machine machine_;
    std::vector<Spot> spots_;
    double slope_;  // of a flank; 1 on flat ground
    double rest_;   // static displacement
    double smallest_;
};

}  // namespace tricontact::walking
