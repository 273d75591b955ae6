#include <complex>

#include "verification/verification_rows.h"
#include "walking/machine/energy.h"
#include "walking/machine/event_driven.h"
#include "walking/machine/linear_stability.h"
#include "walking/run/lyapunov.h"
#include "walking/run/walk.h"

namespace tricontact::verification {

namespace {

using walking::Kappas;
using walking::Machine;
using walking::Motion;

// Wetter (2016), eqs. 4.1.25 and 4.1.26.
constexpr Kappas set_a{2, 1.2, 0.5, 1e-4, 0.5, 1e-4, 0.42, 0.5};
constexpr Kappas set_b{2, 1.2, 0.5, 1e-4, 0.68, 1e-4, 0.42, 1.18};
constexpr const char* reference_integrator =
    "event-driven Runge-Kutta-Fehlberg 7(8) (docs/explanation/walking.md)";

constexpr double usual_step = 1e-3;

// A quantity with the usual step, its double and its half.
template <class Value>
void add_steps(VerificationRow row, Verification& all, const Value& value) {
    add_row(std::move(row), all, [&](int factor) -> LevelValue {
        const double step = 2 * usual_step / factor;
        return {step, value(step)};
    });
}

Motion verlet_motion(const Machine& machine, double step, double end) {
    walking::VelocityVerlet run(machine, motion_at_start(machine), step);
    for (auto n = std::lround(end / step); n > 0; --n) run.advance();
    return run.motion();
}

void add_motions(Verification& all) {
    const Machine block{.kappas = set_b, .mechanisms = {.vertical = false, .rotation = false}};
    const double end = 0.4, stiffness = set_b.kappa1 + 2, omega = std::sqrt(stiffness);
    // x'' = kappa1 (kappa6 t - x) - 2 x until the spots slip.
    const double exact = set_b.kappa1 * set_b.kappa6 / stiffness *
                         (end - std::sin(omega * end) / omega) / set_b.kappa4;
    add_steps({"Walking machine, a block that sticks", "x/kappa4, t = 0.4", "walk",
               "vibration on k_s and two contact spots", exact, 1e-5, 1.9},
              all, [&](double step) { return verlet_motion(block, step, end).x / set_b.kappa4; });
    const Machine walking{.kappas = set_b};
    walking::EventDriven reference(walking, motion_at_start(walking), 1e-13);
    reference.advance_to(10);
    const double rest = static_displacement(walking);
    add_steps({"Walking machine, set B", "z/z_stat, t = 10", "walk", reference_integrator,
               reference.motion().z / rest, 1e-5},
              all, [&](double step) { return verlet_motion(walking, step, 10).z / rest; });
}

void add_sliding(Verification& all) {
    add_steps({"Walking machine, set A", "mu_e", "walk", "steady sliding: mu N", 1, 1e-3}, all,
              [](double step) {
                  walking::WalkCase c;
                  c.machine.kappas = set_a;
                  c.time = {.step = step, .end = 4000};
                  return walking::walk(c).result.mu_e;
              });
    Machine machine{.kappas = set_b,
                    .model = Machine::Model::spots,
                    .spots = {{.position = -0.7}, {.position = 1.3, .stiffness = 0.9}}};
    machine.kappas.kappa5 = 0.6, machine.kappas.kappa8 = 0.8;
    const Motion steady = *steady_sliding(machine);
    const std::complex<double> leading = leading_eigenvalue(machine, steady);
    // Over half turns the distance of two runs grows by the rate alone.
    const double half_turn = std::numbers::pi / leading.imag();
    add_steps({"Walking machine, spots at -0.7 b and 1.3 b", "rate of flutter", "walk",
               "eigenvalue of steady sliding (docs/explanation/walking.md)", leading.real(), 1e-3},
              all, [&](double step) {
                  const double steps = std::round(half_turn / step);
                  return lyapunov_exponent(machine, steady,
                                           {.step = half_turn / steps,
                                            .interval = half_turn,
                                            .alignment = 40 * half_turn,
                                            .duration = 10 * half_turn})
                      .value;
              });
}

// What is left of the base's work in a period, over it, plus 1.
double balance_over(const Machine& machine, const walking::ReferenceCycle& cycle, double step) {
    Motion start = cycle.start;
    start.x -= start.base;  // where x is large, its rounding is
    start.base = 0;
    const double n_steps = std::round(cycle.period / step);
    walking::VelocityVerlet run(machine, start, cycle.period / n_steps);
    const auto balance = walking::verlet_balance(run, static_cast<int>(n_steps));
    return 1 + balance.residual() / balance.base;
}

void add_cycle(const Say& say, Verification& all) {
    const Machine machine{.kappas = set_b};
    say("walking machine, limit cycle of the reference integrator");
    walking::EventDriven reference(machine, motion_at_start(machine), 1e-12);
    // Chaotic for 1450 units of time on average.
    reference.advance_to(16000);
    const walking::ReferenceCycle cycle = reference_cycle(reference);
    add_steps({"Walking machine, limit cycle of set B", "work accounted for, over that of the base",
               "walk", "energy balance", 1, 1e-6},
              all, [&](double step) { return balance_over(machine, cycle, step); });
    say("walking machine, limit cycle by velocity Verlet");
    walking::WalkCase c;
    c.machine = machine;
    const walking::WalkResult found = walking::walk(c).result;
    const auto add = [&](const char* quantity, double exact, double value, double tolerance) {
        all.rows.push_back({"Walking machine, limit cycle of set B", quantity, "walk",
                            reference_integrator, exact, tolerance});
        all.rows.back().sizes = {usual_step};
        all.rows.back().values = {value};
    };
    // Onsets of stick and slip are seen at the steps, some 4300 in a period.
    add("period", cycle.period, found.period.value_or(0), 1e-6);
    add("mu_e", cycle.spring_force / sliding_force(machine), found.mu_e, 1e-4);
    add("z_min/z_stat", cycle.z_min / static_displacement(machine), found.z_min_ratio, 1e-5);
    add("stick time 1", cycle.stick_times[0], found.spots[0].stick_time, 1e-3);
    add("stick time 2", cycle.stick_times[1], found.spots[1].stick_time, 1e-3);
}

}  // namespace

void verify_walking(const Say& say, Verification& all) {
    say("walking machine");
    add_motions(all);
    add_sliding(all);
    add_cycle(say, all);
}

}  // namespace tricontact::verification
