#pragma once

#include <string>

#include "bem/influence_file.h"

namespace tricontact::bem {

/// The table as the program CONTACT reads numerical coefficients (C = 9), the indenter being its
/// body 1. `shear_modulus`: the combined G of its input [Pa], by which it divides them;
/// docs/contact-program.md has the signs. Unless `coupled`, no coefficient couples normal and
/// tangential contact, whatever the table has.
std::string contact_program_influence(const InfluenceTable& table, double shear_modulus,
                                      bool coupled);

}  // namespace tricontact::bem
