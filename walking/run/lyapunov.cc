#include "walking/run/lyapunov.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "walking/machine/velocity_verlet.h"

namespace tricontact::walking {

namespace {

double square(double value) {
    return value * value;
}

double distance(const Motion& a, const Motion& b) {
    double squares = square(a.x - b.x) + square(a.z - b.z) + square(a.phi - b.phi) +
                     square(a.x_velocity - b.x_velocity) + square(a.z_velocity - b.z_velocity) +
                     square(a.phi_velocity - b.phi_velocity);
    for (std::size_t i = 0; i < a.spots.size(); ++i)
        squares += square(a.spots[i].tangential - b.spots[i].tangential) +
                   square(a.spots[i].flank - b.spots[i].flank);
    return std::sqrt(squares);
}

// Deflections that the friction bound admits where the body now is.
void admit(const Machine& machine, const Spot& spot, const Motion& motion,
           SpotDeflection& deflection) {
    const Kappas& k = machine.kappas;
    const double slope = machine.model == Machine::Model::prism ? 1 / std::numbers::sqrt2 : 1;
    deflection.normal = std::max(0., slope * approach(spot, motion.z, motion.phi / k.kappa3));
    if (!machine.mechanisms.coupling) return;  // constant bounds: the next step sees to them
    const double bound = k.kappa5 * k.kappa2 * deflection.normal;
    const double length = std::hypot(deflection.tangential, deflection.flank);
    if (length <= bound) return;
    deflection.tangential *= bound / length;
    deflection.flank *= bound / length;
}

// On the line from `motion` to `neighbour`, `ratio` times as far away as that.
Motion moved_to(const Machine& machine, const Motion& motion, const Motion& neighbour,
                double ratio) {
    const auto between = [ratio](double a, double b) { return a + ratio * (b - a); };
    Motion there = motion;
    there.x = between(motion.x, neighbour.x);
    there.z = between(motion.z, neighbour.z);
    there.phi = between(motion.phi, neighbour.phi);
    there.x_velocity = between(motion.x_velocity, neighbour.x_velocity);
    there.z_velocity = between(motion.z_velocity, neighbour.z_velocity);
    there.phi_velocity = between(motion.phi_velocity, neighbour.phi_velocity);
    const std::vector<Spot> springs = springs_of(machine);
    for (std::size_t i = 0; i < springs.size(); ++i) {
        SpotDeflection& spot = there.spots[i];
        spot.tangential = between(spot.tangential, neighbour.spots[i].tangential);
        spot.flank = between(spot.flank, neighbour.spots[i].flank);
        admit(machine, springs[i], there, spot);
    }
    return there;
}

}  // namespace

std::vector<double> separation_rates(const Machine& machine, const Motion& start,
                                     const Separation& separation) {
    const auto& [step, interval, alignment, duration, relative_distance] = separation;
    if (!(step > 0 && interval >= step && alignment >= 0 && duration >= 2 * interval &&
          relative_distance > 0))
        throw std::invalid_argument("separation of nearby runs: times that are none");
    const double wanted = relative_distance * static_displacement(machine);
    const auto n_steps = std::lround(interval / step);
    const auto n_alignment = std::lround(alignment / interval),
               n_intervals = std::lround(duration / interval);
    VelocityVerlet run(machine, start, step);
    Motion neighbour = start;
    neighbour.x += wanted, neighbour.z += wanted, neighbour.phi += wanted;
    std::vector<double> rates;
    for (long i = 0; i < n_alignment + n_intervals; ++i) {
        const Motion& motion = run.motion();
        neighbour = moved_to(machine, motion, neighbour, wanted / distance(motion, neighbour));
        const double before = distance(motion, neighbour);
        VelocityVerlet beside(machine, neighbour, step);
        for (long j = 0; j < n_steps; ++j) {
            run.advance();
            beside.advance();
        }
        neighbour = beside.motion();
        const double growth = std::log(distance(run.motion(), neighbour) / before);
        if (i >= n_alignment) rates.push_back(growth / (static_cast<double>(n_steps) * step));
    }
    return rates;
}

statistics::Mean lyapunov_exponent(const Machine& machine, const Motion& start,
                                   const Separation& separation) {
    return statistics::initial_sequence_mean(separation_rates(machine, start, separation));
}

}  // namespace tricontact::walking
