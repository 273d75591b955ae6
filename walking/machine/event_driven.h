#pragma once

#include <array>
#include <vector>

#include "walking/machine/energy.h"
#include "walking/machine/machine.h"
#include "walking/machine/motion.h"

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

/// Reference integrator: Runge-Kutta-Fehlberg 7(8) with error control between events (landing,
/// lift-off, onsets of slip and of stick), whose times it finds to rounding: for checking other
/// integrators, which step over events.
class EventDriven {
  public:
    /// `tolerance`: error of a step over the static displacement, 1e-14 to 1e-4. `start` has the
    /// spots of the machine, none deflected beyond its friction bound. Throws
    /// std::invalid_argument otherwise.
    EventDriven(const Machine& machine, const Motion& start, double tolerance);

    /// Throws contact::NotConverged if the steps shrink to nothing or the spots change their
    /// states without end at one time.
    void advance_to(double time);

    /// Advances to the next event, or to `time` if there is none before. Returns whether there was
    /// one. Throws as advance_to.
    bool advance_to_event(double time);

    /// Positions, deflections and velocities now.
    Motion motion() const;
    const std::vector<ContactMode>& modes() const { return modes_; }
    /// Since the start.
    EnergyBalance energy_balance() const;

  private:
    struct Crossing {
        std::size_t guard;
        double after;  // time since the step's start
    };

    auto equations() const;
    /// A step within the tolerance, not beyond `end`; returns its length.
    double take_step(double end, ContactFlow::State& next);
    ContactFlow::State after(double step) const;
    /// First guard to fall below zero in a step that leads to `end`; none: the number of guards.
    Crossing first_crossing(const ContactFlow::State& end, double step) const;
    double crossing_of(std::size_t guard, const Guard& start, const Guard& end, double step) const;
    void pass(const Crossing& crossing);

    ContactFlow flow_;
    double tolerance_;                // [b]
    double start_time_, start_base_;  // of the spring's base
    double start_energy_;
    double longest_step_, next_step_;
    double time_;
    ContactFlow::State state_;
    std::vector<ContactMode> modes_;
    std::size_t n_stalled_ = 0;  // events since time last went on
};

/// From one flight of the body to the next: a period of a limit cycle on which it flies once.
struct ReferenceCycle {
    Motion start = {};                     ///< the last spot lifts off
    double period = 0;                     ///< [sqrt(m/k_x)]
    double spring_force = 0;               ///< mean f_s, in units of k_x b
    std::vector<double> stick_times = {};  ///< shares of the period, in the order of spots_of
    double z_min = 0;                      ///< in units of b
    EnergyBalance balance = {};
};

/// Follows a run up to its next flight and from there to the one after that. Throws
/// contact::NotConverged if the body does not fly within 1000 units of time.
ReferenceCycle reference_cycle(EventDriven& run);

}  // namespace tricontact::walking
