#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/resolution/refinement.h"
#include "comparisons/shakedown/fitted_form.h"
#include "comparisons/shakedown/rolling_points.h"
#include "theory/rolling/rolled_law.h"

namespace tricontact::comparisons {

/// Shakedown limit of a model at one amplitude, from its own pressures.
struct LimitPoint {
    double amplitude_ratio = 0;  ///< w
    Computed limit;              ///< f_T,lim
};

/// One number k for f_T,lim = 1 - k w (1 - w^2) - w^3, which has the ends right whatever the
/// pressures: k = 3/2 for Hertz' (exact, see theory::shakedown_limit, which ends there), else a
/// fit. Of another law RolledLaw::limit_form, with MDR's kappa for round contacts. Empty below two
/// points.
std::optional<FittedForm> fit_limit(std::vector<LimitPoint> limits, double confidence,
                                    const theory::RolledLaw& law = theory::coulomb_rolling);

/// A ratcheting point with eta = Du/(w - w_lim) (3.3.1), w_lim being the model's own limit.
struct RatchetingPoint {
    RollingPoint at;
    Computed amplitude_limit;  ///< w_lim at this f_T
    Computed eta;              ///< ill-conditioned near the limit: its bar says how much
    /// Du of the thesis' formula (3.3.4 parallel, 3.4.15 perpendicular) with its own limit, over
    /// the model's; NaN in other directions, and under another law than Coulomb's.
    double thesis_ratio = 0;
};

/// Points of one load.
struct RatchetingLoad {
    double tangential_ratio = 0, static_shift_ratio = 0;  ///< f_T, u_stat
    Computed amplitude_limit;
    std::optional<FittedForm> slope;  ///< Du = eta (w - w_lim); empty below two amplitudes
};

/// Ratcheting of one model and group.
struct RatchetingGroup {
    std::string model, group;
    double angle = 0;                     ///< [rad]
    std::optional<FittedForm> limit;      ///< see fit_limit; over all loads
    std::vector<RatchetingPoint> points;  ///< with w above w_lim
    std::vector<RatchetingLoad> loads;    ///< f_T increasing
    std::optional<FittedForm> root;  ///< Du = c u_stat^(1/2) (w - w_lim); below three points empty
    std::optional<FittedForm>
        root_of_eta;                ///< eta = c u_stat^(1/2) over loads (3.3.2); below three empty
    int n_turning_points_only = 0;  ///< ratcheting, but in steps too coarse for a shift per period
};

/// Groups in the order of the points.
std::vector<RatchetingGroup> ratcheting_fits(
    const std::vector<RollingPoint>& points, double confidence,
    const theory::RolledLaw& law = theory::coulomb_rolling);

}  // namespace tricontact::comparisons
