#pragma once

#include <array>
#include <string>
#include <vector>

#include "contact/vector2.h"
#include "io/contact_program/input_lines.h"

namespace tricontact::io {

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
