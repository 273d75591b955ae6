#pragma once

#include <vector>

#include "atlas/atlas.h"
#include "contact/case.h"

namespace tricontact::atlas {

/// A body on a layer, pressed without friction, beside the half-space at the same force; from maps
/// over amplitude, thickness and Poisson's ratio. Throws OutsideDomain where these do not reach.
class PressedLayer {
  public:
    /// Pressed to a depth, its force is that of the maps. The atlas stays with the caller.
    PressedLayer(const contact::Case& c, const Atlas& atlas);

    /// Of the half-space at the same force; of a line contact, whose indentation and shift grow
    /// with the logarithm of its length, with the length over half width that the maps were
    /// computed at.
    const contact::HalfSpaceScales& hertz() const { return hertz_; }
    double thickness_ratio() const { return thickness_ratio_; }  ///< b over Hertz' contact diameter
    /// Of a quantity with a unit, over that of the half-space.
    Value scale(const comparisons::Quantity& q) const;
    /// f_T,lim at the amplitude w over the own radius.
    Value limit(const Value& w) const;

  private:
    double least_amplitude() const { return atlas_.axes.front().from; }
    const Axis& thickness_axis() const;
    void place(const contact::Case& c);
    void find_force(const contact::Case& c);

    const Atlas& atlas_;
    contact::HalfSpaceScales hertz_;
    double thickness_ratio_ = 0, poisson_;
};

}  // namespace tricontact::atlas
