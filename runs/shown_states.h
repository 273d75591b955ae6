#pragma once

// What `run` and `roll` have in common where they write states for ParaView.

#include <cstddef>
#include <string>

#include "contact/case.h"
#include "contact/mirrored_surface.h"
#include "io/results/vtk_indenter.h"

namespace tricontact::runs {

/// The indenter, 1.5 times as wide as Hertz' contact of the case: a state of pressing may have a
/// much smaller one. A body along y is as long as the surface under it.
io::IndenterShape shown_indenter(const contact::Case& c, const contact::SurfaceView& surface);

/// The line that tells how much is to come: at most `n` states of so many bytes each.
std::string size_of_states(const std::string& model, double n, std::size_t bytes);

}  // namespace tricontact::runs
