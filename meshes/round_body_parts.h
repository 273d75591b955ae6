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

/// Angle from the pole to the circle on which the blocks about a ball's patch end, beyond the
/// patch's corner.
double rim_of_ball(double corner);

/// Way from the middle at this share of what lies between the edge of a patch, `from`, and its rim:
/// as far from line to line at the patch's corners as its sides ask for, `way_at_side` being theirs
/// and `obliqueness` the way to the square around the patch over that to its side, and less farther
/// out.
double way_beyond_patch(double share, double from, double rim, double way_at_side,
                        double obliqueness);

/// Throws contact::InputError for more than 10 million elements.
void check_count(double n_elements, double size);

/// See make_cylinder_mesh(); the spec was checked.
HexMesh cylinder_on_hub(const CylinderMeshSpec& spec);

}  // namespace tricontact::meshes
