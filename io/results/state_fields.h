#pragma once

#include <cstdint>
#include <vector>

#include "contact/compliances/interior.h"
#include "contact/mirrored_surface.h"
#include "io/results/exodus_file.h"

namespace tricontact::io {

/// Numbers and fields of a state, after which others may be added.
void begin_state(ExodusFields& out, const Instant& instant, const contact::SurfaceView& surface);
void begin_state(ExodusFields& out, const Instant& instant, const contact::Interior& interior);

/// At the points of a surface: what solvers leave as a gap where it touches is 0.
void add_surface_fields(ExodusFields& out, const contact::SurfaceView& s);

/// The state that has the largest share of each element, by Simpson's weights of its nodes.
std::vector<std::uint8_t> states_of_quads(const contact::SurfaceView& s);

/// At the points of the inside, `n` of them.
void add_point_fields(ExodusFields& out, const contact::Interior& interior, std::size_t n);

}  // namespace tricontact::io
