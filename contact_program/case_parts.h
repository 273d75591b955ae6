#pragma once

#include <span>
#include <string>

#include "contact/substrates/material.h"
#include "contact_program/program_case.h"

namespace tricontact::contact_program {

/// Consecutive cases of a file that go on from each other.
using ProgramSequence = std::span<const ProgramCase>;

/// One row of cells: a body that is straight along y.
inline bool is_line_contact(const ProgramCase& one) {
    return one.n_y == 1;
}

/// Both bodies; a very stiff indenter is taken for rigid (see rigid_shear_ratio).
contact::MaterialPair materials_of(const ProgramCase& one);

/// Temperatures are asked for, and a case here has them: in steady rolling.
bool has_heat(const ProgramCase& one);

/// Where the origin of a case lies in the coordinates of the file [m]: at the centre of the cell
/// that is nearest to the body's lowest point, or under the middle node of its heights, so that
/// both have the same cells.
contact::Vector2 origin_of_case(const ProgramCase& one);
/// Whether the lowest point of a body lies beside that of the origin.
bool is_beside_origin(const ProgramCase& one);

/// Sections [indenter], [substrate] with what relaxes of it, [friction], [interface], [contact] and
/// those of heat of a case file. Throws contact::InputError, naming file and line, for viscoelastic
/// bodies that are not alike.
std::string bodies_text(const ProgramCase& one, const std::string& name);
/// "normal_force = ..." or "indentation = ...".
std::string normal_text(const ProgramCase& one);
/// Cells under a quadratic body that are no squares.
bool has_rectangles(const ProgramCase& one);
/// Section [bem], the last one: cells of DX x DY, of which one has its centre at `shift` from the
/// origin, over its sides.
std::string cells_text(const ProgramCase& one, const contact::Vector2& shift = {});

/// Throws contact::InputError, naming file and line, for what changes within a sequence besides
/// loads and places.
void check_alike(ProgramSequence steps, const std::string& name);

/// Equal but for the rounding of values in a file.
bool is_close(double a, double b);

}  // namespace tricontact::contact_program
