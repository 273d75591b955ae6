#pragma once

#include <vector>

#include "contact/case.h"
#include "contact/history.h"
#include "experiments/records/drive_timeline.h"
#include "experiments/records/experiment.h"

namespace tricontact::experiments {

/// Loads and rolling of an experiment as its records hold them, for models that are to get the
/// same: pressed, loaded, at rest under load, rolled.
struct RecordedPath {
    struct Range {
        double low = 0, mean = 0, high = 0;  ///< [N]; the mean while it rolls
        bool is_recorded = false;            ///< else what the case states
    };

    contact::PrescribedPath path;  ///< offsets along x, whatever the rolling's angle
    /// Rows with the roller upright, before the first period of each stage and after each.
    std::vector<std::vector<int>> upright;
    Range normal_force, tangential_force;
    /// Rows of the settled rest before the rolling; of that after it, if all records show one.
    std::vector<int> rest, rest_after;
    double unloaded_time = 0;  ///< at which the record's zero is read [s]
    bool reads_zero = false;   ///< the record says when F_T was applied

    /// `c`, which presses and loads by forces, with this path along its rolling's angle in place of
    /// rolling and rest. Forces are in the ratio of the case's own to the recorded means, offsets
    /// in that of its amplitude to the first stage's: a case with the means and that amplitude gets
    /// what was recorded, another one what a sensor of another sensitivity would have recorded.
    /// Throws contact::InputError where F_T reaches mu F_N.
    contact::Case followed_by(const contact::Case& c) const;

    /// Shifts of a stage with the roller upright [m], read as the record is: rid of the slope of
    /// the rest - that before the rolling, and by the share `after` that behind it - which under
    /// forces that change, or on a substrate that creeps, is no drift of the instrument, and
    /// counted from the unloaded state.
    std::vector<double> shifts(const contact::History& history, double after,
                               std::size_t stage = 0) const;
};

/// Whether the records hold forces.
bool records_forces(const Experiment& experiment);

/// Rows: before F_T acts; when it does; four parts of the rest; `steps_per_quarter` in each quarter
/// of a period, where forces are values of straight lines of least squares through the samples of
/// half a step to both sides, but at least two. Shakedown and ratcheting: means of the runs at
/// equal places over the periods that all have; limit runs: the first. `c` says the force that has
/// no column, the amplitude where no column says the drive, and a hold that is longer than the
/// recorded rest. Throws contact::InputError about records: see drive_timeline(); forces that are
/// not positive, or act on a case that prescribes an indentation.
RecordedPath recorded_path(const Experiment& experiment, const contact::Case& c,
                           int steps_per_quarter);

}  // namespace tricontact::experiments
