#include "walking/machine/steady_sliding.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <numbers>

#include "walking/machine/forces.h"

namespace tricontact::walking {

namespace {

// Root of f between a and b, where it has different signs; to rounding.
template <class Function>
double root(const Function& f, double a, double b) {
    std::uintmax_t n_evaluations = 200;
    const auto [low, high] = boost::math::tools::toms748_solve(
        f, a, b, boost::math::tools::eps_tolerance<double>(), n_evaluations);
    return std::abs(f(low)) < std::abs(f(high)) ? low : high;
}

Acceleration sliding_acceleration(const Machine& machine, double z, double phi) {
    return acceleration(machine, springs_of(machine), sliding_motion(machine, z, phi));
}

// Normal forces grow with z: there is one z at which they carry the weight.
double carried_at(const Machine& machine, double phi) {
    const double rest = static_displacement(machine);
    if (!machine.mechanisms.vertical) return rest;
    const auto excess = [&](double z) { return sliding_acceleration(machine, z, phi).z; };
    double low = rest, high = rest, step = std::max(std::abs(rest), std::abs(phi)) / 8;
    while (excess(low) < 0) low -= step, step *= 2;
    while (excess(high) > 0) high += step, step *= 2;
    return low < high ? root(excess, low, high) : rest;
}

}  // namespace

Motion sliding_motion(const Machine& machine, double z, double phi) {
    const Kappas& k = machine.kappas;
    const bool prism = machine.model == Machine::Model::prism;
    const double slope = prism ? 1 / std::numbers::sqrt2 : 1;
    const double rest = static_displacement(machine);
    Motion motion{.z = z, .phi = phi, .x_velocity = k.kappa6};
    const std::vector<Spot> spots = springs_of(machine);
    double friction = 0;
    for (const Spot& spot : spots) {
        const double near = std::max(0., approach(spot, z, phi / k.kappa3));
        const double loaded = machine.mechanisms.coupling ? near : std::max(0., rest - spot.height);
        const SpotDeflection deflection{.normal = slope * near,
                                        .tangential = k.kappa5 * k.kappa2 * slope * loaded};
        friction += spot_force(machine, spot, deflection).tangential;
        motion.spots.push_back(deflection);
    }
    motion.base = friction / k.kappa1 - k.kappa8 * phi;
    return motion;
}

std::optional<Motion> steady_sliding(const Machine& machine) {
    const auto moment = [&](double phi) {
        return sliding_acceleration(machine, carried_at(machine, phi), phi).phi;
    };
    const double start = moment(0);
    if (start == 0) return sliding_motion(machine, carried_at(machine, 0), 0);
    // A turn loads the spots on one side: moments fall with phi while both sides carry. Steps
    // double from one that is small beside the turn that lifts a spot at rest.
    double before = 0, phi = std::copysign(1e-3 * static_displacement(machine), start);
    while (moment(phi) * start > 0) {
        before = phi;
        phi *= 2;
        if (std::abs(phi) > tilting_limit(machine)) return std::nullopt;
    }
    phi = root(moment, std::min(before, phi), std::max(before, phi));
    return sliding_motion(machine, carried_at(machine, phi), phi);
}

}  // namespace tricontact::walking
