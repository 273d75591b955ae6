#include "walking/machine/stretch_recorder.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "contact/base/special_values.h"

namespace tricontact::walking {

namespace {

/// Wetter (2016), eq. 4.2.16.
double path(const Motion& motion, const SpotDeflection& spot) {
    return motion.x + motion.phi - spot.tangential;
}

}  // namespace

SpotView::SpotView(const Machine& machine) : spots_(spots_of(machine)) {
    if (machine.bed) springs_ = springs_of(machine);
    sum_steps_.resize(spots_.size());
}

void SpotView::look_at(const Motion& motion, const std::vector<SpotStep>& steps) {
    motion_ = &motion;
    steps_ = &steps;
    if (springs_.empty()) return;
    sums_ = motion;
    sums_.spots.assign(spots_.size(), {});
    const std::size_t n = springs_.size() / spots_.size();
    for (std::size_t spot = 0; spot < spots_.size(); ++spot) {
        SpotDeflection& sum = sums_.spots[spot];
        SpotStep& sum_step = sum_steps_[spot];
        sum_step = {};
        bool touches = false;
        for (std::size_t i = spot * n; i < (spot + 1) * n; ++i) {
            const SpotDeflection& spring = motion.spots[i];
            if (spring.normal == 0) continue;
            const double share = springs_[i].stiffness / spots_[spot].stiffness;
            sum.normal += share * spring.normal;
            sum.tangential += share * spring.tangential;
            sum_step.sticks = sum_step.sticks || steps[i].sticks;
            if (!touches || std::abs(steps[i].slip) < std::abs(sum_step.slip))
                sum_step.slip = steps[i].slip;
            touches = true;
        }
    }
    motion_ = &sums_;
    steps_ = &sum_steps_;
}

void StretchSums::add(const StretchSums& other) {
    if (steps == 0) spots.resize(other.spots.size());
    if (spots.size() != other.spots.size())
        throw std::invalid_argument("stretches with different numbers of spots");
    steps += other.steps;
    spring_force += other.spring_force;
    kinetic_energy += other.kinetic_energy;
    z_min = std::min(z_min, other.z_min);
    z_max = std::max(z_max, other.z_max);
    phi_min = std::min(phi_min, other.phi_min);
    phi_max = std::max(phi_max, other.phi_max);
    for (std::size_t i = 0; i < spots.size(); ++i) {
        SpotSums& spot = spots[i];
        const SpotSums& more = other.spots[i];
        spot.sticking += more.sticking;
        for (const auto sum : {&SpotSums::velocity, &SpotSums::velocity_squared, &SpotSums::normal,
                               &SpotSums::normal_squared, &SpotSums::normal_velocity})
            spot.*sum += more.*sum;
    }
}

double correlation(const SpotSums& spot, std::int64_t steps) {
    const double n = static_cast<double>(steps);
    const double covariance = spot.normal_velocity - spot.normal * spot.velocity / n;
    const double normal = spot.normal_squared - spot.normal * spot.normal / n;
    const double velocity = spot.velocity_squared - spot.velocity * spot.velocity / n;
    // Below the rounding of the sums nothing varies.
    constexpr double rounding = 1e-12;
    if (!(normal > rounding * spot.normal_squared) ||
        !(velocity > rounding * spot.velocity_squared))
        return contact::undefined;
    return covariance / std::sqrt(normal * velocity);
}

StretchRecorder::StretchRecorder(const Machine& machine, const Motion& start, double step)
    : machine_(machine),
      step_(step),
      rotational_(machine.kappas.kappa7 / (machine.kappas.kappa3 * machine.kappas.kappa3)),
      sums_{.spots = std::vector<SpotSums>(start.spots.size())} {
    for (const SpotDeflection& spot : start.spots)
        paths_.push_back({path(start, spot), path(start, spot), spot.normal});
}

void StretchRecorder::add(const Motion& motion, const std::vector<SpotStep>& spot_steps) {
    ++sums_.steps;
    sums_.spring_force += spring_force(machine_, motion);
    const double x = motion.x_velocity, z = motion.z_velocity, phi = motion.phi_velocity;
    sums_.kinetic_energy += (x * x + z * z + rotational_ * phi * phi) / 2;
    sums_.z_min = std::min(sums_.z_min, motion.z);
    sums_.z_max = std::max(sums_.z_max, motion.z);
    sums_.phi_min = std::min(sums_.phi_min, motion.phi);
    sums_.phi_max = std::max(sums_.phi_max, motion.phi);
    for (std::size_t i = 0; i < paths_.size(); ++i) {
        SpotPath& spot = paths_[i];
        SpotSums& sums = sums_.spots[i];
        const double next = path(motion, motion.spots[i]);
        const double velocity = (next - spot.before) / (2 * step_);
        sums.sticking += spot_steps[i].sticks;
        sums.velocity += velocity;
        sums.velocity_squared += velocity * velocity;
        sums.normal += spot.normal;
        sums.normal_squared += spot.normal * spot.normal;
        sums.normal_velocity += spot.normal * velocity;
        spot = {spot.now, next, motion.spots[i].normal};
    }
}

StretchSums StretchRecorder::take() {
    return std::exchange(sums_, {.spots = std::vector<SpotSums>(paths_.size())});
}

}  // namespace tricontact::walking
