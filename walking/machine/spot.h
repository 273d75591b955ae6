#pragma once

namespace tricontact::walking {

/// An elastic contact spot at the base of the body, or one spring of the bed of a rounded tip.
/// Lengths in units of b.
struct Spot {
    double position = 0;    ///< along the base, from its middle; negative is left, behind
    double height = 0;      ///< of its tip above the base plane
    double stiffness = 1;   ///< normal in units of k_z, tangential of k_x
    double offset = 0;      ///< of the spring from the tip, along the base
    double tip_radius = 0;  ///< of curvature; 0: a point, which does not roll

    bool operator==(const Spot&) const = default;
};

/// Approach of the spot to the ground when the body has sunk by z and turned by `rotation` Phi,
/// counter-clockwise; lengths in units of b. Wetter (2016), eq. B.4.1.
///
/// A rounded tip rolls: turned by Phi, the paraboloid s^2/(2 R) is the same one, its lowest point
/// moved by -R Phi and R Phi^2/2 lower. With the plane profile s^2/R of the method of
/// dimensionality reduction (Popov and Hess 2015) its springs approach by
///   d + R Phi^2/2 - (s + R Phi)^2/R = d - 2 s Phi - s^2/R - R Phi^2/2,
/// d = z - position Phi; `height` contains s^2/R. Wetter (2016), eq. B.1.1, with W = R Phi.
inline double approach(const Spot& spot, double z, double rotation) {
    return z - (spot.position + 2 * spot.offset) * rotation - spot.height -
           spot.tip_radius / 2 * rotation * rotation;
}

/// Lever of the normal force about the middle of the base, in units of b: -d approach/d Phi, so
/// that normal forces conserve energy. Over a rounded tip its mean, weighted with the forces, is
/// the place of its lowest point, position - R Phi.
inline double normal_lever(const Spot& spot, double rotation) {
    return spot.position + 2 * spot.offset + spot.tip_radius * rotation;
}

}  // namespace tricontact::walking
