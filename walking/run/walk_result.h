#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "statistics/initial_sequence.h"

namespace tricontact::walking {

/// What a run came to.
enum class Regime {
    steady,       ///< slides, or rests, and does not vibrate vertically but for what is left of the
                  ///< start
    limit_cycle,  ///< repeats itself
    chaotic,      ///< does not, within the time observed
    tilting,      ///< falls over: small rotations no longer
    sticking,     ///< has not begun to slide: the base still loads the spring
    // Of a machine under an excitation whose base stands still:
    shakedown,   ///< comes to rest: no shift per period
    ratcheting,  ///< shifts in every period, its spots on the ground
    walking      ///< spots leave the ground
};

inline constexpr std::array all_regimes = {
    Regime::steady,   Regime::limit_cycle, Regime::chaotic,    Regime::tilting,
    Regime::sticking, Regime::shakedown,   Regime::ratcheting, Regime::walking};

/// "steady", "limit-cycle", "chaotic", "tilting", "sticking", "shakedown", "ratcheting", "walking"
std::string_view word_of(Regime regime);

/// Statistics of a run after its transient: over whole periods of a limit cycle, else over what is
/// left of the run. NaN where undefined.
struct WalkResult {
    struct Spot {
        double stick_time = 0;   ///< share of time: Wetter (2016), eq. 4.2.14
        double correlation = 0;  ///< of velocity and normal deflection: Wetter (2016), A.1.4
    };

    /// Of a machine under an excitation whose base stands still.
    struct Drift {
        double per_period = 0;  ///< shift x + phi of the base over U_max = mu kappa2 z_stat
        double error = 0;       ///< of it: it cannot be farther off
        double airborne = 0;    ///< share of time in which a spot, or more, is in the air
    };

    Regime regime = Regime::steady;
    double mu_e = 0;        ///< <f_s>/(mu kappa4), in the prism over sqrt(2): eqs. 4.1.24, 5.2.26
    double mu_e_error = 0;  ///< half width of its 95 % interval
    std::optional<double> period = {};        ///< of the limit cycle, in units of sqrt(m/k_x)
    double period_error = 0;                  ///< half width of its 95 % interval
    int section_points = 0;                   ///< of the Poincare section in a period
    double z_min_ratio = 0, z_max_ratio = 0;  ///< extremes over the static displacement
    double phi_min = 0, phi_max = 0;
    double kinetic_energy = 0;  ///< mean over kappa4 z_stat: Wetter (2016), eq. 4.2.20
    std::vector<Spot> spots = {};
    double transient = 0;                     ///< time until the statistics begin
    bool transient_over = false;              ///< false: the run is too short to tell, and says so
    double observed = 0;                      ///< time over which they were taken
    std::optional<double> tilting_time = {};  ///< when it tilted, if it did
    std::optional<Drift> drift = {};
    /// Largest Lyapunov exponent of the motion it ended in, with its 95 % interval; of a run alone.
    std::optional<statistics::Mean> lyapunov = {};
};

}  // namespace tricontact::walking
