#pragma once

#include <cmath>
#include <optional>

#include "io/keys/input_file.h"
#include "statistics/estimate.h"

namespace tricontact::experiments {

/// m of F_lim ~ F_N^m from forces of full sliding under several loads: 1 of Coulomb's law, (2 +
/// n)/3 of tau ~ p^n under a sphere on a half-space (a and p grow with F_N^(1/3)), thus 2/3 of a
/// shear strength; (1 + n)/2 and 1/2 under a cylinder.
struct SlidingSlope {
    double slope = 0, standard_error = 0;  ///< [-]
    double quantile = 0;                   ///< of its interval of 95 %: Student's, or normal
    int n_forces = 0;
    double least_load = 0, largest_load = 0;  ///< [N]

    double half_width() const { return quantile * standard_error; }
    bool holds(double value) const { return std::abs(slope - value) <= half_width(); }
};

/// By regression of ln F_lim on ln F_N of measurement.sliding_force; empty without that table.
/// Errors that the table states are known, else they are taken as the same part of each force and
/// estimated. Throws contact::InputError for a table that has fewer than three loads.
std::optional<SlidingSlope> sliding_slope(const io::Document& document);

}  // namespace tricontact::experiments
