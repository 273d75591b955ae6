#pragma once

#include <optional>
#include <string>

namespace tricontact::bem {

/// Of boundary elements, beside their cells (contact::Cells). Kept with a case, see
/// contact::Case::of().
struct Settings {
    double tolerance = 1e-7;               ///< see TangentialSolver, NormalSolver
    std::optional<std::string> influence;  ///< file of influence coefficients to be used
    std::optional<double> volume_depth;    ///< of the inside that is computed [m]; empty: 3 a
};

}  // namespace tricontact::bem
