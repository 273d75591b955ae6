#pragma once

#include <vector>

#include "contact_program/program_case.h"

namespace tricontact::contact_program {

/// What IPOTCN < 0 says of a Hertzian contact: the way, and the values after MX and MY.
struct HertzInput {
    int way = 0;
    std::vector<InputNumber> values;
};

/// A, B [1/m] of the body, and half the sides of the cells together [m].
struct HertzianCells {
    contact::Vector2 curvature, half_side;
};

/// Hertz' theory: curvatures from half axes or the other way round, under the case's loads (Johnson
/// 1985, sections 4.2 and 4.3). Throws contact::InputError for values out of range.
HertzianCells hertzian_cells(const ProgramCase& one, const HertzInput& input,
                             const InputLines& lines);

/// Reads IBASE, IPLAN and what belongs to them into `one`, whose cells are known.
void read_distance(InputLines& lines, ProgramCase& one);
/// Heights of all cells by this function of x and y [m].
void set_heights(ProgramCase& one, std::function<double(double x, double y)> height);

}  // namespace tricontact::contact_program
