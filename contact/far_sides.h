#pragma once

#include "contact/case.h"

namespace tricontact::contact {

/// Distance of the sides of a layer's block from the load at which they are hardly felt, in
/// thicknesses of all layers: the block of finite elements is chosen by it.
double far_sides(const Case& c);

}  // namespace tricontact::contact
