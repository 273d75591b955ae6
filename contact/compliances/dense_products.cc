#include "contact/compliances/dense_products.h"

#include <algorithm>
#include <array>

#include "contact/compliances/wide_vectors.h"

namespace tricontact::contact {

namespace {

TRICONTACT_WIDEST_VECTORS
void add_group_wide(const std::array<const double*, group>& column,
                    const std::array<double, group>& factor, std::size_t n, double* sum) {
    add_group<double, 1>(column, factor, n, sum);
}

}  // namespace

void add_columns(const ColumnBlock<double>& columns, std::span<const double> factor,
                 std::span<double> sum) {
    std::array<const double*, group> column{};
    std::array<double, group> factors{};
    std::size_t waiting = 0;
    for (std::size_t j = 0; j < factor.size(); ++j) {
        if (factor[j] == 0) continue;
        factors[waiting] = factor[j];
        column[waiting] = columns.first + columns.stride * j;
        if (++waiting < group) continue;
        add_group_wide(column, factors, sum.size(), sum.data());
        waiting = 0;
    }
    if (waiting == 0) return;
    for (std::size_t k = waiting; k < group; ++k) {
        column[k] = column[0];
        factors[k] = 0;
    }
    add_group_wide(column, factors, sum.size(), sum.data());
}

namespace {

/// y += columns * xs if `and_add`, and products of the columns with x, of `group` columns.
template <bool and_add, class Real>
TRICONTACT_WITHIN std::array<Real, group> products_with(const ColumnBlock<Real>& columns,
                                                        std::size_t n, const Real* xs,
                                                        const Real* x, Real* y) {
    std::array<Vector<Real>, group> sums{};
    std::size_t i = 0;
    for (; i + lanes<Real> <= n; i += lanes<Real>) {
        const auto xi = Vector<Real>::load(x + i);
        Vector<Real> s{};
        if constexpr (and_add) s = Vector<Real>::load(y + i);
        for (std::size_t k = 0; k < group; ++k) {
            const auto a = Vector<Real>::load(columns.first + columns.stride * k + i);
            if constexpr (and_add) s.lanes += a.lanes * xs[k];
            sums[k].lanes += a.lanes * xi.lanes;
        }
        if constexpr (and_add) s.store(y + i);
    }
    std::array<Real, group> total{};
    for (std::size_t k = 0; k < group; ++k) {
        const Real* const column = columns.first + columns.stride * k;
        for (std::size_t l = 0; l < lanes<Real>; ++l) total[k] += sums[k].lanes[l];
        for (std::size_t r = i; r < n; ++r) {
            if constexpr (and_add) y[r] += column[r] * xs[k];
            total[k] += column[r] * x[r];
        }
    }
    return total;
}

TRICONTACT_WIDEST_VECTORS
void multiply_group(const ColumnBlock<double>& columns, std::size_t n, const double* x,
                    double* result) {
    const auto total = products_with<false, double>(columns, n, nullptr, x, nullptr);
    for (std::size_t k = 0; k < group; ++k) result[k] = total[k];
}

template <class Real>
TRICONTACT_WITHIN void multiply_triangle(const ColumnBlock<Real>& lower, std::size_t n,
                                         const Real* x, Real* y) {
    for (std::size_t i = 0; i < n; ++i) y[i] = 0;
    for (std::size_t j = 0; j < n; j += group) {
        const std::size_t next = std::min(j + group, n);
        const ColumnBlock<Real> own = {lower.first + lower.stride * j, lower.stride};
        for (std::size_t k = j; k < next; ++k)
            for (std::size_t r = j; r < next; ++r)
                y[r] += own.first[own.stride * (k - j) + r] * x[k];
        if (next == n) break;
        const auto total = products_with<true>({own.first + next, own.stride}, n - next, x + j,
                                               x + next, y + next);
        for (std::size_t k = 0; k < group; ++k) y[j + k] += total[k];
    }
}

TRICONTACT_WIDEST_VECTORS
void multiply_double(const ColumnBlock<double>& lower, std::size_t n, const double* x, double* y) {
    multiply_triangle(lower, n, x, y);
}
TRICONTACT_WIDEST_VECTORS
void multiply_single(const ColumnBlock<float>& lower, std::size_t n, const float* x, float* y) {
    multiply_triangle(lower, n, x, y);
}

}  // namespace

void multiply_transposed(const ColumnBlock<double>& columns, std::span<const double> x,
                         std::span<double> result) {
    std::size_t j = 0;
    for (; j + group <= result.size(); j += group)
        multiply_group({columns.first + columns.stride * j, columns.stride}, x.size(), x.data(),
                       result.data() + j);
    for (; j < result.size(); ++j) {
        result[j] = 0;
        for (std::size_t i = 0; i < x.size(); ++i)
            result[j] += columns.first[columns.stride * j + i] * x[i];
    }
}

void multiply_symmetric(const ColumnBlock<double>& lower, std::span<const double> x,
                        std::span<double> y) {
    multiply_double(lower, x.size(), x.data(), y.data());
}

void multiply_symmetric(const ColumnBlock<float>& lower, std::span<const float> x,
                        std::span<float> y) {
    multiply_single(lower, x.size(), x.data(), y.data());
}

}  // namespace tricontact::contact
