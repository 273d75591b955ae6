#pragma once

#include <cstdint>
#include <vector>

#include "walking/machine/contact_flow.h"
#include "walking/machine/energy.h"
#include "walking/machine/machine.h"
#include "walking/machine/motion.h"

namespace tricontact::walking {

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
    std::int64_t n_events() const { return n_events_; }

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
    std::int64_t n_events_ = 0;
    std::size_t n_stalled_ = 0;  // events since time last went on
};

}  // namespace tricontact::walking
