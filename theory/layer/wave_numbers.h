#pragma once

#include "theory/line_load.h"

namespace tricontact::theory {

/// Quadrature over x = k b in (0, 24), where the deficit of a layer against the half-space lives:
/// it is below 1e-17 beyond, on either base. Exact to rounding for the deficit times two waves of
/// the argument k r, r up to `radius_over_thickness` b (cosines or Bessel functions).
QuadratureRule wave_number_rule(double radius_over_thickness);

}  // namespace tricontact::theory
