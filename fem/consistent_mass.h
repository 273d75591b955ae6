#pragma once

#include <memory>
#include <span>
#include <vector>

#include "contact/compliances/compliance.h"
#include "fem/matrices.h"

namespace tricontact::fem {

/// Tractions as fields on the surface of elements, by the consistent mass of a patch.
class ConsistentMass {
  public:
    /// `mass`: see ContactSurface.
    explicit ConsistentMass(SparseMatrix mass);
    ~ConsistentMass();

    /// See contact::Compliance::consistent_traction(), on the points that the mass is of.
    std::vector<double> traction(const contact::ContactPoints& points, std::span<const double> t,
                                 bool odd_in_y) const;

  private:
    struct Factors;
    SparseMatrix mass_;
    mutable std::unique_ptr<Factors> factors_;  // when first asked for
};

}  // namespace tricontact::fem
