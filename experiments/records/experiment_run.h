#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/history.h"
#include "experiments/records/drive_timeline.h"
#include "experiments/records/experiment.h"
#include "experiments/records/record_checks.h"
#include "experiments/records/record_noise.h"
#include "experiments/records/settling_fit.h"

namespace tricontact::experiments {

/// Level of the intervals that verdicts are based on.
inline constexpr double verdict_confidence = 0.95;
/// Ratcheting that adds less than this part of the shift over the whole interval is shakedown.
inline constexpr double negligible_ratcheting = 0.05;

/// Samples of a rest, fewer of which tell no drift.
inline constexpr std::size_t fewest_rest_samples = 30;
/// Part of a period until the drive surely stands after it.
inline constexpr double stopping = 1. / 50;

/// What the shift did while the amplitude was the same. Shifts are counted from the unsheared state
/// if the record holds it, and are rid of the drift.
struct StageEvaluation {
    double amplitude = 0;  ///< W [m]; 0: unknown
    double period = 0;     ///< [s]
    /// With the roller upright: before the first period and after each.
    std::vector<double> time;         ///< [s]
    std::vector<double> shift;        ///< [m]
    std::vector<double> shift_error;  ///< standard error by noise, drift and zero [m]
    std::vector<double> noise_error;  ///< of these by noise alone [m]
    std::vector<double> drift_time;   ///< times the drift's error is its part of them [s]
    SettlingFit settling;             ///< at verdict_confidence; drift's error included
    Estimate curvature;               ///< of period values, at verdict_confidence [-]
    double sampled_curvature = 0;     ///< of all samples, as the thesis takes it [-]
    Estimate increment;               ///< Du: slope of the second half, `confidence` [m]
    Estimate increment_95;            ///< the same at verdict_confidence
    /// Undecided: cannot tell. By the curvature's interval on one side of 0 (5.1.7, 5.1.8).
    contact::State by_increment{}, by_curvature{};

    int periods() const { return static_cast<int>(shift.size()) - 1; }
};

/// What may be wrong in the values of a run beside its noise, and the same way in all runs of a
/// rig: standard errors at the ends of periods of the first stage [m].
struct SystematicError {
    std::string name;
    std::vector<double> of_shift;
};

/// One record evaluated.
struct RunEvaluation {
    std::string name;
    RecordFindings findings;                  ///< what is wrong with the record
    std::vector<SystematicError> systematic;  ///< of it; counted in the stages' errors, too
    std::vector<StageEvaluation> stages;
    RecordNoise noise;                ///< of the rest before rolling
    double loading = 0;               ///< when F_T was applied, or the record begins [s]
    double rest = 0;                  ///< under F_T before rolling, as far as recorded [s]
    bool rest_is_whole = false;       ///< the record says when F_T was applied
    Estimate before;                  ///< slope of the rest before rolling [m/s]
    std::optional<Estimate> after;    ///< of the rest after it
    Estimate drift;                   ///< what was subtracted: mean of both
    bool drift_changes = false;       ///< both differ by more than three standard errors
    std::optional<Estimate> wobble;   ///< dU/dW of the second half of the periods [-], one stage
    std::vector<double> time, shift;  ///< the record, corrected as above [s], [m]
    int degrees_of_freedom = 0;       ///< of the noise: independent samples of the rest, less two

    /// A finding spoils its values: there are no verdicts.
    bool is_spoilt() const;
    /// Nor is the amplitude of its drive unknown: models are set beside it.
    bool is_comparable() const;
    /// Share of the rest after the rolling in the drift.
    double share_of_rest_after() const;
};

/// Evaluates one record. Throws contact::InputError about it: see drive_timeline(), rest of fewer
/// than 30 samples before rolling, fewer than 5 periods of an amplitude, an amplitude that changes
/// although the kind says one.
RunEvaluation evaluate_run(const Record& record, const Experiment& experiment);

/// Verdict by the increment: shakedown if the upper end of its interval adds less than
/// negligible_ratcheting of the last shift over the interval; else ratcheting if the lower end is
/// positive.
contact::State judge_increment(const Estimate& increment, int periods, double last_shift);
/// The same of shifts at the ends of periods that somebody else computed [m].
contact::State state_by_increment(const std::vector<double>& shift);

/// Slope of the straight line through the second half of the shifts at the ends of periods.
Estimate late_increment(const std::vector<double>& shift, double confidence);

}  // namespace tricontact::experiments
