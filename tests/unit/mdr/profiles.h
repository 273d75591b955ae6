#pragma once

#include <cmath>
#include <limits>

#include "contact/bodies/indenter.h"

namespace tricontact::mdr_test {

/// h = c r^n.
class PowerLawIndenter final : public contact::AxisymmetricIndenter {
  public:
    PowerLawIndenter(double c, double n) : c_(c), n_(n) {}
    double profile(double r) const override { return c_ * std::pow(r, n_); }
    double profile_slope(double r) const override { return c_ * n_ * std::pow(r, n_ - 1); }
    double outer_radius() const override { return std::numeric_limits<double>::infinity(); }

  private:
    double c_, n_;
};

/// Cone of slope `inner` up to the radius b, of slope `outer` beyond: one kink.
/// g = x [inner pi/2 + (outer - inner) acos(b/x)] for x > b.
class TwoCones final : public contact::AxisymmetricIndenter {
  public:
    TwoCones(double inner, double outer, double b) : inner_(inner), outer_(outer), b_(b) {}
    double profile(double r) const override {
        return r < b_ ? inner_ * r : inner_ * b_ + outer_ * (r - b_);
    }
    double profile_slope(double r) const override { return r < b_ ? inner_ : outer_; }
    double outer_radius() const override { return 10 * b_; }
    std::vector<double> kinks() const override { return {b_}; }
    double transformed(double x) const {
        const double beyond = x > b_ ? std::acos(b_ / x) : 0;
        return x * (inner_ * std::acos(0.) + (outer_ - inner_) * beyond);
    }

  private:
    double inner_, outer_, b_;
};

/// Slope that jumps `n_teeth` times up to the radius 1 and does not say where.
class SawTooth final : public contact::AxisymmetricIndenter {
  public:
    explicit SawTooth(int n_teeth) : n_(n_teeth) {}
    double profile(double r) const override { return r * r; }
    double profile_slope(double r) const override { return 2 * std::floor(r * n_) / n_; }
    double outer_radius() const override { return 1; }

  private:
    int n_;
};

/// Transformed exact sphere: g = x/2 ln((R + x)/(R - x)) = x artanh(x/R).
inline double transformed_sphere(double radius, double x) {
    return x * std::atanh(x / radius);
}

}  // namespace tricontact::mdr_test
