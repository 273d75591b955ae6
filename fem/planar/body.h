#pragma once

#include <memory>
#include <vector>

#include "contact/substrates/material.h"
#include "fem/matrices.h"
#include "fem/planar/element.h"
#include "fem/planar/mesh.h"

namespace tricontact::fem::planar {

/// How a body is held where its section says `support`.
enum class Support {
    bonded,   ///< not displaced at all
    sliding,  ///< not displaced along z: a frictionless ground, or the middle plane of a body
              ///< between two equal plates; a whole section along x in its middle alone
    // What nothing holds but the contact:
    point,  ///< a force presses it at the node of the support nearest to x = 0, whose displacement
            ///< is part of the approach
    even,   ///< a pressure presses it all over its support, whose mean displacement is part of it
    /// The same, not displaced along x there: the middle plane under loads that are opposite on
    /// both sides of it. With `sliding`, under equal ones, all loads on both sides are known.
    opposite
};

/// Nothing holds it along z but the contact.
constexpr bool is_loose(Support support) {
    return support == Support::point || support == Support::even || support == Support::opposite;
}
/// Its displacements count from the mean of its support.
constexpr bool counts_from_mean(Support support) {
    return support == Support::even || support == Support::opposite;
}

/// Along what a contact surface is measured, and across what bodies approach.
enum class Frame {
    plane,  ///< x; along -z
    round   ///< radius times the angle from the lowest point; along the radius of the body's circle
};

class WholeSection;

struct BodyProblem {
    Mesh mesh;
    Solid solid = Solid::plane_strain;
    contact::Material material{0, 0};
    Support support = Support::bonded;
    Frame frame = Frame::plane;
    double radius = 0;                ///< of a round frame, whose centre is (0, radius) [m]
    double largest_bulk_ratio = 1e6;  ///< K/G is cut here
};

/// A body as its contact surface sees it: nodes in the order of their coordinate along it.
struct CondensedSection {
    Solid solid = Solid::plane_strain;
    std::vector<double> along;  ///< coordinate of each node [m]
    std::vector<double> x;      ///< of each node, what the extent depends on [m]
    /// Elements of the surface: numbers of their first, middle and last node.
    std::vector<std::array<int, 3>> edges;
    /// Displacement [m] over force [N] (of plane strain over force per length [N/m]): 2n x 2n, by
    /// columns, symmetric; components along the surface of all nodes first, then those into the
    /// substrate. Rows and columns of what the plane or axis of symmetry holds are zero.
    std::vector<double> compliance;
    /// Force along z of what holds the body, plus the force, under unit forces on these components:
    /// zero but for rounding.
    std::vector<double> missing_reaction;
    bool is_pinned = false;                     ///< a node alone holds it along z, see is_loose()
    std::shared_ptr<const WholeSection> whole;  ///< for its inside

    std::size_t size() const { return along.size(); }
};

/// Discretises and condenses. Throws contact::InputError (inverted elements, no contact),
/// contact::NotConverged (nothing holds the body).
CondensedSection condense(const BodyProblem& problem);

}  // namespace tricontact::fem::planar
