#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/tables/height_map_file.h"

namespace tricontact::io {

/// Numbers as they stand in the file of a map, rows of equal length.
struct NumberMatrix {
    std::size_t n_columns = 0, n_rows = 0;
    std::vector<double> value;  ///< columns run fastest; that of the first corner may be NaN

    double at(std::size_t column, std::size_t row) const { return value[row * n_columns + column]; }
};

/// The map that the numbers are:
///   x, y and z of each node of a regular lattice, in any order;
///   heights below a row and beside a column of coordinates;
///   heights alone.
/// Coordinates have to be multiples of the scale's spacing by a power of ten, their unit, or to
/// count the nodes. Throws contact::InputError where the numbers look like coordinates and are no
/// such map. `is_text`: of a text file, whose rows may be anything; arrays are heights where both
/// is possible.
contact::HeightMap laid_out(const NumberMatrix& numbers, const std::string& name,
                            const HeightMapScale& scale, bool is_text);

}  // namespace tricontact::io
