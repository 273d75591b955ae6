#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "contact/case.h"
#include "contact/history.h"

namespace tricontact::comparisons {

/// The rolling as a relaxing substrate feels it: sinusoidal shear once per period.
struct DriveValues {
    double amplitude = 0;  ///< W [m]
    double frequency = 0;  ///< f = v/(4 W) [Hz]: a period is a path of 4 W
    double storage = 0;    ///< G' at f [Pa]
    double loss = 0;       ///< G'' at f [Pa]
    /// De_i = 2 pi f tau_i per branch, in the order of the case's [-]: at 1 the branch loses most.
    std::vector<double> deborah;

    double loss_tangent() const { return loss / storage; }
};
/// Empty unless the case relaxes and rolls with W = `amplitude` > 0 [m].
std::optional<DriveValues> drive_values(const contact::Case& c, double amplitude);

/// The same case on an elastic substrate of the relaxed modulus: the limit of an infinitely slow
/// drive, with the same scales a, d, U_max. Times have no meaning for it and are left out.
contact::Case elastic_twin(const contact::Case& c);

/// What of a run is compared: shifts of the indenter along x, empty without rolling but for the
/// first, and what presses it in the end.
struct RunValues {
    double static_shift = 0;  ///< after F_T and the wait, before rolling [m]
    std::optional<contact::State> state = {};
    std::optional<double> final_shift = {};  ///< upright after the last period [m]
    std::optional<double> increment = {};    ///< of the last period [m]
    std::optional<double> limit = {};        ///< f_T,lim from the pressures
    double normal_force = 0;                 ///< at the end [N]
    double indentation = 0;                  ///< at the end [m]
};
RunValues run_values(const contact::History& history);

/// Other over run, minus 1; empty where one of them is, or the run's is 0.
std::optional<double> relative_error(std::optional<double> other, std::optional<double> run);

/// What stands for a run where a single number has to: the increment if the elastic reference run
/// ratchets, else the shift after the last period.
bool judged_by_increment(const RunValues& elastic);
/// Its error, whatever the verdict of the relaxing run: elastic over relaxing, minus 1.
std::optional<double> twin_error(const RunValues& elastic, const RunValues& relaxing);

/// A run beside another by the same model with something changed. Errors are those of the other
/// run: over the first, minus 1; empty where there is nothing to be compared.
struct RunComparison {
    std::string model;               ///< as in its history
    RunValues run;                   ///< as the case has it
    std::optional<RunValues> other;  ///< empty: not computed, or not converged
    std::string why_none;            ///< then: why

    std::optional<double> static_error() const;
    /// Of the shift after the last period of each, whatever the verdicts.
    std::optional<double> final_error() const { return error_of(&RunValues::final_shift); }
    /// Of u_sd: only if both shake down.
    std::optional<double> settled_error() const;
    /// Of Du: only if both ratchet.
    std::optional<double> increment_error() const;
    /// Of f_T,lim.
    std::optional<double> limit_error() const { return error_of(&RunValues::limit); }

  private:
    std::optional<double> error_of(std::optional<double> RunValues::*value) const;
};

/// A relaxing case beside its elastic reference run.
struct TwinComparison : RunComparison {
    std::optional<DriveValues> drive = {};
};

/// The slowest drive at which the elastic reference run errs by more than `limit`.
struct SpeedLimit {
    static constexpr double limit = 0.01;
    static constexpr double resolution = 0.05;  ///< relative, of `speed`

    std::string model;
    bool of_increment = false;        ///< what it is the error of: see judged_by_increment
    std::optional<double> speed;      ///< [m/s]; empty: not found
    std::optional<double> frequency;  ///< at this speed [Hz]
    double slowest = 0, fastest = 0;  ///< tried [m/s]
    int runs = 0;
    std::string why_none;  ///< if not found: why
};

/// |Error of the elastic reference run| at a drive speed [m/s]; empty where undefined. May throw
/// what contact::why_it_stopped knows: no solution.
using ErrorAtSpeed = std::function<std::optional<double>(double speed)>;

/// Looks for the speed by runs of `error`: from De = 0.01 of the slowest branch in steps of ten,
/// down to De = 1e-4 of it or up to De = 100 of the fastest, then between the two steps. It depends
/// on speed times relaxation time over `amplitude` [m] alone, if `hold` and periods are long
/// enough.
SpeedLimit find_speed_limit(const contact::Relaxation& relaxation, double amplitude,
                            const ErrorAtSpeed& error);

/// What a run finds about the relaxing substrate of its case.
struct RelaxationStudy {
    std::vector<TwinComparison> twins;  ///< in the order of the models
    std::optional<SpeedLimit> limit;    ///< empty: not looked for
};

}  // namespace tricontact::comparisons
