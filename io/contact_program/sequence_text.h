#pragma once

#include <optional>
#include <string>

#include "contact/case.h"
#include "contact/solvers/compliance.h"

namespace tricontact::io {

/// The case as input of CONTACT's module 3 (docs/contact-program.md): one of its cases per step, on
/// these cells, the first of them with materials, cells and friction. The indenter is body 1, the
/// substrate body 2; mm, N, N/mm^2. `influence`: name of the file of the coefficients, C = 9;
/// empty: half-spaces, C = 2. Throws contact::InputError as sequence_of(), and for too many cells.
std::string sequence_text(const contact::Case& c, const contact::ContactPoints& grid,
                          bool is_coupled, const std::optional<std::string>& influence);

/// Shear moduli of indenter and substrate in such a text [Pa]; see rigid_shear_ratio.
struct ShearModuli {
    double indenter, substrate;

    /// CONTACT's G, 1/G = (1/G_1 + 1/G_2)/2; Kalker (1990), eq. 1.44.
    double combined() const { return 2 / (1 / indenter + 1 / substrate); }
};
ShearModuli shear_moduli(const contact::Case& c);

}  // namespace tricontact::io
