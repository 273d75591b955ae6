#pragma once

namespace tricontact::theory {

/// Rigid sliding of the indenter over the substrate per rolled way, rolling towards +x; friction
/// acts on the substrate along it.
struct Creepage {
    double longitudinal = 0;  ///< xi [-], along the rolling direction x
    double lateral = 0;       ///< eta [-], along y
    double spin = 0;          ///< phi [1/m], from x towards y
};

}  // namespace tricontact::theory
