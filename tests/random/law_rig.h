#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace tricontact {

/// A rigid paraboloid on an incompressible half-space under a law of friction tau(p) [Pa], by
/// springs: what measurements on it give, computed from the laws' integrals alone. Nothing of the
/// program is in here. The spring at x carries the integral of tau along its chord at most.
class LawRig {
  public:
    using Law = std::function<double(double pressure)>;

    LawRig(double radius, double young, Law law)
        : radius_(radius), young_(young), law_(std::move(law)) {}

    double plane_modulus() const { return young_ / .75; }          // E* [Pa]
    double shear_modulus() const { return 4 * young_ / 3 / 1.5; }  // G* = 4 G/(2 - nu) [Pa]
    double contact_radius(double load) const {
        return std::cbrt(3 * load * radius_ / (4 * plane_modulus()));
    }
    double load_at_depth(double depth) const {
        return 4. / 3 * plane_modulus() * std::sqrt(radius_) * std::pow(depth, 1.5);
    }
    double limit(double load) const { return 2 * step(load) * sum_below(bounds(load), 1e300); }
    /// U [m] of a force along the surface, applied once, below the limit.
    double shift(double load, double force) const {
        const auto b = bounds(load);
        double low = 0, high = *std::max_element(b.begin(), b.end());
        for (int i = 0; i < 60; ++i) {
            const double middle = (low + high) / 2;
            (2 * step(load) * sum_below(b, middle) < force ? low : high) = middle;
        }
        return high / shear_modulus();
    }

  private:
    static constexpr int n_springs = 400, n_points = 60;

    double step(double load) const { return contact_radius(load) / n_springs; }
    static double sum_below(const std::vector<double>& bounds, double most) {
        double sum = 0;
        for (const double b : bounds) sum += std::min(b, most);
        return sum;
    }
    /// Of springs from the middle to one side: ∫ tau dy, y = sqrt(a^2 - x^2) sin(t).
    std::vector<double> bounds(double load) const {
        const double a = contact_radius(load);
        const double peak = 3 * load / (2 * std::numbers::pi * a * a);
        std::vector<double> b;
        for (int i = 0; i < n_springs; ++i) {
            const double x = (i + .5) / n_springs, chord = std::sqrt(1 - x * x);
            double sum = 0;
            for (int k = 0; k < n_points; ++k) {
                const double t = std::numbers::pi * ((k + .5) / n_points - .5);
                sum += law_(peak * chord * std::cos(t)) * std::cos(t);
            }
            b.push_back(a * chord * sum * std::numbers::pi / n_points);
        }
        return b;
    }

    double radius_, young_;
    Law law_;
};

}  // namespace tricontact
