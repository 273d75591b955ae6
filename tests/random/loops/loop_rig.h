#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "contact/case.h"
#include "tests/random/loops/driven_loop.h"

namespace tricontact {

/// A sphere on a half-space (Popov and Hess 2015, method of dimensionality reduction) with a spring
/// in series, driven step by step: springs that stick or slip, whose sum balances the rig's. No
/// closed form of a loop, and nothing of the program, is in here.
class LoopRig {
  public:
    static constexpr const char* model = "half-space";
    static constexpr Bounds noise{.003, .02};  // over the force of sliding
    double radius = 0, young = 0, poisson = 0, friction = 0, rig_stiffness = 0, normal_force = 0;

    void draw(Random& random) {
        radius = log_between(random, 3e-3, 50e-3);
        young = log_between(random, 2e9, 210e9);
        poisson = between(random, {.25, .45});
        friction = between(random, {.15, 1});
        normal_force = log_between(random, 10, 500);
        rig_stiffness = log_between(random, .4, 6) * 2 * shear_modulus() * contact_radius();
    }
    contact::Case as_case() const {
        contact::Case c;
        c.indenter.radius = radius;
        c.substrate = {young, poisson};
        return c;
    }
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

    /// From rest to a first reversal, in steps.
    void start(double amplitude) {
        unload();
        for (int i = 1; i <= 20; ++i) move(amplitude * i / 20, friction);
    }

    /// In fine steps, of which each n-th is a row.
    DrivenLoop cycle(double amplitude, double mu) {
        constexpr int n_fine = 6;
        DrivenLoop loop{.truth = {.friction = mu}};
        slid_ = false;
        double force = 0, shift = amplitude, largest_force = 0, largest_shift = 0;
        for (int i = 1; i <= n_rows * n_fine; ++i) {
            const double drive = amplitude * std::cos(2 * std::numbers::pi * i / (n_rows * n_fine));
            const double next = move(drive, mu);
            loop.truth.energy += (i == 1 ? next : (force + next) / 2) * (drive - shift);
            force = next;
            shift = drive;
            largest_force = std::max(largest_force, std::abs(force));
            largest_shift = std::max(largest_shift, std::abs(shift_));
            if (i % n_fine) continue;
            loop.shifts.push_back(drive);
            loop.forces.push_back(force);
        }
        loop.truth.ratio = loop.truth.energy / (4 * largest_force * largest_shift);
        loop.truth.slides = slid_;
        return loop;
    }

  private:
    /// One state of all springs, unloaded along the surface.
    void unload() {
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

    static constexpr int n_springs = 300;
    std::vector<double> bounds_, forces_;  // of mu = 1 [N]; carried [N]
    double stiffness_ = 0, shift_ = 0;
    bool slid_ = false;
};

}  // namespace tricontact
