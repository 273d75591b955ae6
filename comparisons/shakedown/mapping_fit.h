#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/shakedown/fitted_form.h"
#include "comparisons/shakedown/rolling_points.h"
#include "report/document.h"
#include "theory/rolling/rolled_law.h"

namespace tricontact::comparisons {

/// A settled point with its mapping parameter kappa of f_T = f_static(u) - kappa w u, of Coulomb's
/// law 1 - kappa w u - (1 - u)^(3/2) (3.2.16).
struct MappingPoint {
    RollingPoint at;
    double limit_ratio = 0;    ///< f_T/f_T,lim, the limit being the model's own
    double low = 0, high = 0;  ///< all kappas that give u_sd within its bar; NaN without one
    /// Bar: that of u_sd times |dkappa/du| = |f_static'(u) - kappa w|/(w u), which grows without
    /// bound where w u is small. Shifts are what to compare, not kappa.
    Computed kappa;
};

/// How well one kappa for all points gives the shifts back.
struct MappingUse {
    std::string name;              ///< "fitted", "thesis", "mdr"
    double kappa = 0;              ///< in (0, that of MDR]
    double median = 0, worst = 0;  ///< u by kappa over u_sd, minus 1; median of magnitudes
    double worst_amplitude_ratio = 0, worst_tangential_ratio = 0;  ///< where
    int n = 0;                                                     ///< points compared
    int n_ratcheting = 0;   ///< further points that with this kappa would not settle
    int n_with_bars = 0;    ///< of n: the numerical error of u_sd is known
    int n_beyond_bars = 0;  ///< of these: differ by more
};

/// Whether one kappa serves all points of a group. Numerical errors are bounds, not noise: what
/// they allow is found by intersecting intervals, not by a sum of squares.
struct OneMapping {
    report::Verdict::Standing finding = report::Verdict::Standing::not_testable;
    int n_with_bars = 0;
    int n_telling = 0;  ///< of these: half width of the kappas within the bar below 10 % of kappa
    bool is_known = false;  ///< all points have bars, half of them, three at least, are telling
    /// The kappas within the bars of all points that have one; high below low: there is none. NaN
    /// without bars.
    double low = 0, high = 0;
    bool is_negligible = false;  ///< no shift by the fitted kappa misses by 0.1 %
};

/// The settled points of one model and group.
struct MappingGroup {
    std::string model, group;
    double angle = 0;  ///< [rad]
    std::vector<MappingPoint> points;
    std::optional<FittedForm> constant;  ///< one kappa; empty below three points
    /// kappa = k_0 + k_w w + k_f f_T/f_T,lim; empty below six points, or where these do not vary.
    std::optional<FittedForm> plane;
    std::vector<MappingUse> uses;  ///< fitted, thesis' (where it has one), MDR's
    OneMapping one;
};

/// "f_T = 1 - kappa w u_sd - (1 - u_sd)^(3/2)", with this text for kappa.
std::string settled_form(const theory::RolledLaw& law, const std::string& kappa);

/// Groups in the order of the points, all under one law. Fits are linear regressions through the
/// origin of f_static(u) - f_T on w u: least squares of f_T. Points that have not settled, and
/// those with w u below least_mapping_product or u beyond 1, are left out.
std::vector<MappingGroup> mapping_fits(const std::vector<RollingPoint>& points, double confidence,
                                       const theory::RolledLaw& law = theory::coulomb_rolling);

}  // namespace tricontact::comparisons
