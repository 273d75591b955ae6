#pragma once

#include <cstdint>
#include <vector>

#include "contact/compliances/compliance.h"
#include "contact/interface.h"
#include "fem/condensed_layer.h"

// Frames: elements have z out of their body and x, y, z of each node; contact has z into the
// substrate. The cross blocks of the substrate change their sign, normal and tangential ones stay:
//
//    fem:  z ^                  contact:   --------> x
//            |                                 |
//            +-----> x                         v z,  p > 0 into the substrate
//
// An indenter that deforms is condensed as a substrate of its own, mirrored in z, so that its z is
// contact's. Pressure and traction act on it the other way round, and its displacement is
// subtracted: no block changes the sign.
//
// Where a traction jumps, what it displaces across the surface swings from node to node, by a few
// per cent of tau h/G: a law of friction that jumps at the edge of the contact would roughen that
// edge. What each element displaces on the mean does not (`by_element_means`).
//
// A mirrored body is half of one. Forces on the whole contact are twice those on the model, and the
// compliance is per force on the whole.

namespace tricontact::fem {

/// Which of two bodies in contact.
enum class Side : std::uint8_t { substrate, indenter };

/// What the contact of a body on its own would see.
struct ContactSide {
    contact::ContactPoints points;
    std::vector<double> compliance;  ///< as contact::Compliance::dense() says
};

/// The compliance of the patch in the frame of contact, moved out of `layer`. What a plane of
/// symmetry holds stays where it is.
std::vector<double> in_contact_frame(CondensedLayer& layer, Side side);

/// Of a round body of `radius` whose points have x along its surface, measured from the pole: turns
/// all components from x and z of the body to those of its points, along the surface and out of it.
void turn_to_round_frame(CondensedLayer& body, double radius);

/// Adds the springs of an elastic interface to a compliance, and says of its points what solvers
/// ask for: `line_length`, and `elastic_ratio`, that of ContactPoints::local_ratio without springs.
/// `by_element_means`: normal and tangential contact couple by what elements displace on the mean,
/// for tractions that jump.
ContactSide joined(contact::ContactPoints points, std::vector<double> compliance,
                   double line_length, double elastic_ratio, const contact::Interface& interface,
                   bool by_element_means);

}  // namespace tricontact::fem
