#pragma once

#include <optional>
#include <string>

namespace tricontact::contact {

/// The finite body of an indenter that deforms: finite elements mesh it, half-space models do not
/// see it. Its surface is that of the indenter's shape.
struct ElasticBody {
    /// Places in the table of forms, see body_forms(). Hemisphere, ball, cylinder and pin have the
    /// radius of the shape.
    /// `mesh`: whatever a file holds, which says by its groups what holds it.
    enum class Form : int { hemisphere, ball, cylinder, punch, pin, block, mesh };
    /// What holds it: a rigid holder, bonded to the face opposite of the contact; a second plate
    /// like the substrate, pressed on the other side, whose contact is the mirror image of this
    /// one; a rigid hub in its axis. Or nothing but the contact: the load, concentrated in the
    /// middle of that face or spread evenly over it.
    enum class Support : int { holder, plates, hub, force, pressure };

    Form form = Form::hemisphere;
    Support support = Support::holder;
    double hub_radius = 0;                 ///< of Support::hub [m]
    double height = 0;                     ///< of forms whose shape does not say it [m]
    std::optional<std::string> mesh = {};  ///< of Form::mesh: a gmsh file
    double mesh_unit = 1;                  ///< length of 1 in that file [m]

    /// The key that gives the body.
    const char* key() const { return form == Form::mesh ? "indenter.mesh" : "indenter.body"; }
    /// Nothing holds it but the contact.
    bool is_loose() const { return support == Support::force || support == Support::pressure; }
};

}  // namespace tricontact::contact
