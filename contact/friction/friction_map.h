#pragma once

#include <vector>

namespace tricontact::contact {

/// What friction is over the substrate: a factor of the bound that its law has, linear between the
/// rows of a table. Positions are those of the substrate; the contact begins at the origin.
class FrictionMap {
  public:
    /// `x`, `y` [m] increase, two or more; `y` empty: stripes, the same for all y. `factor` [-],
    /// >= 0, x fastest. Throws std::invalid_argument.
    FrictionMap(std::vector<double> x, std::vector<double> y, std::vector<double> factor);

    bool varies_along_y() const { return !y_.empty(); }
    /// At a point of the substrate [m]. Throws InputError where the map has ended.
    double at(double x, double y) const;

  private:
    std::vector<double> x_, y_, factor_;
};

}  // namespace tricontact::contact
