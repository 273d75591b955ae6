#include "fem/block/fast_diagonalisation.h"

#include <omp.h>

#include <algorithm>
#include <stdexcept>

#include "fem/one_blas_thread.h"
#include "fem/quadratic_line.h"

extern "C" {
void dsygv_(const int* type, const char* jobz, const char* uplo, const int* n, double* a,
            const int* lda, double* b, const int* ldb, double* w, double* work, const int* lwork,
            int* info);
void dgemm_(const char* transa, const char* transb, const int* m, const int* n, const int* k,
            const double* alpha, const double* a, const int* lda, const double* b, const int* ldb,
            const double* beta, double* c, const int* ldc);
}

namespace tricontact::fem {

namespace {

constexpr int chunk = 2048;  // points of a plane that are turned along z at a time

/// to (m x n) = a (m x k) b, or with b transposed.
void multiply(int m, int n, int k, const double* a, int lda, bool transposed_a, const double* b,
              int ldb, bool transposed_b, double* to, int ldc) {
    const double one = 1, zero = 0;
    dgemm_(transposed_a ? "T" : "N", transposed_b ? "T" : "N", &m, &n, &k, &one, a, &lda, b, &ldb,
           &zero, to, &ldc);
}

}  // namespace

FastDiagonalisation::Modes FastDiagonalisation::modes_of(const BlockAxis& axis,
                                                         const std::vector<double>& stiff,
                                                         int component) {
    static const QuadraticLine line;
    const int n_all = axis.n_nodes();
    const int low = axis.held[0] >> component & 1, high = axis.held[1] >> component & 1;
    const int n = n_all - low - high;
    std::vector<double> k(static_cast<std::size_t>(n) * n), m(k.size()), values(n);
    for (int e = 0; e < axis.n_elements(); ++e)
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                const int r = 2 * e + i - low, c = 2 * e + j - low;
                if (r < 0 || c < 0 || r >= n || c >= n) continue;
                const std::size_t at = static_cast<std::size_t>(c) * n + r;
                k[at] += stiff[e] * line.stiffness[i][j] / axis.edge(e);
                m[at] += stiff[e] * line.mass[i][j] * axis.edge(e);
            }
    const int type = 1, n_work = 64 * n + 64;
    std::vector<double> work(n_work);
    int info = 0;
    dsygv_(&type, "V", "L", &n, k.data(), &n, m.data(), &n, values.data(), work.data(), &n_work,
           &info);
    if (info != 0) throw std::logic_error("FastDiagonalisation: dsygv " + std::to_string(info));
    Modes modes{.n = n_all,
                .vectors = std::vector<double>(static_cast<std::size_t>(n_all) * n_all),
                .values = std::vector<double>(n_all, 1.)};
    for (int c = 0; c < n; ++c) {
        modes.values[c] = std::max(0., values[c]);
        std::copy_n(&k[static_cast<std::size_t>(c) * n], n,
                    &modes.vectors[static_cast<std::size_t>(c) * n_all + low]);
    }
    return modes;
}

// Allocated beforehand: no error may leave a loop of threads.
std::size_t FastDiagonalisation::scratch_of_thread(const BlockGrid& grid) {
    const auto& [x, y, z] = grid.axes;
    return static_cast<std::size_t>(x.n_nodes()) * y.n_nodes() +
           static_cast<std::size_t>(chunk) * z.n_nodes();
}

FastDiagonalisation::FastDiagonalisation(const BlockGrid& grid, int n_threads, double weight)
    : weight_(weight),
      n_threads_(n_threads),
      scratch_(grid.n_nodes()),
      of_threads_(n_threads * scratch_of_thread(grid)) {
    const OneBlasThread one;
    for (int d = 0; d < 3; ++d) {
        std::vector<double> stiff(grid.axes[d].n_elements(), 1.);
        if (d == 2)
            for (std::size_t e = 0; e < stiff.size(); ++e) stiff[e] = grid.moduli[e].shear;
        for (int c = 0; c < 3; ++c) modes_[c][d] = modes_of(grid.axes[d], stiff, c);
    }
}

void FastDiagonalisation::solve(int c, std::span<const double> right, std::span<double> to) {
    const auto& [x, y, z] = modes_[c];
    const OneBlasThread one;
    const std::size_t plane = static_cast<std::size_t>(x.n) * y.n;
    const int n_planes = z.n;
    const int n_chunks = static_cast<int>((plane + chunk - 1) / chunk);
    const int stride = static_cast<int>(plane);
    double* const half = scratch_.data();
#pragma omp parallel num_threads(n_threads_) if (n_threads_ > 1)
    {
        double* const of_plane =
            of_threads_.data() + omp_get_thread_num() * (of_threads_.size() / n_threads_);
        double* const of_chunk = of_plane + plane;
#pragma omp for schedule(static)
        for (int k = 0; k < n_planes; ++k) {
            multiply(x.n, y.n, x.n, x.vectors.data(), x.n, true, right.data() + k * plane, x.n,
                     false, of_plane, x.n);
            multiply(x.n, y.n, y.n, of_plane, x.n, false, y.vectors.data(), y.n, false,
                     half + k * plane, x.n);
        }
#pragma omp for schedule(static)
        for (int b = 0; b < n_chunks; ++b) {
            const int first = b * chunk, n = std::min<int>(chunk, stride - first);
            multiply(n, z.n, z.n, half + first, stride, false, z.vectors.data(), z.n, false,
                     of_chunk, n);
            for (int k = 0; k < z.n; ++k)
                for (int i = 0; i < n; ++i) {
                    const int in_plane = first + i;
                    const double sum = (c == 0 ? weight_ : 1) * x.values[in_plane % x.n] +
                                       (c == 1 ? weight_ : 1) * y.values[in_plane / x.n] +
                                       (c == 2 ? weight_ : 1) * z.values[k];
                    of_chunk[static_cast<std::size_t>(k) * n + i] /= sum;
                }
            multiply(n, z.n, z.n, of_chunk, n, false, z.vectors.data(), z.n, true, half + first,
                     stride);
        }
#pragma omp for schedule(static)
        for (int k = 0; k < n_planes; ++k) {
            multiply(x.n, y.n, y.n, half + k * plane, x.n, false, y.vectors.data(), y.n, true,
                     of_plane, x.n);
            multiply(x.n, y.n, x.n, x.vectors.data(), x.n, false, of_plane, x.n, false,
                     to.data() + k * plane, x.n);
        }
    }
}

}  // namespace tricontact::fem
