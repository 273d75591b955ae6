#pragma once

#include <array>

#include "contact/case.h"
#include "contact/substrates/material.h"
#include "meshes/hex_mesh.h"

namespace tricontact::fem {

/// Bulk over shear modulus that stands for incompressible material: changes the contact's
/// compliance by 0.6 G/K.
constexpr double incompressible_bulk_ratio = 1e6;

/// Linear elasticity of a layer (or two) on a rigid base.
struct LayerProblem {
    meshes::HexMesh mesh;
    std::array<contact::Material, meshes::n_regions> materials{{{0, 0}, {0, 0}}};
    contact::Case::Base base = contact::Case::Base::bonded;
    contact::Case::Sides sides = contact::Case::Sides::free;
    double largest_bulk_ratio = incompressible_bulk_ratio;  ///< K/G is cut here
    double line_length = 0;  ///< see contact::ContactPoints [m]; the stiffness knows nothing of it
};

}  // namespace tricontact::fem
