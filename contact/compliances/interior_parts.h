#pragma once

#include <cstdint>

#include "contact/compliances/interior.h"

namespace tricontact::contact {

/// Interior::region of the hexahedra of an indenter that deforms; its points are its own.
inline constexpr std::uint8_t indenter_region = 2;

bool has_indenter(const Interior& interior);
bool has_substrate(const Interior& interior);

/// All hexahedra of a body as those of the indenter.
Interior as_indenter(Interior body);

/// Both bodies, the indenter's points and hexahedra behind those of the substrate; energy of both,
/// forces of the substrate.
Interior joined_bodies(Interior substrate, const Interior& indenter);

/// The substrate alone, with the numbers of both.
Interior substrate_part(const Interior& both);

/// A rigid motion of the indenter: rolled by `offset` along x about its axis, which is
/// `rolling_radius` above the plane, moved by `shift` in the plane and `indentation` into the
/// substrate, turned by `rotation` about the normal through its lowest point. Of both bodies only
/// the indenter changes: its displacements, and with its axes its stresses.
struct RigidMotion {
    Vector2 shift{};            ///< [m]
    double indentation = 0;     ///< [m]
    double rotation = 0;        ///< from x towards y [rad]
    double offset = 0;          ///< [m]
    double rolling_radius = 0;  ///< [m]; 0: the offset alone moves it
};
void move_indenter(const RigidMotion& motion, Interior& both);

}  // namespace tricontact::contact
