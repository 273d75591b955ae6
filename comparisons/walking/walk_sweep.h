#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "comparisons/document.h"
#include "comparisons/sweep_document.h"
#include "comparisons/walking/walk_outcome.h"
#include "dynamics/machine.h"

namespace tricontact::comparisons::walking {

/// What a study of walking machines varied and found.
struct WalkSweep {
    struct Point {
        std::vector<Cell> values;  ///< one per axis, SI unit
        dynamics::Machine machine = {};
        std::optional<WalkOutcome> outcome = {};  ///< empty: failed
        std::string error = {};                   ///< of a point that failed
    };
    std::string title;
    std::vector<std::pair<std::string, std::string>> settings;  ///< name, value with unit
    std::vector<Sweep::Axis> axes;
    std::vector<Point> points;  ///< in the order of the study
};

/// Machines of a study that differ in their starts alone: repetitions of one experiment.
struct WalkGroup {
    std::vector<Cell> values;  ///< of machine_axes
    std::vector<const WalkSweep::Point*> points;

    const dynamics::Machine& machine() const { return points.front()->machine; }
    const dynamics::Kappas& kappas() const { return machine().kappas; }
    std::size_t n_tilted() const;
    /// Whether at least half of the computed ones tilt.
    bool tilts() const;
    /// Mean over those that do not tilt; NaN if the group does, or none was computed.
    double mean(double (*value)(const WalkOutcome& outcome)) const;
    /// Mean of mu_e. Its error, 95 %, is from the scatter between the starts; with one start it is
    /// that of the run.
    WithError mu_e() const;
};

/// Axes that describe the machine, not its start.
std::vector<std::size_t> machine_axes(const WalkSweep& sweep);

/// In the order of the study. The sweep outlives them.
std::vector<WalkGroup> groups_of(const WalkSweep& sweep);

/// "κ_8", "μ", "v_0 [mm/s]": how figures and tables name an axis.
std::string label_of(const WalkSweep& sweep, std::size_t axis);
/// A value of it in the unit of that label.
double shown_value(const WalkSweep& sweep, std::size_t axis, const Cell& value);

}  // namespace tricontact::comparisons::walking
