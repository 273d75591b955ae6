#pragma once

#include "meshes/hex_mesh.h"

namespace tricontact::meshes {

/// Half a ball whose contact patch about the pole matches that of a layer's mesh node by node: the
/// same x and y. Lengths in m.
struct HalfBallMeshSpec {
    double radius = 0;                ///< R
    double size = 0;                  ///< element edge h in the contact patch, along x and y
    double patch_x = 0, patch_y = 0;  ///< half sides of the patch; whole numbers of `size`
    double growth = 1.8;              ///< of neighbouring elements, outwards; inwards growth^0.8
    bool half_model = false;          ///< y >= 0 only, plane of symmetry y = 0
};

/// The half of the ball about its pole, as a substrate of its own: z points out of the ball, the
/// pole is the origin, the equator's plane z = -R its base; all of the sphere but the patch are
/// sides. Corners of elements lie on the sphere, their edges are straight. The same spec gives the
/// same mesh, and the mesh is its own mirror image in x = 0 to the last bit. Throws
/// contact::InputError for a spec that is none, whose patch reaches more than 49 degrees from the
/// pole, or that asks for more than 10 million elements.
HexMesh make_half_ball_mesh(const HalfBallMeshSpec& spec);

/// A slice of a cylinder along y in plane strain, meshed alike.
struct CylinderMeshSpec {
    double radius = 0;      ///< R
    double size = 0;        ///< element edge h in the contact patch, along x
    double patch_x = 0;     ///< half width of the patch; a whole number of `size`
    double half_y = 0;      ///< of the slice, between two planes of symmetry, y = 0 and half_y
    double growth = 1.8;    ///< see HalfBallMeshSpec
    double hub_radius = 0;  ///< 0: half of a solid cylinder; else all of it, around a rigid hub
    /// Around a hub: elements of the patch are equal along the surface instead of along x, so that
    /// the patch is the same anywhere around it.
    bool rolls = false;
};

/// The half of the cylinder about the line x = z = 0, as a substrate of its own, see
/// make_half_ball_mesh(); its base is the plane z = -R through the axis. With a hub the whole
/// cylinder, its base the hub's surface about this axis. All of its length is contact. Throws
/// contact::InputError as make_half_ball_mesh() does, and for a hub that is not thinner than R.
HexMesh make_cylinder_mesh(const CylinderMeshSpec& spec);

}  // namespace tricontact::meshes
