#pragma once

#include "contact/case.h"
#include "io/toml_document.h"

namespace tricontact::io {

/// Bounds of the contact radius on a layer of whatever Poisson's ratio and base [m], the load at
/// the crest of its oscillation. The extreme is the bonded incompressible layer: under a given
/// force `low` is 0.72 to 0.97 of its radius for b/a from 0.025 to 10 (exact layer, Fredholm's
/// equation of frictionless contact: Lebedev and Ufliand 1958).
struct RadiusBounds {
    double low, high;
};
RadiusBounds contact_radius_bounds(const contact::Case& c);

/// Rules for the finite element layer: there is a layer, the indenter is as good as rigid, contact
/// and rolling path have elements enough and not too many and fit on the block. `steps` [-]: of the
/// whole run. Throws contact::InputError.
void check_fem(const contact::Case& c, double steps, const Document& document);

}  // namespace tricontact::io
