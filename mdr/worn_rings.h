#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "contact/wearing_contact.h"

namespace tricontact::mdr {

/// A body of revolution under Coulomb's law that wears along rings: what independent and coupled
/// springs have in common.
class WornRings : public contact::WearingContact {
  public:
    const std::vector<double>& area() const final { return area_; }
    contact::Surface surface() const final;
    std::vector<double> on_surface(const std::vector<double>& field) const final;
    std::vector<std::size_t> line() const final;
    double x(std::size_t point) const final { return radius_[point]; }
    bool is_of_revolution() const final { return true; }

  protected:
    /// Throws contact::InputError unless the normal control stays the same in the cycle, and where
    /// the indenter rolls. `model`: named in messages.
    WornRings(const std::string& model, contact::WearProblem problem, double friction);

    /// kappa of dh = kappa p ds [m^2/N].
    double wear_factor() const {
        const contact::Wear& law = problem_.law;
        return law.coefficient ? *law.coefficient : *law.energy_coefficient * friction_;
    }
    /// 2 pi ∫ rho phi drho [m^2] of the hat functions phi of `n` > 1 nodes at the distance h [m].
    static std::vector<double> areas_of_hats(std::size_t n, double h);

    contact::WearProblem problem_;
    double friction_;                    // mu [-]
    std::vector<double> radius_, area_;  // of all points [m], [m^2]
};

}  // namespace tricontact::mdr
