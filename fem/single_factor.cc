#include "fem/single_factor.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "fem/memory.h"

extern "C" {
// LAPACK: inverse of a triangular matrix.
void dtrtri_(const char* uplo, const char* diagonal, const int* n, double* a, const int* lda,
             int* info);
// BLAS: multiplies by a triangular matrix; by any.
void dtrmm_(const char* side, const char* uplo, const char* transposed, const char* diagonal,
            const int* n_rows, const int* n_columns, const double* alpha, const double* a,
            const int* lda, double* b, const int* ldb);
void sgemv_(const char* transposed, const int* n_rows, const int* n_columns, const float* alpha,
            const float* a, const int* lda, const float* x, const int* stride, const float* beta,
            float* y, const int* y_stride);
}

// L x = f by panels. A panel holds L11^-1 and L21 L11^-1 in place of L11 and L21, so that one
// matrix-vector product per panel does substitution and update: reading the factor bounds the time,
// and single precision halves what is read.
//
//   [ L11      ] [ x1 ]   [ f1 ]        x1 = L11^-1 f1
//   [ L21  L22 ] [ x2 ] = [ f2 ],       f2 <- f2 - (L21 L11^-1) f1
//
// Errors of 1e-6 do no harm: who uses it corrects what the last solution left
// (deferred_correction.h). A solution comes in two halves, since contact needs the surface's
// displacements by all other forces before its own are known: x = L^-1 f (`eliminate`); L' of the
// contact panels gives the surface (`contact_displacements`); contact forces are added to x, and L'
// of all panels gives the rest (`complete`).

namespace tricontact::fem {

SingleFactor::SingleFactor(std::vector<int> order, int n_interior, std::size_t n_values)
    : order_(std::move(order)), n_interior_(n_interior) {
    reserve_large(values_, n_values);
}

// The panel of the double factor becomes [L11^-1; L21 L11^-1], in double precision, and is rounded
// once.
void SingleFactor::add(int n_columns, std::span<const std::int64_t> row, const double* column,
                       std::size_t ld) {
    const int n_rows = static_cast<int>(row.size()), n_below = n_rows - n_columns;
    std::vector<double> panel;
    panel.reserve(static_cast<std::size_t>(n_rows) * n_columns);
    for (int c = 0; c < n_columns; ++c, column += ld) {
        panel.insert(panel.end(), c, 0);  // whatever is above the diagonal
        panel.insert(panel.end(), column + c, column + n_rows);
    }
    int info = 0;  // a factor's diagonal is positive
    dtrtri_("L", "N", &n_columns, panel.data(), &n_rows, &info);
    constexpr double one = 1;
    if (n_below > 0)
        dtrmm_("R", "L", "N", "N", &n_below, &n_columns, &one, panel.data(), &n_rows,
               panel.data() + n_columns, &n_rows);
    panels_.push_back({static_cast<int>(row[0]), n_columns, n_rows, rows_.size(), values_.size()});
    if (row[0] < n_interior_) n_interior_panels_ = panels_.size();
    rows_.insert(rows_.end(), row.begin() + n_columns, row.end());
    values_.insert(values_.end(), panel.begin(), panel.end());
    most_rows_ = std::max(most_rows_, n_rows);
}

std::span<const SingleFactor::Panel> SingleFactor::contact_panels() const {
    return std::span(panels_).subspan(n_interior_panels_);
}

/// By L.
void SingleFactor::divide(std::vector<float>& x, std::span<const Panel> panels) const {
    constexpr int stride = 1;
    constexpr float one = 1, zero = 0;
    std::vector<float> product(most_rows_);
    for (const Panel& p : panels) {
        float* const own = x.data() + p.column;
        sgemv_("N", &p.n_rows, &p.n_columns, &one, values_.data() + p.first, &p.n_rows, own,
               &stride, &zero, product.data(), &stride);
        std::copy_n(product.begin(), p.n_columns, own);
        const int* const row = rows_.data() + p.first_row - p.n_columns;
        for (int i = p.n_columns; i < p.n_rows; ++i) x[row[i]] -= product[i];
    }
}

/// By the transpose of L.
void SingleFactor::divide_transposed(std::vector<float>& x, std::span<const Panel> panels) const {
    constexpr int stride = 1;
    constexpr float one = 1, zero = 0;
    std::vector<float> known(most_rows_);
    for (std::size_t s = panels.size(); s-- > 0;) {
        const Panel& p = panels[s];
        float* const own = x.data() + p.column;
        std::copy_n(own, p.n_columns, known.begin());
        const int* const row = rows_.data() + p.first_row - p.n_columns;
        for (int i = p.n_columns; i < p.n_rows; ++i) known[i] = -x[row[i]];
        sgemv_("T", &p.n_rows, &p.n_columns, &one, values_.data() + p.first, &p.n_rows,
               known.data(), &stride, &zero, own, &stride);
    }
}

std::vector<float> SingleFactor::eliminate(std::span<const double> forces) const {
    std::vector<float> x(forces.size());
    for (std::size_t k = 0; k < x.size(); ++k) x[k] = static_cast<float>(forces[order_[k]]);
    divide(x, panels_);
    return x;
}

std::vector<double> SingleFactor::contact_displacements(std::span<const float> eliminated) const {
    std::vector<float> x(eliminated.begin(), eliminated.end());
    divide_transposed(x, contact_panels());
    return {x.begin() + n_interior_, x.end()};
}

std::vector<double> SingleFactor::complete(std::span<const float> eliminated,
                                           std::span<const double> contact_forces) const {
    std::vector<float> x(eliminated.size());
    std::ranges::transform(contact_forces, x.begin() + n_interior_,
                           [](double force) { return static_cast<float>(force); });
    divide(x, contact_panels());
    std::ranges::transform(x, eliminated, x.begin(), std::plus());
    divide_transposed(x, panels_);
    std::vector<double> all(x.size());
    for (std::size_t k = 0; k < x.size(); ++k) all[order_[k]] = x[k];
    return all;
}

}  // namespace tricontact::fem
