#pragma once

namespace tricontact::contact {

/// The finite body of an indenter that deforms: finite elements mesh it, half-space models do not
/// see it. Its surface is that of the indenter's shape.
struct ElasticBody {
    /// Places in the table of forms, see body_forms(). Hemisphere, ball, cylinder and pin have the
    /// radius of the shape.
    enum class Form : int { hemisphere, ball, cylinder, punch, pin, block };
    /// What holds it: a rigid holder, bonded to the face opposite of the contact; a second plate
    /// like the substrate, pressed on the other side, whose contact is the mirror image of this
    /// one; a rigid hub in its axis. Or nothing but the contact: the load, concentrated in the
    /// middle of that face or spread evenly over it.
    enum class Support : int { holder, plates, hub, force, pressure };

    Form form = Form::hemisphere;
    Support support = Support::holder;
    double hub_radius = 0;  ///< of Support::hub [m]
    double height = 0;      ///< of forms whose shape does not say it [m]

    /// Nothing holds it but the contact.
    bool is_loose() const { return support == Support::force || support == Support::pressure; }
};

}  // namespace tricontact::contact
