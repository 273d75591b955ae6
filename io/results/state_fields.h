#pragma once

#include <cstdint>
#include <vector>

#include "contact/compliances/interior.h"
#include "contact/surface.h"
#include "io/results/exodus_file.h"

namespace tricontact::io {

/// At the points of a surface: what solvers leave as a gap where it touches is 0.
void add_surface_fields(ExodusFields& out, const contact::Surface& s);

/// The state that has the largest share of each element, by Simpson's weights of its nodes.
std::vector<std::uint8_t> states_of_quads(const contact::Surface& s);

/// At the points of the inside, `n` of them.
void add_point_fields(ExodusFields& out, const contact::Interior& interior, std::size_t n);

}  // namespace tricontact::io
