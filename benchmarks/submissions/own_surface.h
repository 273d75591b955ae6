#pragma once

#include <string>

#include "benchmarks/submissions/submission.h"

namespace tricontact::benchmarks {

/// The last fields of a surface of `tricontact run` (io::is_state_series), SI: tractions on the
/// substrate, displacements with z into it. Of a line of springs x alone; cells bring their area.
/// Throws contact::InputError.
MeshField read_own_surface(const std::string& file);

}  // namespace tricontact::benchmarks
