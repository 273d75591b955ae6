#pragma once

#include <string>

#include "contact_program/input_lines.h"

namespace tricontact::contact_program {

/// The control digits of a case of CONTACT's module 3, as far as they say what the case is.
struct CaseDigits {
    int line = 0;       ///< of the first of them
    int lines[3] = {};  ///< of the three words
    int previous =
        0;          ///< P: 0 goes on from the case before, 1 with its normal part, 2 begins again
    int bound = 0;  ///< B: 0 the full normal problem
    int tangential = 0;  ///< T: 0 none, 1 shift, 2 rolling from step to step, 3 steady rolling
    int normal = 0;      ///< N: 0 depth, 1 force
    int force = 0;       ///< F: which of x and y have a force, 0 to 2
    int stress = 0;      ///< S: points inside; 0 none, 2 and 3 read what is due
    int variable = 0;    ///< V: 0 friction is the same everywhere; else one set of it per row
    int friction = 0;    ///< L: 0, 2 to 4, 6 laws, 1 kept
    int cells = 0;       ///< D: 2 new, else kept
    int influence = 0;   ///< C: 0, 1 kept, 2 half-space, 9 of a file
    int material = 0;    ///< M: 0 elastic, 1 viscoelastic
    int distance = 0;    ///< Z: 2 new, else kept
    int extra = 0;       ///< E: 9 slip of every cell, 1 kept
    int debug = 0;       ///< X
    int heat = 0;        ///< H: temperatures; 3 with data
    int solver = 0;      ///< G: 1 kept
    int after = 0;       ///< R: 0, 2 go on in the module, 1, 3 return
};

/// Reads the three words. Throws contact::InputError for what are no digits of CONTACT.
CaseDigits read_case_digits(InputLines& lines);

/// Throws contact::InputError for a digit that no case here says.
void check_known_digits(const CaseDigits& digits, const std::string& name);

}  // namespace tricontact::contact_program
