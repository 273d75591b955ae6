#pragma once

#include <optional>
#include <string>

#include "contact_program/case_parts.h"
#include "contact_program/import.h"

namespace tricontact::contact_program {

/// The case that is pressed, loaded and perhaps rolled back and forth in whole periods of equal
/// steps as these shifts are (T = 0, 1): its steps are theirs. Empty where there is none.
/// `heading`: what comes before the sections. Throws contact::InputError, naming file and line, as
/// parse_case().
std::optional<std::string> sequence_case(ProgramSequence steps, const std::string& name,
                                         bool is_coupled, const std::string& heading);

/// The case that follows these shifts row by row, whatever they are ([path]). Throws
/// contact::InputError for what no row says. `pressed_depth`: see import_cases().
std::string path_case(ProgramSequence steps, const std::string& name, const std::string& heading,
                      const PressedDepth& pressed_depth);

/// The normal problem alone, T = 0, as a case without tangential load.
std::string pressing_case(ProgramSequence steps, const std::string& name, bool is_coupled,
                          const std::string& heading);

/// The case that rolls on as this steady state does (T = 3), or as these steps from rest do (T = 2
/// after pressing). Throws contact::InputError as path_case().
std::string rolling_case(ProgramSequence steps, const std::string& name,
                         const std::string& heading);

}  // namespace tricontact::contact_program
