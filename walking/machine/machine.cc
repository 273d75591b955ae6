#include "walking/machine/machine.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/base/special_values.h"

namespace tricontact::walking {

std::vector<Spot> bed_springs(const Bed& bed, const Spot& spot, double load) {
    const double depth = resting_indentation(load);
    const double contact_radius = std::sqrt(bed.radius * depth);
    const double spacing = 2 * bed.width / bed.springs;  // over the contact radius
    std::vector<Spot> springs;
    for (int i = 0; i < bed.springs; ++i) {
        const double place = (i + 0.5) * spacing - bed.width;
        springs.push_back({.position = spot.position,
                           .height = spot.height + place * place * depth,  // s^2/R
                           .stiffness = spot.stiffness * spacing / 2,
                           .offset = place * contact_radius,
                           .tip_radius = bed.radius});
    }
    return springs;
}

double critical_friction(const Kappas& kappas) {
    const double lever = kappas.kappa3 * (1 + kappas.kappa8);  // (h + a)/b
    return lever > 0 ? 1 / lever : contact::infinity;
}

std::vector<Spot> spots_of(const Machine& machine) {
    if (machine.model == Machine::Model::spots) return machine.spots;
    return {{.position = -1}, {.position = 1}};
}

std::vector<Spot> springs_of(const Machine& machine) {
    const std::vector<Spot> spots = spots_of(machine);
    if (!machine.bed) return spots;
    const auto& [kappa1, kappa2, kappa3, kappa4, kappa5, kappa6, kappa7, kappa8] = machine.kappas;
    const double share = kappa4 / kappa2 / static_cast<double>(spots.size());
    std::vector<Spot> springs;
    for (const Spot& spot : spots)
        for (const Spot& spring : bed_springs(*machine.bed, spot, share)) springs.push_back(spring);
    return springs;
}

double static_displacement(const Machine& machine) {
    const auto& [kappa1, kappa2, kappa3, kappa4, kappa5, kappa6, kappa7, kappa8] = machine.kappas;
    if (machine.model == Machine::Model::prism)  // four contacts: f_N = 2 sqrt(1/2) kappa2 u_n
        return kappa4 / (2 * kappa2);
    // The lowest tips carry first: add one after another until the next stays clear of the ground.
    std::vector<Spot> springs = springs_of(machine);
    std::ranges::sort(springs, {}, &Spot::height);
    double stiffness = 0, moment = 0, z = 0;
    for (const Spot& spring : springs) {
        if (stiffness > 0 && z <= spring.height) break;
        stiffness += kappa2 * spring.stiffness;
        moment += kappa2 * spring.stiffness * spring.height;
        z = (kappa4 + moment) / stiffness;
    }
    return z;
}

double normal_load_factor(const Machine& machine) {
    return machine.model == Machine::Model::prism ? std::numbers::sqrt2 : 1;
}

double sliding_force(const Machine& machine) {
    return normal_load_factor(machine) * machine.kappas.kappa5 * machine.kappas.kappa4;
}

double critical_friction(const Machine& machine) {
    const double leading = std::ranges::max(spots_of(machine), {}, &Spot::position).position;
    return leading * critical_friction(machine.kappas) / normal_load_factor(machine);
}

double tilting_limit(const Machine& machine) {
    return machine.tilting_angle * machine.kappas.kappa3;  // phi = (a/b) Phi
}

double free_flight_frequency(const Kappas& kappas) {
    const double lever = kappas.kappa3 * kappas.kappa8;
    return std::sqrt(kappas.kappa1 * (1 + lever * lever / kappas.kappa7)) / (2 * std::numbers::pi);
}

}  // namespace tricontact::walking
