#pragma once

#include <optional>
#include <string>
#include <vector>

#include "walking/study/walk_sweep.h"

namespace tricontact::walking {

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
