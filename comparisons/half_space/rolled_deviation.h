#pragma once

#include <optional>
#include <vector>

#include "comparisons/half_space/exact_deviation.h"
#include "comparisons/quantities/results.h"
#include "contact/case.h"

namespace tricontact::comparisons {

/// What boundary elements know of a rolled contact on a layer and on a half-space alike: U_stat and
/// U_sd, DU per period of ratcheting, in metres and each over its own U_max, kappa, eta with w_lim
/// each of its own pressure, and f_T,lim from the computed pressures.
inline constexpr std::array rolled_quantities{&quantities::static_shift,
                                              &quantities::static_shift_ratio,
                                              &quantities::settled_shift,
                                              &quantities::settled_shift_ratio,
                                              &quantities::kappa,
                                              &quantities::shift_increment,
                                              &quantities::shift_increment_ratio,
                                              &quantities::eta,
                                              &quantities::limit_tangential_ratio};
/// Those that runs which ratchet tell.
bool is_of_ratcheting(const Quantity* q);

/// A body that is rolled on: a bonded layer, or the half-space of its material.
struct RolledBody {
    double thickness_ratio = contact::infinity;  ///< b/D_c
    double poisson = 0;
    bool coupled = true;  ///< normal and tangential contact

    bool half_space() const { return thickness_ratio == contact::infinity; }
    friend bool operator==(const RolledBody&, const RolledBody&) = default;
};

/// What is computed on each body, at f_T of the case: one amplitude that settles on the half-space
/// and one that ratchets there, one of them that of the case.
struct RolledAmplitudes {
    double settling = 0, ratcheting = 0;  ///< w = W/a, a of each body; 0: nothing rolls
};
/// Beside the case's w: 0.7 of the half-space's w_lim, or 0.3 of the way from it to 1.
RolledAmplitudes rolled_amplitudes(double w, double f);

/// One run on one body.
struct RolledRun {
    enum class Kind { settling, ratcheting, ratcheting_by_half_steps };

    RolledBody body;
    Kind kind = Kind::settling;
    int level = 0;  ///< of refinement
};
/// Levels of refinement, cells smaller by sqrt(2) each; their spread is the error.
inline constexpr int n_rolled_levels = 3;

/// The runs on a body: each kind on all levels, half steps on the coarsest alone. Without rolling
/// `settling` alone, which ends with the static shift.
std::vector<RolledRun> runs_on(const RolledBody& body, const RolledAmplitudes& amplitudes);

/// The case of a run, at level 0: the base with another body, w, steps and 8 cells in Hertz'
/// contact radius. `model` is that of the body, "bem" or "bem-layer".
contact::Case rolled_case(const contact::Case& base, const DeviationContact& contact,
                          const RolledAmplitudes& amplitudes, const RolledRun& run);

/// A run and what it gave; empty if it failed.
struct RolledResult {
    RolledRun run;
    std::optional<Results> values;
};

/// Ratio of body and half-space of the same poisson and coupling.
struct RolledRatio {
    double value = 1;
    double error = 0;  ///< half width: spread of the levels, of ratcheting also the step's error
};

struct RolledDeviation {
    RolledBody body;
    /// Undefined where it is on one of them: what ratchets has no settled shift.
    ByQuantity<RolledRatio> ratios;
    /// Of the settling run on the finest level; empty without rolling.
    std::optional<contact::State> state = {};
    std::optional<contact::State> half_space_state = {};  ///< the same of the half-space
};

/// The bodies' ratios, in the order of their runs; half-spaces are what they are compared with.
std::vector<RolledDeviation> rolled_deviations(const std::vector<RolledResult>& results);

}  // namespace tricontact::comparisons
