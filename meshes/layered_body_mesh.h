#pragma once

#include <functional>

#include "meshes/hex_mesh.h"

namespace tricontact::meshes {

/// A ball around a rigid hub in its middle, see make_half_ball_mesh(). Lengths in m.
struct HubBallMeshSpec {
    double radius = 0;                ///< R
    double hub_radius = 0;            ///< of the hub, whose surface is the base
    double size = 0;                  ///< element edge h in the contact patch, along x and y
    double patch_x = 0, patch_y = 0;  ///< half sides of the patch; whole numbers of `size`
    double growth = 1.8;              ///< of neighbouring elements, outwards; inwards growth^0.8
    bool half_model = false;          ///< y >= 0 only, plane of symmetry y = 0
    /// Elements of the patch are equal along the surface instead of along x: turned about the axis
    /// along y through the middle, the patch is the same.
    bool rolls = false;
};

/// All of the ball, as a substrate of its own, whose contact patch is about the pole in the origin.
/// Throws contact::InputError as make_half_ball_mesh() does.
HexMesh make_hub_ball_mesh(const HubBallMeshSpec& spec);

/// A round punch, as high as `height` in its middle.
struct PunchMeshSpec {
    double radius = 0;                ///< of the punch, with its edge
    double height = 0;                ///< from the middle of the contact to the base
    double size = 0;                  ///< element edge h in the contact patch, along x and y
    double patch_x = 0, patch_y = 0;  ///< half sides of the patch; whole numbers of `size`
    double growth = 1.8;              ///< as of a ball
    bool half_model = false;          ///< y >= 0 only, plane of symmetry y = 0
    /// How far the surface lies below z = 0 at a distance from the axis.
    std::function<double(double)> profile;
};

/// The punch as a substrate of its own: z out of it, its surface below z = 0, its base in
/// z = -height. Throws contact::InputError where the patch does not fit its face, or the edge is
/// higher than the punch.
HexMesh make_punch_mesh(const PunchMeshSpec& spec);

}  // namespace tricontact::meshes
