#pragma once

#include "contact_program/program_case.h"

namespace tricontact::contact_program {

/// Reads the constants of L into `one`, as many `sets` of them as cells along y where friction
/// varies.
void read_friction(InputLines& lines, ProgramCase& one, int sets);

}  // namespace tricontact::contact_program
