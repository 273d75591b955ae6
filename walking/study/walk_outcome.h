#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "walking/machine/walk_case.h"
#include "walking/run/walk.h"

namespace tricontact::walking {

/// Motion of a machine over some of its periods, sampled evenly. Lengths in units of b, times of
/// sqrt(m/k_x), forces of k_x b. All lists are of one length.
struct MotionSamples {
    double interval = 0;              ///< between two samples
    std::vector<float> displacement;  ///< x - x_s
    std::vector<float> z;             ///< downwards
    std::vector<float> phi;           ///< counter-clockwise, (a/b) Phi
    std::vector<float> spring_force;  ///< f_s
};

/// What one machine of a study came to. NaN where undefined.
struct WalkOutcome {
    /// Plain means over the second half of the run, whatever happens in it: the reading that
    /// reproduces the numbers of Wetter (2016), section 4.2. Undefined for a machine that tilts.
    struct SecondHalf {
        double mu_e = 0, z_min_ratio = 0, z_max_ratio = 0;
    };

    /// Of the spring force at the end of the run: figures 4.22, 4.25 and 5.27 of Wetter (2016). A
    /// steady run has no frequency and is not unstable, though its spring may swing on undamped.
    struct Vibration {
        double frequency = 0;        ///< characteristic, in cycles per sqrt(m/k_x)
        double frequency_error = 0;  ///< half width of its 95 % interval
        double instability = 0;      ///< share of time of instability, by running variance
    };

    WalkResult result;
    SecondHalf second_half = {};
    Vibration vibration = {};
    double largest_phi = 0;     ///< max |phi| of the whole run
    double initial_energy = 0;  ///< mechanical, over kappa4 z_stat: see initial_energy()
    MotionSamples samples = {};
};

/// Mechanical energy at the start over kappa4 z_stat, from springs without tension and z = 0.
/// Wetter (2016), eq. 4.2.21, with the rotation that its spring of the base lacks, and all of the
/// weight's potential: kappa4 z stands outside the half, as Newton's law (4.1.18) asks.
double initial_energy(const Machine& machine, const Start& start);

/// Outcome of a run whose end was recorded densely.
WalkOutcome outcome_of(const WalkCase& walk_case, const Walk& walk);

/// Names of an outcome's numbers and words in the order of the table; they never change.
const std::vector<std::string>& walk_result_names();

/// Values by name, null where undefined, and the samples, to five digits. No times of computing:
/// the same case gives the same values. Spots 1 and 2 are the first and the last.
nlohmann::ordered_json walk_results(const WalkOutcome& outcome);

/// The other way round. Throws nlohmann::json::exception for anything else.
WalkOutcome read_walk_results(const nlohmann::ordered_json& results);

}  // namespace tricontact::walking
