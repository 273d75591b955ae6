#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace tricontact::contact {

/// The Cholesky factor of a symmetric positive definite matrix of single or double precision.
template <class Real>
class Cholesky {
  public:
    std::size_t size() const { return n_; }
    /// Forgets the matrix and keeps the memory.
    void clear() { n_ = 0; }

    /// Adds rows and columns to the matrix: `entry(i, j)`, i >= j, for the new i = size() ... n
    /// - 1. False if it is not positive definite. The factor is the same to the last bit as that of
    /// the whole matrix.
    template <class Entry>
    bool extend(std::size_t n, Entry entry) {
        const std::size_t old = n_;
        enlarge(n);
        for (std::size_t j = 0; j < n; ++j)
            for (std::size_t i = std::max(j, old); i < n; ++i)
                column(j)[i] = static_cast<Real>(entry(i, j));
        return factorise(old);
    }

    /// Replaces x by the solution of A y = x.
    void solve(std::span<Real> x) const;

  private:
    static constexpr std::size_t line_length = 64 / sizeof(Real);
    struct alignas(64) Line {
        std::array<Real, line_length> values;
    };
    Real* column(std::size_t j) { return lines_[j * lines_per_column_].values.data(); }
    const Real* column(std::size_t j) const { return lines_[j * lines_per_column_].values.data(); }
    void enlarge(std::size_t n);
    bool factorise(std::size_t old);

    std::size_t n_ = 0, lines_per_column_ = 0;
    std::vector<Line> lines_;  // by columns; what is above the diagonal means nothing
};

extern template class Cholesky<float>;
extern template class Cholesky<double>;

}  // namespace tricontact::contact
