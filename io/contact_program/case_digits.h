#pragma once

#include "io/contact_program/input_lines.h"

namespace tricontact::io {

/// The control digits of a case of CONTACT's module 3, as far as they say what the case is.
struct CaseDigits {
    int line = 0;        ///< of the first of them
    int previous = 0;    ///< P: 0 goes on from the case before, 2 begins anew
    int tangential = 0;  ///< T: 0 none, 1 shift
    int normal = 0;      ///< N: 0 depth, 1 force
    int force = 0;       ///< F: which of x and y have a force, 0 to 2
    int friction = 0;    ///< L: 0 new, 1 kept
    int cells = 0;       ///< D: 0 kept, 2 new
    int influence = 0;   ///< C: 0 kept, 2 half-space
    int distance = 0;    ///< Z: 0 kept, 2 new
    int solver = 0;      ///< G: 0 new settings, 1 kept
    int after = 0;       ///< R: 0 goes on in the module, 1 returns
};

/// Reads the three words of digits. Throws contact::InputError for what no case file here says,
/// with the digit's letter.
CaseDigits read_digits(InputLines& lines);

}  // namespace tricontact::io
