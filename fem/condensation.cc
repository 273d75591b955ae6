#include "fem/condensation.h"

#include <cholmod.h>
#include <omp.h>

#include <algorithm>
#include <mutex>
#include <new>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "contact/base/error.h"
#include "fem/dissection_order.h"
#include "fem/memory.h"

extern "C" {
// LAPACK: inverse of a symmetric positive definite matrix from its Cholesky factor.
void dpotri_(const char* uplo, const int* n, double* a, const int* lda, int* info);
}

namespace tricontact::fem {

namespace {

using Index = SuiteSparse_long;
static_assert(sizeof(Index) == sizeof(std::int64_t));

// CHOLMOD allocates in large pages, in all of the process while one of these lives.
class LargePages {
  public:
    LargePages() {
        const std::scoped_lock lock(mutex);
        if (n_living++ == 0)
            before = std::exchange(SuiteSparse_config.malloc_func, allocate_in_large_pages);
    }
    ~LargePages() {
        const std::scoped_lock lock(mutex);
        if (--n_living == 0) SuiteSparse_config.malloc_func = before;
    }
    LargePages(const LargePages&) = delete;
    LargePages& operator=(const LargePages&) = delete;

  private:
    static inline std::mutex mutex;
    static inline int n_living = 0;
    static inline void* (*before)(std::size_t) = nullptr;
};

// CHOLMOD's state; its status becomes exceptions.
class Cholmod {
  public:
    Cholmod() {
        cholmod_l_start(&common_);
        common_.print = 0;
        common_.supernodal = CHOLMOD_SUPERNODAL;
        common_.nmethods = 1;
        common_.method[0].ordering = CHOLMOD_NATURAL;
        common_.postorder = 0;
    }
    ~Cholmod() { cholmod_l_finish(&common_); }
    Cholmod(const Cholmod&) = delete;
    Cholmod& operator=(const Cholmod&) = delete;

    cholmod_common* get() { return &common_; }

    void check() const {
        if (common_.status == CHOLMOD_OK) return;
        if (common_.status == CHOLMOD_OUT_OF_MEMORY || common_.status == CHOLMOD_TOO_LARGE)
            throw std::bad_alloc();
        if (common_.status == CHOLMOD_NOT_POSDEF)
            throw contact::NotConverged(
                "the layer's stiffness is not positive definite: the mesh has parts that nothing "
                "holds, or inverted elements");
        throw std::logic_error("CHOLMOD: status " + std::to_string(common_.status));
    }

  private:
    LargePages pages_;
    cholmod_common common_{};
};

// CHOLMOD shares each supernode's loops among four threads, which wait for each other as long as
// they work; the products between are threads of BLAS.
class OneThread {
  public:
    OneThread() { omp_set_max_active_levels(0); }
    ~OneThread() { omp_set_max_active_levels(before_); }
    OneThread(const OneThread&) = delete;
    OneThread& operator=(const OneThread&) = delete;

  private:
    int before_ = omp_get_max_active_levels();
};

template <auto free_object>
struct Free {
    Cholmod* cholmod = nullptr;
    template <class T>
    void operator()(T* object) const {
        free_object(&object, cholmod->get());
    }
};
using Sparse = std::unique_ptr<cholmod_sparse, Free<cholmod_l_free_sparse>>;
using Dense = std::unique_ptr<cholmod_dense, Free<cholmod_l_free_dense>>;
using Factor = std::unique_ptr<cholmod_factor, Free<cholmod_l_free_factor>>;

// What CHOLMOD has just made.
template <class Owned>
Owned owned(typename Owned::pointer object, Cholmod& cholmod) {
    cholmod.check();
    if (!object) throw std::bad_alloc();
    return Owned(object, {&cholmod});
}

// Rows and columns in an order, which may lack some; columns not sorted.
Sparse upper_triangle(const SparseMatrix& lower, const std::vector<Index>& order,
                      Cholmod& cholmod) {
    std::vector<Index> place(lower.n, -1);
    for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<Index>(k);
    const auto for_entries = [&](auto visit) {
        for (int c = 0; c < lower.n; ++c) {
            if (place[c] < 0) continue;
            for (auto k = lower.column_start[c]; k < lower.column_start[c + 1]; ++k)
                if (const Index r = place[lower.row[k]]; r >= 0)
                    visit(std::min(r, place[c]), std::max(r, place[c]), lower.value[k]);
        }
    };
    const std::size_t n = order.size();
    std::vector<Index> next(n + 1, 0);
    for_entries([&](Index, Index column, double) { ++next[column + 1]; });
    std::partial_sum(next.begin(), next.end(), next.begin());
    Sparse upper = owned<Sparse>(
        cholmod_l_allocate_sparse(n, n, next.back(), 0, 1, 1, CHOLMOD_REAL, cholmod.get()),
        cholmod);
    std::ranges::copy(next, static_cast<Index*>(upper->p));
    auto* const rows = static_cast<Index*>(upper->i);
    auto* const values = static_cast<double*>(upper->x);
    for_entries([&](Index row, Index column, double value) {
        const Index at = next[column]++;
        rows[at] = row;
        values[at] = value;
    });
    return upper;
}

// The order in which children come right before their parents in the elimination tree of the
// matrix, whose upper triangle is given; that makes supernodes wide.
std::vector<Index> postorder(cholmod_sparse& upper, Cholmod& cholmod) {
    std::vector<Index> parent(upper.ncol), post(upper.ncol);
    cholmod_l_etree(&upper, parent.data(), cholmod.get());
    cholmod.check();
    cholmod_l_postorder(parent.data(), parent.size(), nullptr, post.data(), cholmod.get());
    cholmod.check();
    return post;
}

// The values of a numerical factor: supernode s has the columns super[s] to super[s + 1] and the
// rows row[row_start[s]] to row[row_start[s + 1]], its values by columns from value_start[s] on.
struct Supernodes {
    std::size_t n;
    const Index *super, *row_start, *value_start, *row;
    const double* value;
};

Supernodes supernodes_of(const cholmod_factor& factor) {
    return {factor.nsuper,
            static_cast<const Index*>(factor.super),
            static_cast<const Index*>(factor.pi),
            static_cast<const Index*>(factor.px),
            static_cast<const Index*>(factor.s),
            static_cast<const double*>(factor.x)};
}

}  // namespace

struct Condensation::Parts {
    Cholmod cholmod;
    std::vector<Index> order;  // unknown that comes k-th
    Sparse stiffness;          // lower triangle in that order
    Factor factor;
    int n_all = 0, n_interior = 0, n_contact = 0;  // unknowns: of the matrix, and in `order`

    Parts(const SparseMatrix& matrix, std::vector<Index> dissection, int n_eliminated)
        : order(std::move(dissection)),
          n_all(matrix.n),
          n_interior(n_eliminated),
          n_contact(static_cast<int>(order.size()) - n_eliminated) {
        permute(matrix);
        factor = owned<Factor>(cholmod_l_analyze(stiffness.get(), cholmod.get()), cholmod);
    }

    // Sets `stiffness`, and children before their parents in `order`. Contact unknowns are a chain
    // at the top of the elimination tree: they stay.
    void permute(const SparseMatrix& matrix) {
        const Sparse upper = upper_triangle(matrix, order, cholmod);
        std::vector<Index> place = postorder(*upper, cholmod);
        for (std::size_t k = n_interior; k < place.size(); ++k)
            if (place[k] != static_cast<Index>(k)) std::iota(place.begin(), place.end(), 0);
        stiffness = owned<Sparse>(
            cholmod_l_ptranspose(upper.get(), 2, place.data(), nullptr, 0, cholmod.get()), cholmod);
        for (Index& k : place) k = order[k];
        order = std::move(place);
    }

    void refuse_unfactorised() const {
        if (factor->xtype == CHOLMOD_PATTERN)
            throw std::logic_error("Condensation: not factorised yet");
    }

    // b - A x, all in elimination order, by columns.
    void subtract_product(const cholmod_dense* x, cholmod_dense* b) {
        double minus_one[2] = {-1, 0}, one[2] = {1, 0};
        cholmod_l_sdmult(stiffness.get(), 0, minus_one, one, const_cast<cholmod_dense*>(x), b,
                         cholmod.get());
        cholmod.check();
    }
    Dense solve(cholmod_dense* b, int system = CHOLMOD_A) {
        return owned<Dense>(cholmod_l_solve(system, factor.get(), b, cholmod.get()), cholmod);
    }
    Dense vectors(std::size_t n_columns) {
        const std::size_t n = order.size();
        return owned<Dense>(cholmod_l_allocate_dense(n, n_columns, n, CHOLMOD_REAL, cholmod.get()),
                            cholmod);
    }
};

Condensation::Condensation(const SparseMatrix& stiffness, std::span<const int> node_of_unknown,
                           int n_interior)
    : Condensation(stiffness, dissection_order(stiffness, node_of_unknown, n_interior),
                   n_interior) {}
Condensation::Condensation(const SparseMatrix& stiffness, std::vector<std::int64_t> order,
                           int n_interior)
    : parts_(std::make_unique<Parts>(stiffness, std::move(order), n_interior)) {}
Condensation::Condensation(Condensation&&) noexcept = default;
Condensation::~Condensation() = default;

int Condensation::n() const {
    return parts_->n_all;
}
std::span<const std::int64_t> Condensation::contact() const {
    return std::span(parts_->order).subspan(parts_->n_interior);
}

double Condensation::matrix_bytes() const {
    const auto& matrix = *parts_->stiffness.get();
    return static_cast<double>(matrix.nzmax) * (sizeof(Index) + sizeof(double));
}

double Condensation::predicted_bytes() const {
    const auto& factor = *parts_->factor.get();
    const double n_contact = parts_->n_contact, n = static_cast<double>(factor.n);
    const double values = 8. * static_cast<double>(factor.xsize);
    const double update = 8. * static_cast<double>(factor.maxcsize), maps = 3 * 8. * n;
    return values + std::max(update + maps, 8 * n_contact * n_contact);
}

void Condensation::factorise() {
    auto& [cholmod, order, stiffness, factor, n_all, n_interior, n_contact] = *parts_;
    const OneThread one_thread;
    cholmod_l_factorize(stiffness.get(), factor.get(), cholmod.get());
    cholmod.check();
}

void Condensation::forget_factor() {
    constexpr int ll = 1, supernodal = 1, packed = 1, monotonic = 1;
    cholmod_l_change_factor(CHOLMOD_PATTERN, ll, supernodal, packed, monotonic,
                            parts_->factor.get(), parts_->cholmod.get());
    parts_->cholmod.check();
}

bool Condensation::is_factorised() const {
    return parts_->factor->xtype != CHOLMOD_PATTERN;
}

/// The trailing block of the factor, lower, by columns; the rest zero.
std::vector<double> Condensation::contact_factor() const {
    parts_->refuse_unfactorised();
    const auto [n_supernodes, super, row_start, value_start, row, value] =
        supernodes_of(*parts_->factor);

    const std::size_t n = parts_->n_contact;
    std::vector<double> lower = large_field(n * n);
    for (std::size_t s = 0; s < n_supernodes; ++s) {
        const Index n_rows = row_start[s + 1] - row_start[s];
        for (Index c = std::max<Index>(super[s], parts_->n_interior); c < super[s + 1]; ++c) {
            const Index local = c - super[s];
            const double* column = value + value_start[s] + local * n_rows;
            double* to = lower.data() + (c - parts_->n_interior) * n - parts_->n_interior;
            for (Index r = local; r < n_rows; ++r) to[row[row_start[s] + r]] = column[r];
        }
    }
    return lower;
}

std::vector<double> Condensation::compliance() const {
    const int n = parts_->n_contact;
    std::vector<double> inverse = contact_factor();
    int info = 0;
    if (n > 0) dpotri_("L", &n, inverse.data(), &n, &info);
    if (info != 0)
        throw contact::NotConverged("the condensed stiffness of the contact is singular");
    mirror_lower(inverse, n);
    return inverse;
}

std::vector<double> Condensation::solve(std::span<const double> forces) const {
    parts_->refuse_unfactorised();
    const auto& order = parts_->order;
    const std::size_t n = order.size(), n_all = parts_->n_all, n_columns = forces.size() / n_all;
    const Dense b = parts_->vectors(n_columns);
    auto* const rhs = static_cast<double*>(b->x);
    for (std::size_t c = 0; c < n_columns; ++c)
        for (std::size_t k = 0; k < n; ++k) rhs[c * n + k] = forces[c * n_all + order[k]];
    const Dense x = parts_->solve(b.get());
    parts_->subtract_product(x.get(), b.get());
    const Dense correction = parts_->solve(b.get());

    std::vector<double> solution(forces.size());
    const auto* first = static_cast<const double*>(x->x);
    const auto* second = static_cast<const double*>(correction->x);
    for (std::size_t c = 0; c < n_columns; ++c)
        for (std::size_t k = 0; k < n; ++k)
            solution[c * n_all + order[k]] = first[c * n + k] + second[c * n + k];
    return solution;
}

SingleFactor Condensation::single() const {
    parts_->refuse_unfactorised();
    const auto [n_supernodes, super, row_start, value_start, row, value] =
        supernodes_of(*parts_->factor);

    SingleFactor single({parts_->order.begin(), parts_->order.end()}, parts_->n_interior,
                        parts_->factor->xsize);
    for (std::size_t s = 0; s < n_supernodes; ++s) {
        const std::span<const Index> rows(row + row_start[s], row + row_start[s + 1]);
        for (Index first = super[s], end = 0; first < super[s + 1]; first = end) {
            end = std::min<Index>(first + SingleFactor::widest_panel, super[s + 1]);
            if (first < parts_->n_interior) end = std::min<Index>(end, parts_->n_interior);
            const std::size_t above = first - super[s];
            single.add(static_cast<int>(end - first), rows.subspan(above),
                       value + value_start[s] + above * rows.size() + above, rows.size());
        }
    }
    return single;
}

}  // namespace tricontact::fem
