#pragma once

#include <string>

#include "benchmarks/submissions/submission.h"

namespace tricontact::benchmarks {

/// Whether a file holds a surface as `tricontact run` writes it.
bool is_own_surface(const std::string& file);

/// Its last fields, SI: tractions on the substrate, displacements with z into it. Of a line of
/// springs x alone; cells bring their area. Throws contact::InputError.
MeshField read_own_surface(const std::string& file);

}  // namespace tricontact::benchmarks
