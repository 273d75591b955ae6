#pragma once

#include <optional>
#include <string>

#include "contact/case.h"
#include "contact/solvers/contact_share.h"

namespace tricontact::fem {

/// How the sides of the layer's block are held.
enum class Sides { free, fixed };

/// How displacements are solved for: by a factor of the stiffness, condensed to the contact patch;
/// by iteration for each state of the contact; or by the first where its memory is there.
enum class Solver { automatic, direct, iterative };

/// Of the finite element layer. Kept with a case, see contact::Case::of().
struct Settings {
    std::optional<double> size;      ///< edge of an element in the contact patch [m]
    std::optional<double> accuracy;  ///< of the normal contact [-]: size is chosen for it
    double growth = 1.8;             ///< of neighbouring elements, outwards from the patch
    Sides sides = Sides::free;
    Solver solver = Solver::automatic;
    double tolerance = 1e-6;          ///< of the contact solvers [-]
    std::optional<std::string> mesh;  ///< a mesh file instead of a mesh of our own
    double mesh_unit = 1;             ///< length of 1 in that file [m]
    std::string cache;  ///< folder for condensed layers; empty: the user's; "none": not kept
};

/// What of a case the iterative solver does not compute, with its key; empty: it computes all.
inline std::string not_iterative(const contact::Case& c) {
    const auto law = c.friction.law();
    if (c.indenter.body || c.has_rigid_substrate) return "an indenter that deforms";
    if (c.of<Settings>().mesh) return "the mesh of a file (fem.mesh)";
    if (c.is_cylindrical()) return "a cylinder or roller (indenter.shape)";
    if (c.law != contact::Case::Law::linear) return "finite strains (substrate.material)";
    if (c.relaxation) return "a substrate that relaxes (substrate.relaxation)";
    if (c.interface.is_elastic()) return "an elastic interface ([interface])";
    if (c.adhesion) return "surfaces that attract each other ([adhesion])";
    if (!c.contact.coupling) return "uncoupled contact (contact.coupling)";
    if (law->remembers() || contact::jumps_at_edge(*law))
        return "friction that remembers or has a shear strength ([friction])";
    return {};
}

}  // namespace tricontact::fem
