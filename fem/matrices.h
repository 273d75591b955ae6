#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

// Matrices are symmetric: sparse ones keep their lower triangle by columns, as CHOLMOD takes it;
// dense ones are whole, by columns, since products with a part of the columns then read memory in
// one run.

namespace tricontact::fem {

/// Copies the lower triangle of an n x n matrix to its upper one.
inline void mirror_lower(std::vector<double>& matrix, std::size_t n) {
    constexpr std::size_t block = 64;  // both squares stay in the first level cache
    for (std::size_t c0 = 0; c0 < n; c0 += block)
        for (std::size_t r0 = c0; r0 < n; r0 += block)
            for (std::size_t c = c0; c < std::min(c0 + block, n); ++c)
                for (std::size_t r = std::max(r0, c + 1); r < std::min(r0 + block, n); ++r)
                    matrix[r * n + c] = matrix[c * n + r];
}

/// Lower triangle of a symmetric matrix by compressed columns, rows increasing in each column.
struct SparseMatrix {
    int n = 0;
    std::vector<std::int64_t> column_start;  ///< n + 1
    std::vector<std::int64_t> row;
    std::vector<double> value;
};

}  // namespace tricontact::fem
