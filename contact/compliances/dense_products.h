#pragma once

#include <cstddef>
#include <span>

namespace tricontact::contact {

/// Some columns of a matrix, by columns of equal length.
template <class Real>
struct ColumnBlock {
    const Real* first;   ///< of the first column: its first row that is meant
    std::size_t stride;  ///< from column to column
};

/// sum += columns * factor; columns whose factor is zero are not read.
void add_columns(const ColumnBlock<double>& columns, std::span<const double> factor,
                 std::span<double> sum);

/// result = columns' x: a product of each column with x.
void multiply_transposed(const ColumnBlock<double>& columns, std::span<const double> x,
                         std::span<double> result);

/// Columns that are read side by side.
constexpr std::size_t columns_in_group = 8;
constexpr std::size_t first_of_group(std::size_t column) {
    return column / columns_in_group * columns_in_group;
}

/// y = A x of a symmetric matrix whose lower triangle is given, and the upper one within each group
/// of columns_in_group from the first on.
void multiply_symmetric(const ColumnBlock<double>& lower, std::span<const double> x,
                        std::span<double> y);
void multiply_symmetric(const ColumnBlock<float>& lower, std::span<const float> x,
                        std::span<float> y);

}  // namespace tricontact::contact
