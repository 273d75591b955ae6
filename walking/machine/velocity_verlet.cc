#include "walking/machine/velocity_verlet.h"

#include <numbers>
#include <stdexcept>
#include <utility>

namespace tricontact::walking {

VelocityVerlet::VelocityVerlet(Machine machine, Motion start, double step)
    : machine_(std::move(machine)),
      spots_(springs_of(machine_)),
      rest_(static_displacement(machine_)),
      motion_(std::move(start)),
      step_(step),
      start_time_(motion_.time),
      start_base_(motion_.base),
      spot_steps_(spots_.size()) {
    if (motion_.spots.size() != spots_.size())
        throw std::invalid_argument("the start has another number of springs than the machine");
    acceleration_ = acceleration(machine_, spots_, motion_);
}

void VelocityVerlet::advance_spots(double dx, double dz, double dphi) {
    const auto& [kappa1, kappa2, kappa3, kappa4, kappa5, kappa6, kappa7, kappa8] = machine_.kappas;
    constexpr double slope = 1 / std::numbers::sqrt2;  // of a flank at 45 degrees
    const double rotation = motion_.phi / kappa3;
    for (std::size_t i = 0; i < spots_.size(); ++i) {
        const Spot& spot = spots_[i];
        SpotDeflection& deflection = motion_.spots[i];
        const double near = approach(spot, motion_.z, rotation);
        const double loaded = machine_.mechanisms.coupling ? near : rest_ - spot.height;
        if (machine_.model == Machine::Model::prism) {
            const double bound = kappa5 * kappa2 * std::max(0., slope * loaded);
            spot_steps_[i] = advance_on_flank(deflection, slope * near, bound, dx + dphi,
                                              slope * (dz - spot.position / kappa3 * dphi));
        } else {
            const double bound = kappa5 * kappa2 * std::max(0., loaded);
            spot_steps_[i] = advance_flat(deflection, near, bound, dx + dphi);
        }
    }
}

void VelocityVerlet::advance() {
    const double half = step_ / 2;
    motion_.x_velocity += half * acceleration_.x;
    motion_.z_velocity += half * acceleration_.z;
    motion_.phi_velocity += half * acceleration_.phi;
    const double dx = step_ * motion_.x_velocity, dz = step_ * motion_.z_velocity,
                 dphi = step_ * motion_.phi_velocity;
    motion_.x += dx;
    motion_.z += dz;
    motion_.phi += dphi;
    // Not summed up: millions of steps would add their rounding.
    const double elapsed = step_ * static_cast<double>(++n_steps_);
    motion_.time = start_time_ + elapsed;
    motion_.base = start_base_ + machine_.kappas.kappa6 * elapsed;
    advance_spots(dx, dz, dphi);
    acceleration_ = acceleration(machine_, spots_, motion_);
    motion_.x_velocity += half * acceleration_.x;
    motion_.z_velocity += half * acceleration_.z;
    motion_.phi_velocity += half * acceleration_.phi;
}

}  // namespace tricontact::walking
