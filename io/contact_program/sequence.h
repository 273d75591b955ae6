#pragma once

#include <vector>

#include "contact/case.h"
#include "contact/load_path.h"

namespace tricontact::io {

/// One quasi-static step as the program CONTACT takes it in world-fixed coordinates.
struct SequenceStep {
    bool tangential = true;         ///< a shift, T = 1; else pressing without friction, T = 0
    contact::NormalControl normal;  ///< at the end of the step
    double force_ratio = 0;         ///< F_T/(mu F_N) along x on the substrate [-]
    contact::Vector2 offset{};      ///< of the indenter's lowest point [m]
};

/// The steps of a case from the first touch to the end of its last period: whether it settles
/// before is not known ahead. `is_coupled`: normal and tangential contact, so that the way of
/// pressing matters; else the contact is pressed in one step. Throws contact::InputError, naming
/// the key, for a case that such a sequence cannot say.
std::vector<SequenceStep> sequence_of(const contact::Case& c, bool is_coupled);

/// How many times the substrate's shear modulus a rigid indenter has in such a sequence, which
/// knows no rigid body: the elasticity of the pair is off by its inverse. A file's body is taken
/// for rigid from a tenth of it on.
inline constexpr double rigid_shear_ratio = 1e10;

}  // namespace tricontact::io
