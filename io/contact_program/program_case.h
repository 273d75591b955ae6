#pragma once

#include <array>
#include <string>
#include <vector>

#include "contact/vector2.h"
#include "io/contact_program/input_lines.h"

namespace tricontact::io {

/// The control digits of a case of CONTACT's module 3, as far as they say what the case is.
struct CaseDigits {
    int line = 0;        ///< of the first of them
    int previous = 0;    ///< P: 0 goes on from the case before, 2 begins again
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

/// One case of an input file of CONTACT's module 3, complete: what it keeps of the one before is
/// copied. SI units.
struct ProgramCase {
    CaseDigits digits;
    int loads_line = 0;
    double normal = 0;              ///< F_N [N], or d [m] where N = 0
    contact::Vector2 tangential{};  ///< FX, FY over mu F_N on body 1, or shifts [m] by F

    double tolerance = 0;                              ///< EPS
    double friction_coefficient = 0;                   ///< of the last L = 0
    std::array<double, 2> poisson{}, shear_modulus{};  ///< bodies 1 and 2 [-], [Pa]

    int cells_line = 0;
    bool is_hertzian = false;  ///< cells and distance follow from Hertz' theory
    int n_x = 0, n_y = 0;
    contact::Vector2 first{}, spacing{};  ///< centre of the first cell, and their size [m]

    int distance_line = 0;
    contact::Vector2 curvature{};  ///< A, B [1/m] of h = A (x - x0)^2 + B (y - y0)^2
    contact::Vector2 offset{};     ///< (x0, y0) [m]
};

/// Reads all cases of an input file; `name` stands for it in messages. Throws contact::InputError
/// with line and column for what is no such file, or is no case here.
std::vector<ProgramCase> read_program_cases(std::string text, const std::string& name);

}  // namespace tricontact::io
