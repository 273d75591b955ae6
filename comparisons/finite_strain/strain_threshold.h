#pragma once

#include <array>
#include <optional>
#include <vector>

namespace tricontact::comparisons {

/// Deviations of the linear model for which it is asked where they begin.
inline constexpr std::array<double, 3> strain_tolerances{.01, .02, .05};

/// How far the linear model is off at one load, thickness or tangential force.
struct DeviationPoint {
    double at = 0;         ///< abscissa, any unit
    double deviation = 0;  ///< value of the linear model over that at finite strains, minus 1
    double error = 0;      ///< half width of its interval
};

/// Where along an abscissa the size of a deviation first exceeds a tolerance.
struct StrainThreshold {
    std::optional<double> at = {};  ///< empty: nowhere, or everywhere
    bool from_begin = false;        ///< exceeded at the first point already
    bool returns = false;           ///< falls below the tolerance again further on
    /// Where the size plus and minus its error does. Without `low` it does so from the first point
    /// on, or nowhere; without `high` not up to the last one.
    std::optional<double> low = {}, high = {};
};

/// Of points in increasing order: deviation and error are monotone interpolants (PCHIP, Fritsch and
/// Carlson 1980), nothing is extrapolated. `of_force`: the abscissa is a normal force. Then both
/// are 0 without it and interpolated over its cube root: strains grow as the contact radius over
/// that of the indenter, thus deviations do. Empty for fewer than four points, that without force
/// included.
std::optional<StrainThreshold> strain_threshold(std::vector<DeviationPoint> points,
                                                double tolerance, bool of_force);

}  // namespace tricontact::comparisons
