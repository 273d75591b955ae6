#pragma once

#include <string>

#include "bem/influence_file.h"

namespace tricontact::bem {

/// The table as the program CONTACT reads numerical coefficients (C = 9), the indenter being its
/// body 1. `shear_modulus`: the combined G of its input [Pa], by which it divides them;
/// docs/reference/contact-program.md has the signs. Unless `coupled`, no coefficient couples normal
/// and tangential contact, whatever the table has.
std::string contact_program_influence(const InfluenceTable& table, double shear_modulus,
                                      bool coupled);

/// Reads such a file back: one matrix for all, body 1 convex, columns n x y, of square cells,
/// ix >= 0 and iy of both signs. Throws contact::InputError with file and line for another one, and
/// for bodies without the symmetries of an influence table.
InfluenceTable read_contact_program_influence(const std::string& path, double shear_modulus);

}  // namespace tricontact::bem
