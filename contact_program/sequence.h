#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/case.h"
#include "contact/compliances/compliance.h"
#include "contact_program/sequence_step.h"

namespace tricontact::contact_program {

/// The steps of a case from the first touch to the end of its last period: whether it settles
/// before is not known ahead. What rolls on is pressed, rolls on from rest, and is steady at last.
/// `is_coupled`: normal and tangential contact, so that the way of pressing matters; else the
/// contact is pressed in one step. Throws contact::InputError, naming the key, for a case that such
/// a sequence cannot say.
std::vector<SequenceStep> sequence_of(const contact::Case& c, bool is_coupled);

/// How many times the substrate's shear modulus a rigid indenter has in such a sequence, which
/// knows no rigid body: the elasticity of the pair is off by its inverse. A file's body is taken
/// for rigid from a tenth of it on.
inline constexpr double rigid_shear_ratio = 1e10;

/// The case as input of CONTACT's module 3 (docs/reference/contact-program.md): one of its cases
/// per step, on these cells, the first of them with materials, cells and friction. The indenter is
/// body 1, the substrate body 2; mm, N, N/mm^2. `influence`: name of the file of the coefficients,
/// C = 9; empty: half-spaces, C = 2. Throws contact::InputError as sequence_of(), and for too many
/// cells.
std::string sequence_text(const contact::Case& c, const contact::ContactPoints& grid,
                          bool is_coupled, const std::optional<std::string>& influence);

/// Shear moduli of indenter and substrate in such a text [Pa]; see rigid_shear_ratio.
struct ShearModuli {
    double indenter, substrate;

    /// CONTACT's G, 1/G = (1/G_1 + 1/G_2)/2; Kalker (1990), eq. 1.44.
    double combined() const { return 2 / (1 / indenter + 1 / substrate); }
};
ShearModuli shear_moduli(const contact::Case& c);

}  // namespace tricontact::contact_program
