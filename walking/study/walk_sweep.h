#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "comparisons/run/sweep_document.h"
#include "report/document.h"
#include "walking/machine/machine.h"
#include "walking/study/walk_outcome.h"

namespace tricontact::walking {

/// What a study of walking machines varied and found.
struct WalkSweep {
    struct Point {
        std::vector<report::Cell> values;  ///< one per axis, SI unit
        Machine machine = {};
        std::optional<WalkOutcome> outcome = {};  ///< empty: failed
        std::string error = {};                   ///< of a point that failed
    };
    std::string title;
    std::vector<std::pair<std::string, std::string>> settings;  ///< name, value with unit
    std::vector<comparisons::Sweep::Axis> axes;
    std::vector<Point> points;  ///< in the order of the study
};

/// Machines of a study that differ in their starts alone: repetitions of one experiment.
struct WalkGroup {
    std::vector<report::Cell> values;  ///< of machine_axes
    std::vector<const WalkSweep::Point*> points;

    const Machine& machine() const { return points.front()->machine; }
    const Kappas& kappas() const { return machine().kappas; }
    std::size_t n_tilted() const;
    /// Whether at least half of the computed ones tilt.
    bool tilts() const;
    /// Mean over those that do not tilt; NaN if the group does, or none was computed.
    double mean(double (*value)(const WalkOutcome& outcome)) const;
    /// Mean of mu_e. Its error, 95 %, is from the scatter between the starts; with one start it is
    /// that of the run.
    report::WithError mu_e() const;
};

/// Axes that describe the machine, not its start.
std::vector<std::size_t> machine_axes(const WalkSweep& sweep);

/// In the order of the study. The sweep outlives them.
std::vector<WalkGroup> groups_of(const WalkSweep& sweep);

/// "κ_8", "μ", "v_0 [mm/s]": how figures and tables name an axis.
std::string label_of(const WalkSweep& sweep, std::size_t axis);
/// A value of it in the unit of that label.
double shown_value(const WalkSweep& sweep, std::size_t axis, const report::Cell& value);

}  // namespace tricontact::walking
