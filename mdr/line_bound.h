#pragma once

#include <map>
#include <memory>
#include <span>
#include <vector>

#include "contact/friction/radial_bound.h"
#include "mdr/plane_profile.h"

namespace tricontact::mdr {

/// What springs carry along the surface under another law of friction than Coulomb's, whose tau(p)
/// is no multiple of their own load: contact::RadialBound of the pressures that the plane profile
/// makes on the half-space. A bound over G*: the deflection [m].
class LineBound {
  public:
    LineBound(std::shared_ptr<const contact::FrictionLaw> law, double effective_modulus,
              double effective_shear_modulus);

    /// Of the springs whose profile is pressed to this depth [m].
    void press(const PlaneProfile& profile, double depth);
    /// bound[i] of the spring at the distance first + i spacing from the indenter's axis [m].
    void sample(double first, double spacing, std::span<double> bound) const;
    double largest() const { return largest_; }       ///< [m]
    double at_centre() const { return now_.back(); }  ///< U_max [m]

  private:
    /// Bounds over the half width a, from the edge to the centre.
    using Table = std::vector<double>;
    const Table& table(const PlaneProfile& profile, int depth_class);

    std::shared_ptr<const contact::FrictionLaw> law_;
    double effective_modulus_, effective_shear_modulus_;
    std::shared_ptr<const contact::RadialBound> radial_;
    std::map<int, Table> tables_;  // by the depth's class
    double depth_ = 0, half_width_ = 0, largest_ = 0;
    Table now_;  // [m]
};

}  // namespace tricontact::mdr
