#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "contact/case.h"
#include "experiments/records/experiment.h"
#include "experiments/records/experiment_run.h"
#include "experiments/records/recorded_path.h"
#include "experiments/records/series_deviation.h"
#include "experiments/validation/comparison_error.h"
#include "statistics/correlations.h"
#include "statistics/distribution.h"
#include "statistics/error_propagation.h"

namespace tricontact::experiments {

/// A quantity over all runs: mean and interval by their scatter from two runs on, else the only
/// run's own.
struct Repeated {
    Estimate at_confidence, at_95;
    int runs = 0;  ///< that have it
    /// Of its standard error what all runs have in common, which their scatter does not show: of
    /// records that are not in order.
    double systematic = 0;
};

/// Two straight lines of least squares and where they meet.
struct LineIntersection {
    double time = 0;            ///< [s]
    Estimate shift;             ///< U_lim [m]
    double slopes[2] = {0, 0};  ///< before and after [m/s]
};

/// The shakedown limit of a run whose amplitude rises in steps.
struct LimitReading {
    std::size_t shakedown = 0, ratcheting = 0;     ///< stages: last and first of the kind
    double amplitude_low = 0, amplitude_high = 0;  ///< theirs: W_lim lies between [m]
    LineIntersection lines;
};

/// A number of the case with its standard error.
struct CaseQuantity {
    std::string name;                                ///< "friction.coefficient"
    double standard_error = 0;                       ///< SI unit
    std::function<double&(contact::Case&)> of_case;  ///< the number, see as_the_rig_sets
    /// Largest value that it can have: nu = 1/2. Errors of a number at its end go downwards.
    double largest = std::numeric_limits<double>::infinity();
    statistics::Distribution distribution = statistics::Distribution::normal;
};

/// Measured quantities over Hertz' scales of the case, as the thesis normalises (3.1.4).
struct NormalisedResults {
    Estimate tangential_ratio;  ///< f_T = F_T/F_lim; of Coulomb's law F_lim = mu F_N
    Estimate amplitude_ratio;   ///< w = W/a; of a limit run w_lim
    Estimate unit_shift;        ///< U_max [m]
    /// Over U_max; the final one of a limit run is u_lim.
    Estimate static_ratio, final_ratio, increment_ratio;
    /// w_lim of the half-space by f_T and the law of friction, of Coulomb's 1 - 3/2 w + 1/2 w^3 =
    /// f_T, and the thesis' 1 - f_T, which is about Coulomb's alone.
    Estimate exact_limit, thesis_limit;
    Estimate exact_limit_amplitude;  ///< the former as W_lim [m]
    bool is_coulomb = true;
    double radius = 0;  ///< R [m]
};

/// What a model says about the same runs.
struct ModelPrediction {
    std::string model;
    std::vector<double> shift;  ///< u_0 ... u_N [m]
    contact::State state{};
    double wobble = 0;  ///< dU/dW of the last period [-]
    /// `shift` when a quantity of the case grows by its standard error, one each, what else a rig
    /// sets (see as_the_rig_sets) being the same. None: no errors are stated.
    std::vector<std::vector<double>> raised;
    /// `shift` on cells, elements or springs of twice the size; empty: not computed.
    std::vector<double> coarser = {};
    /// Standard errors of `shift` by its finite steps, with their sign [m]; empty: not computed.
    std::vector<double> steps_error = {};
    /// `shift` where the uncertain numbers are as far off as 95 % reach, in the direction in which
    /// the shift changes most, down and up; empty: not computed.
    std::vector<std::vector<double>> ends = {};
    /// One of these settles and another ratchets: the limit lies within the uncertainty.
    std::optional<double> chance_of_ratcheting = {};
    /// F_T reaches what friction carries at one of the ends: nothing bounds the shift.
    bool slides_within = false;
};

/// Standard error that a quantity has beyond the linear one of `variance` where the response is not
/// linear: `value`, and at the ends of 95 %. 0 up to a quarter more than the linear one.
double nonlinear_error(double value, const std::vector<double>& at_ends, double variance);

/// Half widths of the intervals of 95 % of its shifts, by the uncertain numbers of the case, the
/// mesh and the steps, one per period [m]; empty if nothing is uncertain. `correlation`: of these
/// numbers.
std::vector<double> half_widths(const ModelPrediction& prediction,
                                const statistics::Correlations::Matrix& correlation = {});

/// A quantity measured and by a model [m].
struct Deviation {
    std::string model, quantity;
    Estimate measured, predicted;  ///< predicted: by the uncertain numbers of the case
    bool has_errors = false;       ///< the case states uncertainties
    ComparisonError error = {};    ///< by these, the record and the model's mesh
    bool rest_is_missing = false;  ///< of a relaxing substrate: how long F_T acted is not known
    bool is_spoilt = false;        ///< by a record that is damaged
    bool slides = false;           ///< see ModelPrediction::slides_within
    /// Drift subtracted from the measured value that on a relaxing substrate may be creep, which
    /// the model's has [m].
    double creep = 0;

    double ratio() const { return measured.value / predicted.value; }
    /// The comparison disagrees, also with the creep back in the measured value. Empty where that
    /// cannot be told.
    std::optional<bool> differs() const;
};

/// What the record says of the rest under F_T before rolling.
struct Rest {
    double time = 0;        ///< mean of the runs, as far as recorded [s]
    bool is_whole = false;  ///< record.loading says when F_T was applied
};

/// Forces that the models follow as they were recorded, beside those that the case states.
struct RecordedLoads {
    RecordedPath as_recorded;
    double stated_normal = 0, stated_tangential = 0;  ///< F_N, F_T [N]
};

/// What the models take from the record besides amplitude and periods.
struct RolledAs {
    std::optional<double> hold;  ///< under F_T before rolling [s]; empty: an elastic substrate
    bool hold_is_known = false;
    std::optional<double> speed;             ///< of the drive [m/s]; empty: an elastic substrate
    std::optional<RecordedLoads> loads;      ///< empty: constant, as the case states
    std::optional<double> stated_amplitude;  ///< by the case, where the drive had another [m]
};

/// Verdicts of a model over the amplitudes of a limit run.
struct PredictedLimit {
    std::string model;
    std::vector<contact::State> states;  ///< one per stage of the first run
};

struct ExperimentEvaluation {
    Experiment::Kind kind{};
    std::string title;
    double confidence = 0;
    std::vector<RunEvaluation> runs;
    contact::State state{};  ///< by the increment, of all runs that decide; undecided if none or
                             ///< if they contradict each other
    int periods = 0;         ///< of the shortest run, of the first stage
    double amplitude = 0;    ///< mean of the first stages [m]; 0: unknown
    Rest rest;
    RolledAs rolled_as;
    std::vector<std::string> uncertain_numbers;    ///< of the case: whose standard error is stated
    statistics::Correlations::Matrix correlation;  ///< of these; empty: independent
    Repeated static_shift;                         ///< u_stat [m]
    Repeated final_shift;         ///< u_sd: upright after the last common period [m]
    Repeated settled_shift;       ///< extrapolated [m]
    Repeated increment;           ///< Du, second half of the periods [m]
    std::vector<Estimate> shift;  ///< per period, at `confidence` [m]
    /// Of each period, u_n - u_(n-1), at `confidence` [m]; of one run by noise.
    std::vector<Estimate> period_increments;

    /// dU/dW: the shift that follows the drive [-]; empty where the amplitude is unknown or
    /// changes.
    std::optional<Repeated> wobble;

    /// Limit runs, by the increment: per run, empty where it cannot be read.
    std::vector<std::optional<LimitReading>> limits;
    std::vector<std::optional<LimitReading>> limits_by_curvature;  ///< by the thesis' criterion
    std::optional<Repeated> limit_amplitude;  ///< middle between the two stages [m]
    std::optional<Repeated> last_shakedown;   ///< amplitude of the thesis' rule [m]
    std::optional<Repeated> limit_shift;      ///< U_lim by the lines [m]

    std::optional<NormalisedResults> normalised;  ///< with a case
    std::vector<ModelPrediction> predictions;
    std::vector<Deviation> deviations;
    std::vector<SeriesDeviation> series;  ///< one per prediction
    std::vector<PredictedLimit> model_limits;

    /// A record is damaged such that its values, or the drive's, are wrong by an unknown amount.
    bool is_spoilt() const;
    /// Of a relaxing substrate: how long F_T acted before rolling is not known.
    bool rest_is_missing() const { return rolled_as.hold && !rolled_as.hold_is_known; }
    /// Drift subtracted in one period that on a relaxing substrate may be creep, mean of the
    /// runs [m]; models that follow the record are rid of their own.
    double creep_per_period() const;
};

/// What all runs may have wrong in common, one entry per kind: root mean squares over the runs, at
/// the ends of the periods that all have. Of a single run none: they are in its own errors.
std::vector<SystematicError> common_errors(const ExperimentEvaluation& evaluation);

/// Of an uncertain number of the case; empty if it is not known.
std::string name_of_number(const ExperimentEvaluation& evaluation, std::size_t number);

/// Half of Roache's grid convergence index (1998), which stands for two standard errors, of values
/// whose mesh is finer by a factor of two, by the first order that no model stays below; with the
/// sign of fine minus coarse.
double numerical_error(double fine, double coarse);

/// Evaluates all records and puts the runs together. Throws contact::InputError, also if the
/// amplitudes of runs differ by more than 2 %.
ExperimentEvaluation evaluate_experiment(const Experiment& experiment);

/// The stage of the first ratcheting and the last shakedown before it, by one of the verdicts of
/// stages; stages in between that cannot be told widen the interval. Empty if either is missing.
std::optional<LimitReading> read_limit(const RunEvaluation& run,
                                       contact::State StageEvaluation::*verdict, double confidence);

/// Intersection of the straight lines through the values at the ends of periods of two stages
/// (thesis 5.1.9, 5.1.10), errors of both lines propagated; Student's t of the line with the fewer
/// values. NaN error and interval where the lines are nearly parallel.
LineIntersection intersect(const StageEvaluation& before, const StageEvaluation& after,
                           double confidence);

/// The case with F_T [N] and W [m] in place of their ratios, of what friction carries [N] and of W:
/// what a rig sets is a force and a length, which an error of mu or F_N does not move.
contact::Case as_the_rig_sets(contact::Case c, double friction_limit, double amplitude);

/// Adds f_T, w and the shifts over U_max, errors of the case's numbers propagated (A.1.4), F_T and
/// W as the rig sets them: `of_case` is asked of such a case. Where nothing that a number depends
/// on has an error, its standard error is 0: not stated.
void normalise(ExperimentEvaluation& evaluation, const contact::Case& c,
               const std::vector<CaseQuantity>& quantities);

/// Shift that follows the drive along `angle` [rad] in the steps of a model's run from the phase
/// `begin` on, beside a straight line in time: dU/dW [-]. On a layer that couples normal and
/// tangential contact free rolling creeps: this is not zero, even without a tangential force.
double model_wobble(const std::vector<contact::StepRecord>& steps, double begin, double angle);

/// What is left of the measured wobble beside a model's own, as a pivot that is Dh = R dU/dW too
/// high (5.1.11) [m]. Needs `wobble` and `normalised`.
Estimate pivot_height(const ExperimentEvaluation& e, double own_wobble);

/// Adds a model's prediction and its deviations: u_stat, u_sd (shakedown) or Du (ratcheting), and
/// those of all periods together.
void add_prediction(ExperimentEvaluation& evaluation, ModelPrediction prediction);

/// The scatter of one measured quantity over the runs.
Repeated repeated(const std::vector<Estimate>& of_runs, double confidence);

}  // namespace tricontact::experiments
