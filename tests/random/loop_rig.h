#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace tricontact {

/// A sphere on a half-space (Popov and Hess 2015, method of dimensionality reduction) with a spring
/// in series, driven step by step: springs that stick or slip, whose sum balances the rig's. No
/// closed form of a loop, and nothing of the program, is in here.
class LoopRig {
  public:
    double radius = 0, young = 0, poisson = 0, friction = 0, rig_stiffness = 0, normal_force = 0;

    double plane_modulus() const { return young / (1 - poisson * poisson); }
    double shear_modulus() const { return 2 * young / ((1 + poisson) * (2 - poisson)); }
    double contact_radius() const {
        return std::cbrt(.75 * normal_force * radius / plane_modulus());
    }
    /// Shift of the drive at which all slides.
    double sliding_shift() const {
        const double depth = contact_radius() * contact_radius() / radius;
        return friction *
               (plane_modulus() / shear_modulus() * depth + normal_force / rig_stiffness);
    }

    /// One state of all springs, unloaded along the surface.
    void start() {
        bounds_.clear();
        const double a = contact_radius();
        for (int i = 0; i < n_springs; ++i) {
            const double x = a * (i + .5) / n_springs;
            // Both halves: E* (d - x^2/R) dx, d = a^2/R.
            bounds_.push_back(2 * plane_modulus() * (a * a - x * x) / radius * a / n_springs);
        }
        double sum = 0;
        for (const double bound : bounds_) sum += bound;
        for (double& bound : bounds_) bound *= normal_force / sum;
        stiffness_ = 2 * shear_modulus() * a / n_springs;
        forces_.assign(n_springs, 0);
        shift_ = 0;
        slid_ = false;
    }

    /// Moves the drive to `drive` with this coefficient of friction: the force [N].
    double move(double drive, double mu) {
        const auto force_at = [&](double shift) {
            double sum = 0;
            for (int i = 0; i < n_springs; ++i)
                sum += std::clamp(forces_[i] + stiffness_ * (shift - shift_), -mu * bounds_[i],
                                  mu * bounds_[i]);
            return sum;
        };
        const double reach = std::abs(drive) + mu * normal_force / rig_stiffness;
        double low = -reach, high = reach;
        for (int i = 0; i < 60; ++i) {
            const double middle = (low + high) / 2;
            (force_at(middle) > rig_stiffness * (drive - middle) ? high : low) = middle;
        }
        const double shift = (low + high) / 2;
        const double force = force_at(shift);
        for (int i = 0; i < n_springs; ++i)
            forces_[i] = std::clamp(forces_[i] + stiffness_ * (shift - shift_), -mu * bounds_[i],
                                    mu * bounds_[i]);
        shift_ = shift;
        slid_ = slid_ || std::abs(force) > (1 - 1e-6) * mu * normal_force;
        return force;
    }
    double shift() const { return shift_; }
    /// Whether all slid since this was asked for last.
    bool has_slid() { return std::exchange(slid_, false); }

  private:
    static constexpr int n_springs = 300;
    std::vector<double> bounds_, forces_;  // of mu = 1 [N]; carried [N]
    double stiffness_ = 0, shift_ = 0;
    bool slid_ = false;
};

}  // namespace tricontact
