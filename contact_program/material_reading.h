#pragma once

#include "contact_program/program_case.h"

namespace tricontact::contact_program {

/// M = 1: FG and TC of bodies that creep.
void read_creep(InputLines& lines, ProgramCase& one);
/// M = 4: the layer between the bodies.
void read_third_body(InputLines& lines, ProgramCase& one);
/// H = 3: what both bodies do with heat.
void read_heat(InputLines& lines, ProgramCase& one);

}  // namespace tricontact::contact_program
