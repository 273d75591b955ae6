#pragma once

#include <span>
#include <vector>

#include "contact/attraction/attraction.h"

namespace tricontact::contact {

/// Tension of a contact of revolution on whose radius the gap is linear between the points: its
/// forces on the points are the derivatives of its energy, which is integrated exactly. What each
/// point feels by its own gap moves on ring by ring, and each of them holds the front.
class RingTension {
  public:
    /// Of points that are_radii().
    explicit RingTension(const ContactPoints& points) : points_(points) {}

    /// Per point [Pa]; gaps [m] may be infinite.
    void tensions(const Attraction& law, std::span<const double> gap,
                  std::span<double> tension) const;
    /// 0 far away [J].
    double energy(const Attraction& law, std::span<const double> gap) const;

  private:
    template <class Add>
    void integrate(const Attraction& law, std::span<const double> gap, const Add& add) const;

    const ContactPoints& points_;
};

}  // namespace tricontact::contact
