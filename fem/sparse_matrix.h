#pragma once

#include <cstdint>
#include <vector>

namespace tricontact::fem {

/// Lower triangle of a symmetric matrix by compressed columns, rows increasing in each column.
struct SparseMatrix {
    int n = 0;
    std::vector<std::int64_t> column_start;  ///< n + 1
    std::vector<std::int64_t> row;
    std::vector<double> value;
};

}  // namespace tricontact::fem
