#pragma once

#include <memory>

#include "contact/friction/friction_law.h"

namespace tricontact::contact {

/// Coulomb's law: mu p.
class Coulomb final : public FrictionLaw {
  public:
    explicit Coulomb(double coefficient) : mu_(coefficient) {}
    void bounds(const Points& points, std::span<double> bound) const override {
        for (std::size_t i = 0; i < bound.size(); ++i) bound[i] = mu_ * points.pressure[i];
    }
    std::optional<double> coulomb() const override { return mu_; }

  private:
    double mu_;  // [-]
};

/// What a case says about its interface, in the keys of [friction].
struct Friction {
    double coefficient = 0;  ///< mu [-] of Coulomb's law

    std::shared_ptr<const FrictionLaw> law() const {
        return std::make_shared<Coulomb>(coefficient);
    }
};

}  // namespace tricontact::contact
