#include "walking/run/lyapunov.h"

#include <cmath>

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
    deflection.normal = normal_deflection(machine, spot, motion);
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
    Motion there = between(motion, neighbour, ratio);
    there.time = motion.time, there.base = motion.base;
    const std::vector<Spot> springs = springs_of(machine);
    for (std::size_t i = 0; i < springs.size(); ++i)
        admit(machine, springs[i], there, there.spots[i]);
    return there;
}

}  // namespace

std::vector<double> separation_rates(const Machine& machine, const Motion& start,
                                     const Separation& separation) {
    const auto& [step, interval, alignment, duration, relative_distance] = separation;
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
