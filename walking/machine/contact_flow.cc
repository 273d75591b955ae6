#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "walking/machine/energy.h"
#include "walking/machine/event_driven.h"
#include "walking/machine/motion.h"

namespace tricontact::walking {

namespace {

using Vector = std::array<double, 2>;

double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1];
}

Vector unit(const Vector& a) {
    const double length = std::hypot(a[0], a[1]);
    return length > 0 ? Vector{a[0] / length, a[1] / length} : Vector{};
}

// Places in a state.
enum : std::size_t { stretch, z, phi, x_velocity, z_velocity, phi_velocity, first_spot };

constexpr Guard none{std::numeric_limits<double>::infinity(), 0};

}  // namespace

// One spot in a state.
struct ContactFlow::Kinematics {
    double normal = 0, normal_rate = 0;  // normal to the ground, negative in the air
    double bound = 0, bound_rate = 0;    // of friction, over tangential stiffness
    Vector deflection = {}, velocity = {};
    Vector direction = {};  // e

    double slip_rate() const { return dot(direction, velocity) - bound_rate; }
    // The part of the velocity that turns the deflection.
    Vector turning() const {
        const double along = dot(direction, velocity);
        return {velocity[0] - along * direction[0], velocity[1] - along * direction[1]};
    }
};

ContactFlow::ContactFlow(Machine machine, double smallest)
    : machine_(std::move(machine)),
      spots_(springs_of(machine_)),
      slope_(machine_.model == Machine::Model::prism ? 1 / std::numbers::sqrt2 : 1),
      rest_(static_displacement(machine_)),
      smallest_(smallest) {}

ContactFlow::State ContactFlow::state_of(const Motion& motion) {
    State state{motion.base - motion.x, motion.z,          motion.phi,
                motion.x_velocity,      motion.z_velocity, motion.phi_velocity};
    for (const SpotDeflection& spot : motion.spots)
        state.insert(state.end(), {spot.tangential, spot.flank});
    state.resize(state.size() + n_works);
    return state;
}

ContactFlow::Kinematics ContactFlow::kinematics(const State& state, const ContactMode& mode,
                                                std::size_t i) const {
    const auto& [kappa1, kappa2, kappa3, kappa4, mu, kappa6, kappa7, kappa8] = machine_.kappas;
    const Spot& spot = spots_[i];
    const double stiffness = mu * kappa2, rotation = state[phi] / kappa3;
    const double lever = normal_lever(spot, rotation) / kappa3;
    const double rate = slope_ * (state[z_velocity] - lever * state[phi_velocity]);
    Kinematics at{.normal = slope_ * approach(spot, state[z], rotation),
                  .normal_rate = rate,
                  .deflection = {state[first_spot + 2 * i], state[first_spot + 2 * i + 1]},
                  .velocity = {state[x_velocity] + state[phi_velocity], 0}};
    if (!machine_.mechanisms.coupling)
        at.bound = stiffness * slope_ * std::max(0., rest_ - spot.height);
    else if (mode.touches)
        at.bound = stiffness * at.normal, at.bound_rate = stiffness * rate;
    const bool prism = machine_.model == Machine::Model::prism;
    if (prism) at.velocity[1] = rate;
    const bool turns = prism && std::hypot(at.deflection[0], at.deflection[1]) > smallest_;
    at.direction = mode.state == SpotState::slip && !turns ? mode.direction : unit(at.deflection);
    return at;
}

std::vector<ContactMode> ContactFlow::modes_of(const State& state) const {
    // A deflection on its bound may be beyond it by the rounding of the positions it stems from.
    constexpr double rounding = 1e-9;
    std::vector<ContactMode> modes(spots_.size());
    for (std::size_t i = 0; i < modes.size(); ++i) {
        ContactMode& mode = modes[i];
        mode.touches = true;
        const Kinematics spot = kinematics(state, mode, i);
        const double deflection = std::hypot(spot.deflection[0], spot.deflection[1]);
        mode.touches = spot.normal > 0 || (spot.normal == 0 && spot.normal_rate > 0);
        const bool released = machine_.mechanisms.coupling ? !mode.touches : spot.bound == 0;
        if (deflection > (released ? 0 : spot.bound) * (1 + rounding) + smallest_)
            throw std::invalid_argument("a spot's deflection exceeds its friction bound");
        if (released) continue;
        if (spot.bound == 0)
            land(spot, mode);
        else if (deflection >= spot.bound * (1 - rounding) && spot.slip_rate() > 0)
            mode = {mode.touches, SpotState::slip, spot.direction};
        else
            mode.state = SpotState::stick;
    }
    return modes;
}

// The bound grows from zero with the deflection: whether it keeps up decides.
void ContactFlow::land(const Kinematics& spot, ContactMode& mode) {
    const bool slips = std::hypot(spot.velocity[0], spot.velocity[1]) > spot.bound_rate;
    mode.state = slips ? SpotState::slip : SpotState::stick;
    mode.direction = unit(spot.velocity);
}

Motion ContactFlow::motion_of(const State& state, const std::vector<ContactMode>& modes,
                              double time, double base) const {
    Motion motion{.time = time,
                  .base = base,
                  .x = base - state[stretch],
                  .z = state[z],
                  .phi = state[phi],
                  .x_velocity = state[x_velocity],
                  .z_velocity = state[z_velocity],
                  .phi_velocity = state[phi_velocity],
                  .spots = std::vector<SpotDeflection>(spots_.size())};
    for (std::size_t i = 0; i < spots_.size(); ++i) {
        const Kinematics spot = kinematics(state, modes[i], i);
        SpotDeflection& deflection = motion.spots[i];
        if (modes[i].touches) deflection.normal = spot.normal;
        const auto& [e_x, e_s] = spot.direction;
        if (modes[i].state == SpotState::slip)
            deflection.tangential = spot.bound * e_x, deflection.flank = spot.bound * e_s;
        else if (modes[i].state == SpotState::stick)
            deflection.tangential = spot.deflection[0], deflection.flank = spot.deflection[1];
    }
    return motion;
}

void ContactFlow::derivative(const State& state, const std::vector<ContactMode>& modes, double time,
                             State& rate) const {
    const Motion motion = motion_of(state, modes, time, 0);
    const auto [x, z_acceleration, phi_acceleration] = acceleration(machine_, spots_, motion);
    const double kappa4 = machine_.kappas.kappa4, speed = machine_.kappas.kappa6;
    rate = {speed - state[x_velocity], state[z_velocity], state[phi_velocity], x, z_acceleration,
            phi_acceleration};
    double dissipation = 0;
    for (std::size_t i = 0; i < spots_.size(); ++i) {
        const Kinematics spot = kinematics(state, modes[i], i);
        Vector follows = spot.velocity;
        if (modes[i].state == SpotState::released) {
            follows = {};
        } else if (modes[i].state == SpotState::slip) {
            follows = spot.turning();
            for (int j = 0; j < 2; ++j) follows[j] += spot.bound_rate * spot.direction[j];
            dissipation += slip_work(machine_, spots_[i], motion.spots[i],
                                     spot.velocity[0] - follows[0], spot.velocity[1] - follows[1]);
        }
        rate.insert(rate.end(), {follows[0], follows[1]});
    }
    const WorkingForces forces = working_forces(machine_, spots_, motion);
    EnergyBalance power = work(machine_, forces, speed, motion.z_velocity, motion.phi_velocity);
    rate.insert(rate.end(), {power.base / kappa4, power.excitation / kappa4,
                             power.geometric / kappa4, dissipation / kappa4});
}

std::vector<Guard> ContactFlow::guards(const State& state, const std::vector<ContactMode>& modes,
                                       double time) const {
    const Kappas& k = machine_.kappas;
    const auto [x, z_acceleration, phi_acceleration] =
        acceleration(machine_, spots_, motion_of(state, modes, time, 0));
    std::vector<Guard> guards;
    for (std::size_t i = 0; i < spots_.size(); ++i) {
        const Kinematics spot = kinematics(state, modes[i], i);
        const double side = modes[i].touches ? 1 : -1;
        guards.push_back({side * spot.normal, side * spot.normal_rate});
        if (modes[i].state == SpotState::released) {
            guards.push_back(none);
        } else if (modes[i].state == SpotState::stick) {
            const double deflection = std::hypot(spot.deflection[0], spot.deflection[1]);
            guards.push_back({spot.bound - deflection, -spot.slip_rate()});
        } else {
            const double rotation = state[phi_velocity] / k.kappa3;
            const double lever = normal_lever(spots_[i], state[phi] / k.kappa3) / k.kappa3;
            const double normal_acceleration =
                slope_ * (z_acceleration - lever * phi_acceleration -
                          spots_[i].tip_radius * rotation * rotation);
            const Vector change = {x + phi_acceleration,
                                   spot.velocity[1] != 0 ? normal_acceleration : 0};
            const bool follows = machine_.mechanisms.coupling && modes[i].touches;
            const double bound_acceleration =
                follows ? k.kappa5 * k.kappa2 * normal_acceleration : 0;
            // e turns at turning()/bound.
            const Vector turning = spot.turning();
            const double turn = spot.bound > smallest_ ? dot(turning, turning) / spot.bound : 0;
            guards.push_back(
                {spot.slip_rate(), dot(spot.direction, change) + turn - bound_acceleration});
        }
    }
    return guards;
}

void ContactFlow::pass(std::size_t guard, State& state, std::vector<ContactMode>& modes) const {
    const std::size_t i = guard / 2;
    ContactMode& mode = modes[i];
    double* deflection = &state[first_spot + 2 * i];
    if (guard % 2 == 0) {
        mode.touches = !mode.touches;
        if (!machine_.mechanisms.coupling) return;
        deflection[0] = deflection[1] = 0;
        mode.state = SpotState::released;
        if (mode.touches) land(kinematics(state, mode, i), mode);
        return;
    }
    const Kinematics spot = kinematics(state, mode, i);
    if (mode.state == SpotState::stick) {
        mode.state = SpotState::slip;
        mode.direction = spot.direction;
    } else {
        mode.state = SpotState::stick;
        for (int j = 0; j < 2; ++j) deflection[j] = spot.bound * spot.direction[j];
    }
}

}  // namespace tricontact::walking
