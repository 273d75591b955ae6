#pragma once

#include <string>
#include <vector>

#include "contact/case.h"

namespace tricontact::app {

/// A case and which of its boundary element models is meant, "bem" or "bem-layer".
struct BoundaryElementCase {
    contact::Case c;
    std::string model;

    bool is_layer() const { return model == "bem-layer"; }
};

/// Reads the case with the model that is asked for; empty: its only one. Throws InputError.
BoundaryElementCase read_boundary_elements(const std::string& case_file,
                                           const std::vector<std::string>& overrides,
                                           const std::string& asked);

}  // namespace tricontact::app
