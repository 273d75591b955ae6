#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "statistics/initial_sequence.h"
#include "walking/kernels/batch.h"
#include "walking/machine/machine.h"
#include "walking/machine/motion.h"
#include "walking/machine/stretch_recorder.h"
#include "walking/machine/walk_case.h"

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

/// Phases of a period of a limit cycle: Wetter (2016), figures 4.18 and 4.19. Times are those of
/// the snapshots in which a phase begins; NaN where it does not occur.
struct WalkPhases {
    double period = 0;         ///< that of the cycle
    double sticking = 0;       ///< (1) the first spot begins to stick
    double turning_point = 0;  ///< (2) deepest, most elastic energy stored
    double release = 0;        ///< (3) the last spot ceases to stick
    double jump = 0;           ///< (4) all spots have left the ground
    double landing = 0;        ///< the first one is back
    double jump_height =
        0;                ///< of the undeformed base over the ground, over the static displacement
    double airborne = 0;  ///< share of time in which no spot touches the ground
    double airborne_advance = 0;  ///< share of the way made in it
};

/// Phases of the period about the last turning point with a period before and after it. None if
/// the snapshots, consecutive ones at equal intervals, are shorter than three periods.
std::optional<WalkPhases> phases_of(const Machine& machine, std::span<const Snapshot> snapshots,
                                    double period);

/// A period of the excitation.
struct ExcitedPeriod {
    double shift = 0;     ///< x + phi at its end, of the body at its base, in units of b
    double airborne = 0;  ///< share of its time in which a spot, or more, is in the air
};

/// A stretch of the run and what happened in it.
struct WalkWindow {
    double begin = 0, end = 0;  ///< times
    StretchSums sums;
};

/// A return to the Poincare section, and what happens from there until the next one. The section is
/// where the body gets as fast as the spring's base: x' rises through kappa6. It is met once a
/// swing of the spring, whether the body jumps, slides or cannot move vertically.
struct SectionReturn {
    Motion motion;  ///< interpolated between two steps: an error of the order of the step squared
    StretchSums sums;  ///< up to the next return
};

/// One machine's run.
struct Walk {
    WalkResult result;
    std::vector<WalkWindow> windows;     ///< of equal length, the whole run
    std::vector<SectionReturn> returns;  ///< of the end of the run, in the order of time
    std::vector<ExcitedPeriod> periods;  ///< of an excitation while the base stands still
    std::vector<Snapshot> start, tail;   ///< first and last stretch, densely
    Motion last;                         ///< at the end, spring by spring; of a run alone
    std::optional<WalkPhases> phases;    ///< of the limit cycle, if it is one
    std::int64_t lane_steps = 0;         ///< steps of one machine
    double cpu_s = 0;                    ///< processor time of the run [s]
};

/// What to record densely; times in units of sqrt(m/k_x).
struct Recording {
    double start = 0;        ///< length of the first stretch
    double tail = 20;        ///< of the last one, at least; three periods of a limit cycle
    double interval = 0.01;  ///< between snapshots; at least a step
};

/// Hears how many thousandths of a run's steps are done.
using WalkWatch = std::function<void(int done, int total)>;

/// Runs a case by velocity Verlet and judges it. A machine that tilts is stopped there.
/// Throws std::invalid_argument if step or end are not positive.
Walk walk(const WalkCase& walk_case, const Recording& recording = {}, const WalkWatch& watch = {});

/// Runs cases of one step and one end side by side in a batch, each as walk() does: it does not
/// depend on the others. Returns are recorded only where the extremes of the motion repeat, so that
/// there may be a limit cycle; the time of computing is an equal share of the whole. Throws
/// std::invalid_argument for what a batch does not know, and for cases that differ in step or end.
std::vector<Walk> walk_batch(std::span<const WalkCase> cases, const Recording& recording = {},
                             Kernel kernel = best_kernel());

/// Adds to the errors of a limit cycle's mu_e and period what the integration's step contributes:
/// the cycle is followed once more with half the step. Velocity Verlet makes errors of second
/// order in these means, so that four thirds of the difference remain (Richardson).
/// `motion`: of the machine's springs, on the cycle; `result` is of a limit cycle.
void add_step_error(const Machine& machine, const Motion& motion, double step, WalkResult& result);

}  // namespace tricontact::walking
