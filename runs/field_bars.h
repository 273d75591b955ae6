#pragma once

#include <optional>
#include <vector>

#include "comparisons/resolution/numerical_error.h"
#include "contact/history.h"

namespace tricontact::runs {

/// The last states of a run and of those beside it; empty where there is none.
struct LastSurfaces {
    std::optional<contact::Snapshot> run, coarser, coarsest, long_steps, short_steps, wide_block;
};

/// The last snapshot of a history.
std::optional<contact::Snapshot> last_snapshot(const contact::History& history);

/// Half widths of pressure, tangential traction and displacement, from what neighbouring meshes
/// and steps differ by on the finer of their grids. Norms over the surface count the first order.
/// The largest difference of tractions counts the order 1/2, that of the pressure's root at the
/// contact's edge, and so 1.25/(sqrt(2) - 1) times what two meshes differ by. Empty without a
/// coarser mesh, where the phases of the last states differ, and for fields that all lack.
std::vector<comparisons::FieldBar> field_bars(const LastSurfaces& last);

}  // namespace tricontact::runs
