#pragma once

#include <array>

#include "contact/base/vector2.h"
#include "contact/load_path.h"

namespace tricontact::contact_program {

/// One step as the program CONTACT takes it, written for it or read from its input: quasi-static in
/// coordinates that are fixed to the substrate, or rolling on in those that move with the contact.
struct SequenceStep {
    /// T: a shift, a step of one cell further, the steady state.
    enum class Motion { shift = 1, rolls_on, steady };

    bool tangential = true;  ///< else pressing without friction, T = 0
    Motion motion = Motion::shift;
    contact::NormalControl normal;  ///< at the end of the step; d of the body's lowest point
    /// Along x and y the force on the substrate over mu F_N [-], or the shift of this step [m]; of
    /// rolling on the creepage [-].
    std::array<contact::TangentialControl, 2> along{no_force, no_force};
    contact::Vector2 offset{};  ///< of the indenter [m]
    double rotation = 0;        ///< of the indenter in this step [rad]; spin of rolling on [rad/m]
    contact::Vector2 centre{};  ///< that rotation and shift are about [m]

    bool is_rolling() const { return tangential && motion != Motion::shift; }
    bool is_steady() const { return tangential && motion == Motion::steady; }
    bool by_force() const { return normal.kind == contact::NormalControl::Kind::force; }
    /// Along both axes, whatever they are.
    contact::Vector2 values() const { return {along[0].value, along[1].value}; }

    static constexpr contact::TangentialControl no_force{contact::TangentialControl::Kind::ratio};
    bool is_forced(int axis) const { return along[axis].kind == no_force.kind; }
    /// CONTACT's digit F: along how many axes a force is prescribed, x before y.
    int n_forced() const { return is_forced(0) + is_forced(1); }
};

}  // namespace tricontact::contact_program
