#include "comparisons/quantities/map_border.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tricontact::comparisons {

namespace {

using contact::HeightMap;
using contact::Surface;

/// Outermost nodes of a map along x or y, from its middle node [m].
struct MapSide {
    double first, last;

    /// Whether the next cell outwards lies beyond them.
    bool is_border(double x, double cell) const {
        constexpr double rounding = 1e-6;  // in cells: nodes and cells of one spacing coincide
        return x - cell < first - rounding * cell || x + cell > last + rounding * cell;
    }
};

MapSide side_of(int n, double spacing) {
    const double first = -(n / 2) * spacing;
    return {first, first + (n - 1) * spacing};
}

}  // namespace

double border_force_share(const HeightMap& map, const Surface& s) {
    if (s.layout != Surface::Layout::grid) return 0;
    const std::array<MapSide, 2> sides{side_of(map.n_x, map.spacing[0]),
                                       side_of(map.n_y, map.spacing[1])};
    double border = 0, all = 0;
    for (int j = 0; j < s.n_y; ++j)
        for (int i = 0; i < s.n_x; ++i) {
            const double p = s.normal_traction[static_cast<std::size_t>(j) * s.n_x + i];
            all += p;
            if (sides[0].is_border(s.x(i) - s.offset[0], s.spacing[0]) ||
                sides[1].is_border(s.y(j) - s.offset[1], s.spacing[1]))
                border += p;
        }
    return all > 0 ? border / all : 0;
}

std::optional<double> border_force_share(const contact::Case& c, const contact::History& history) {
    const auto& map = c.indenter.height_map;
    if (!map || c.period || history.snapshots.empty()) return {};
    double largest = 0;
    for (const contact::Snapshot& one : history.snapshots)
        largest = std::max(largest, border_force_share(*map, one.surface));
    return largest;
}

}  // namespace tricontact::comparisons
