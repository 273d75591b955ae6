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

/// Of the intervals of a study of machines.
inline constexpr double confidence = 0.95;

/// With its error from the scatter; that of one value is undefined, and so is the mean of none.
report::WithError mean_of(const std::vector<double>& values);

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
    std::vector<report::Cell> values;  ///< of the axes in which they agree
    std::vector<const WalkSweep::Point*> points;

    const Machine& machine() const { return points.front()->machine; }
    std::size_t n_tilted() const;
    /// Whether at least half of the computed ones tilt.
    bool tilts() const;
    /// Of those that do not tilt; none if the group does.
    std::vector<double> values_of(double (*value)(const WalkOutcome& outcome)) const;
    /// Their mean; NaN for none.
    double mean(double (*value)(const WalkOutcome& outcome)) const;
    /// Mean of mu_e. Its error, 95 %, is from the scatter between the starts; with one start it is
    /// that of the run.
    report::WithError mu_e() const;
};

/// Axes that describe the machine, not its start.
std::vector<std::size_t> machine_axes(const WalkSweep& sweep);

/// Computed points that agree in these axes, in the order of the study. The sweep outlives them.
std::vector<WalkGroup> groups_over(const WalkSweep& sweep, const std::vector<std::size_t>& axes);
/// The same over machine_axes.
std::vector<WalkGroup> groups_of(const WalkSweep& sweep);

/// "κ_8", "μ", "v_0 [mm/s]": how figures and tables name an axis.
std::string label_of(const WalkSweep& sweep, std::size_t axis);
/// A value of it in the unit of that label; a word is undefined, as a cell the word itself.
double shown_value(const WalkSweep& sweep, std::size_t axis, const report::Cell& value);
report::Cell shown_cell(const WalkSweep& sweep, std::size_t axis, const report::Cell& value);

/// Groups of machines over two axes of numbers, at least eight values each: a map.
struct WalkGrid {
    std::size_t x_axis = 0, y_axis = 0;   ///< of the sweep: the first and the second one
    std::vector<double> x, y;             ///< increasing, in the units of label_of
    std::vector<const WalkGroup*> cells;  ///< x fastest; null: no result

    /// A quantity of all cells; NaN where a cell has no result or tilts.
    std::vector<double> values(double (*value)(const WalkOutcome& outcome)) const;
};

/// The groups as a map, if that is what the study varies. Groups outlive the grid.
std::optional<WalkGrid> grid_of(const WalkSweep& sweep, const std::vector<WalkGroup>& groups);

/// Part of a map.
struct Region {
    std::string name, definition;
    double share = 0;  ///< of the cells with results
    /// Half width, 95 %, of what a finer grid may find: every crossing of the region's boundary
    /// between two cells lies anywhere between them.
    double grid_error = 0;
};

/// Critical, without effect, with reduction, with constant z, with jumps: as Wetter (2016), section
/// 4.2.2, divides figures 4.9 and 4.10. `second_half`: by plain means over the second half of the
/// run, else by what each run was judged to be.
std::vector<Region> regions_of(const WalkGrid& grid, bool second_half);

/// How many cells tilt where friction exceeds mu_c, and do not where it does not.
struct TiltingAgreement {
    int n_cells = 0, n_agreeing = 0;
    double share() const { return n_cells > 0 ? static_cast<double>(n_agreeing) / n_cells : 0; }
};
TiltingAgreement tilting_agreement(const WalkGrid& grid);

}  // namespace tricontact::walking
