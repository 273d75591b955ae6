#pragma once

#include <initializer_list>

#include "meshes/hex_mesh.h"
#include "meshes/messages.h"
#include "meshes/round_body_mesh.h"

// Of round_body_mesh.cc: rules of all round bodies, and the body around a hub.

namespace tricontact::meshes {

constexpr const char* round_body = "mesh of the indenter";  ///< what messages call it

/// Throws contact::InputError unless all lengths are positive [m] and `growth` >= 1.
void check_lengths(std::initializer_list<double> lengths, double growth);

/// Elements of `size` in half a patch; throws contact::InputError unless that is a whole number.
int elements_in(double patch, double size);

/// Throws contact::InputError where the patch reaches more than 49 degrees from the middle.
void check_width(double farthest, double radius);

/// The same of one that rolls: more than 155 degrees, `farthest` along the surface.
void check_turn(double farthest, double radius);

/// Throws contact::InputError for more than 10 million elements.
void check_count(double n_elements, double size);

/// See make_cylinder_mesh(); the spec was checked.
HexMesh cylinder_on_hub(const CylinderMeshSpec& spec);

}  // namespace tricontact::meshes
