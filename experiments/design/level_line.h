#pragma once

#include <utility>
#include <vector>

namespace tricontact::experiments {

/// Values on a square grid of equal places along both axes; NaN: none.
struct LevelGrid {
    std::vector<double> places;  ///< increasing
    std::vector<double> values;  ///< first axis fastest
};

using LevelPoint = std::pair<double, double>;

/// The line where the values are zero, as straight pieces, one or two per cell; on its edges the
/// values are taken as linear. None in a cell that lacks a value. Two pieces of a saddle join the
/// crossings in the order of the edges, around the cell.
std::vector<std::pair<LevelPoint, LevelPoint>> zero_line(const LevelGrid& grid);

}  // namespace tricontact::experiments
