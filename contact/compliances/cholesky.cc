#include "contact/compliances/cholesky.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/compliances/wide_vectors.h"

namespace tricontact::contact {

namespace {

constexpr std::size_t tile_columns = 4, panel_width = 64, narrow_width = 8;

/// C -= A B' of a tile of two vectors of rows and tile_columns columns.
template <class Real>
TRICONTACT_WITHIN void subtract_tile(Real* c, const Real* a, const Real* b, std::size_t stride,
                                     std::size_t depth) {
    using V = Vector<Real>;
    constexpr std::size_t n = lanes<Real>;
    std::array<std::array<V, 2>, tile_columns> sum;
    for (std::size_t j = 0; j < tile_columns; ++j)
        for (std::size_t v = 0; v < 2; ++v) sum[j][v] = V::load(c + stride * j + n * v);
    for (std::size_t k = 0; k < depth; ++k) {
        const V a0 = V::load(a + stride * k), a1 = V::load(a + stride * k + n);
        for (std::size_t j = 0; j < tile_columns; ++j) {
            const Real factor = b[stride * k + j];
            sum[j][0].lanes -= a0.lanes * factor;
            sum[j][1].lanes -= a1.lanes * factor;
        }
    }
    for (std::size_t j = 0; j < tile_columns; ++j)
        for (std::size_t v = 0; v < 2; ++v) sum[j][v].store(c + stride * j + n * v);
}

/// A lower triangle by columns, whose rows before `from` are done.
template <class Real>
struct Triangle {
    Real* first;
    std::size_t stride, n, from;
    TRICONTACT_WITHIN Real* column(std::size_t j) const { return first + stride * j; }
};

/// Takes what the columns k0 ... k1 - 1 make of them from the columns first ... last - 1.
template <class Real>
TRICONTACT_WITHIN void subtract_products(const Triangle<Real>& a, std::size_t first,
                                         std::size_t last, std::size_t k0, std::size_t k1) {
    constexpr std::size_t tile_rows = 2 * lanes<Real>;
    for (std::size_t j = first; j < last; j += tile_columns) {
        const std::size_t end = std::min(j + tile_columns, last);
        // Tiles begin at whole vectors, above the diagonal if nothing there is needed any more.
        std::size_t tiles = j / lanes<Real> * lanes<Real>;
        if (tiles < a.from) tiles = (a.from + lanes<Real> - 1) / lanes<Real> * lanes<Real>;
        if (end < j + tile_columns) tiles = a.n;
        for (std::size_t c = j; c < end; ++c)
            for (std::size_t r = std::max(c, a.from); r < std::min(tiles, a.n); ++r)
                for (std::size_t k = k0; k < k1; ++k)
                    a.column(c)[r] -= a.column(k)[r] * a.column(k)[c];
        for (std::size_t i = tiles; i < a.n; i += tile_rows)
            subtract_tile(a.column(j) + i, a.column(k0) + i, a.column(k0) + j, a.stride, k1 - k0);
    }
}

/// Of the columns first ... last - 1, from which all before them have been taken. False if a
/// diagonal is not positive.
template <class Real>
TRICONTACT_WITHIN bool factorise_few(const Triangle<Real>& a, std::size_t first, std::size_t last) {
    for (std::size_t j = first; j < last; ++j) {
        Real* const own = a.column(j);
        for (std::size_t k = first; k < j; ++k) {
            const Real* const other = a.column(k);
            const Real factor = other[j];
            for (std::size_t r = std::max(j, a.from); r < a.n; ++r) own[r] -= other[r] * factor;
        }
        if (j >= a.from) {
            if (!(own[j] > 0)) return false;
            own[j] = std::sqrt(own[j]);
        }
        for (std::size_t r = std::max(j + 1, a.from); r < a.n; ++r) own[r] /= own[j];
    }
    return true;
}

// Each entry is diminished by one product after the other, in the order of the columns: blocks
// change no bit.
template <class Real>
TRICONTACT_WITHIN bool factorise_triangle(const Triangle<Real>& a) {
    for (std::size_t p = 0; p < a.n; p += panel_width) {
        const std::size_t next = std::min(p + panel_width, a.n);
        for (std::size_t j = p; j < next; j += narrow_width) {
            const std::size_t end = std::min(j + narrow_width, next);
            subtract_products(a, j, end, p, j);
            if (!factorise_few(a, j, end)) return false;
        }
        subtract_products(a, next, a.n, p, next);
    }
    return true;
}

TRICONTACT_WIDEST_VECTORS bool factorise_single(const Triangle<float>& a) {
    return factorise_triangle(a);
}
TRICONTACT_WIDEST_VECTORS bool factorise_double(const Triangle<double>& a) {
    return factorise_triangle(a);
}

/// x -= column * x[j] below the diagonal, one column after the other.
template <class Real>
TRICONTACT_WITHIN void solve_forward(const Triangle<const Real>& a, Real* x) {
    std::size_t j = 0;
    for (; j + group <= a.n; j += group) {
        const std::size_t below = j + group;
        std::array<const Real*, group> column;
        std::array<Real, group> factor;
        for (std::size_t k = 0; k < group; ++k) {
            const Real* const own = a.column(j + k);
            x[j + k] /= own[j + k];
            for (std::size_t r = j + k + 1; r < below; ++r) x[r] -= own[r] * x[j + k];
            column[k] = own + below;
            factor[k] = x[j + k];
        }
        add_group<Real, -1>(column, factor, a.n - below, x + below);
    }
    for (; j < a.n; ++j) {
        const Real* const own = a.column(j);
        x[j] /= own[j];
        for (std::size_t r = j + 1; r < a.n; ++r) x[r] -= own[r] * x[j];
    }
}

template <class Real>
TRICONTACT_WITHIN void solve_backward(const Triangle<const Real>& a, Real* x) {
    std::size_t end = a.n;
    const auto finish = [&](std::size_t j, std::size_t known) __attribute__((always_inline)) {
        const Real* const own = a.column(j);
        Real rest = x[j];
        for (std::size_t r = j + 1; r < known; ++r) rest -= own[r] * x[r];
        x[j] = rest / own[j];
    };
    for (; end % group != 0; --end) finish(end - 1, a.n);
    for (; end > 0; end -= group) {
        const std::size_t j = end - group;
        std::array<Vector<Real>, group> sums{};
        std::size_t i = end;
        for (; i + lanes<Real> <= a.n; i += lanes<Real>) {
            const auto xi = Vector<Real>::load(x + i);
            for (std::size_t k = 0; k < group; ++k)
                sums[k].lanes += Vector<Real>::load(a.column(j + k) + i).lanes * xi.lanes;
        }
        for (std::size_t k = 0; k < group; ++k) {
            Real sum = 0;
            for (std::size_t l = 0; l < lanes<Real>; ++l) sum += sums[k].lanes[l];
            for (std::size_t r = i; r < a.n; ++r) sum += a.column(j + k)[r] * x[r];
            x[j + k] -= sum;
        }
        for (std::size_t k = group; k-- > 0;) finish(j + k, end);
    }
}

TRICONTACT_WIDEST_VECTORS void solve_single(const Triangle<const float>& a, float* x) {
    solve_forward(a, x);
    solve_backward(a, x);
}
TRICONTACT_WIDEST_VECTORS void solve_double(const Triangle<const double>& a, double* x) {
    solve_forward(a, x);
    solve_backward(a, x);
}

}  // namespace

template <class Real>
void Cholesky<Real>::enlarge(std::size_t n) {
    // Tiles of two lines reach beyond the last row; an odd number of lines spreads columns over
    // the sets of a cache.
    const std::size_t needed = (n + line_length - 1) / line_length + 1;
    const std::size_t lines = needed | 1;
    if (n_ == 0) {
        lines_.resize(lines * n);
    } else {
        std::vector<Line> larger(lines * n);
        for (std::size_t j = 0; j < n_; ++j)
            std::copy_n(lines_.begin() + static_cast<std::ptrdiff_t>(j * lines_per_column_),
                        lines_per_column_, larger.begin() + static_cast<std::ptrdiff_t>(j * lines));
        lines_ = std::move(larger);
    }
    lines_per_column_ = lines;
    n_ = n;
}

template <class Real>
bool Cholesky<Real>::factorise(std::size_t old) {
    const Triangle<Real> all = {column(0), lines_per_column_ * line_length, n_, old};
    if constexpr (sizeof(Real) == sizeof(float))
        return factorise_single(all);
    else
        return factorise_double(all);
}

template <class Real>
void Cholesky<Real>::solve(std::span<Real> x) const {
    const Triangle<const Real> all = {column(0), lines_per_column_ * line_length, n_, 0};
    if constexpr (sizeof(Real) == sizeof(float))
        solve_single(all, x.data());
    else
        solve_double(all, x.data());
}

template class Cholesky<float>;
template class Cholesky<double>;

}  // namespace tricontact::contact
