#include "contact/compliances/active_operator.h"

#include <algorithm>
#include <optional>
#include <span>

#include "contact/base/error.h"
#include "contact/compliances/dense_products.h"
#include "contact/compliances/point_runs.h"
#include "contact/compliances/scattered_points.h"

namespace tricontact::contact {

namespace {

/// By products among all points.
class ProductOperator final : public ActiveOperator {
  public:
    ProductOperator(const Compliance& compliance, const std::vector<std::size_t>& active)
        : compliance_(compliance),
          points_(active, compliance.points().size(), compliance.n_threads()) {}
    void apply(const TangentialField& t, TangentialField& u) const override {
        points_.apply(t, u, [&](const auto& in, auto& out) { compliance_.tangential(in, out); });
    }
    void precondition(const TangentialField& r, TangentialField& z) const override {
        points_.apply(
            r, z, [&](const auto& in, auto& out) { compliance_.precondition_tangential(in, out); });
    }

  private:
    const Compliance& compliance_;
    const ScatteredPoints points_;
};

/// The matrix of the active points by itself: a fraction of all, and small enough to factorise.
/// Its Cholesky factor is the inverse as long as all points stick: in single precision, half the
/// time and memory, since it only preconditions; in double where the matrix is too ill-conditioned.
class DenseOperator final : public ActiveOperator {
  public:
    DenseOperator(const Compliance& compliance, const std::vector<std::size_t>& active,
                  OperatorMemory* memory)
        : n_(active.size()),
          memory_(memory ? *memory : own_memory_),
          in_(2 * n_),
          out_(2 * n_),
          single_in_(2 * n_),
          single_out_(2 * n_) {
        for (const std::size_t i : active) area_.push_back(compliance.points().area[i]);
        gather(compliance, active);
        factorise();
    }

    void apply(const TangentialField& t, TangentialField& u) const override {
        multiply(memory_.lower, 1, in_, out_, t, u);
    }

    void apply_roughly(const TangentialField& t, TangentialField& u) const override {
        multiply(memory_.rough, typical_, single_in_, single_out_, t, u);
    }

    void precondition(const TangentialField& r, TangentialField& z) const override {
        if (exact_)
            solve(*exact_, in_, r, z);
        else
            solve(memory_.inverse, single_in_, r, z);
    }

  private:
    /// Columns of the lower triangle, and of the upper one what multiply_symmetric() reads.
    void gather(const Compliance& compliance, const std::vector<std::size_t>& active) {
        const std::size_t n = compliance.points().size();
        auto& lower = memory_.lower;
        lower.resize(4 * n_ * n_);
        const PointRuns runs(active);
        const auto column = [&](std::size_t l) {
            return compliance.dense() + 3 * n * (l / n_ * n + active[l % n_]);
        };
        for (std::size_t l = 0; l < 2 * n_; ++l) {
            if (l + 2 < 2 * n_) {
                if (l + 2 < n_) runs.prefetch(column(l + 2));
                runs.prefetch(column(l + 2) + n);
            }
            double* const own = lower.data() + 2 * n_ * l;
            if (l < n_ + columns_in_group) runs.gather(column(l), own);
            runs.gather(column(l) + n, own + n_);
            typical_ += own[l] / static_cast<double>(2 * n_);
        }
        memory_.rough.resize(lower.size());
        for (std::size_t l = 0; l < 2 * n_; ++l)
            for (std::size_t k = 2 * n_ * l + first_of_group(l); k < 2 * n_ * (l + 1); ++k)
                memory_.rough[k] = static_cast<float>(lower[k] / typical_);
    }

    /// Held components have zero rows: any number on their diagonal keeps them at zero.
    void factorise() {
        const auto factor = [&](auto& cholesky, const auto& of, double diagonal) {
            return cholesky.extend(2 * n_, [&](std::size_t i, std::size_t j) {
                const auto entry = of[2 * n_ * j + i];
                return i == j && entry == 0 ? diagonal : entry;
            });
        };
        memory_.inverse.clear();
        if (factor(memory_.inverse, memory_.rough, 1)) return;
        exact_.emplace();
        if (!factor(*exact_, memory_.lower, typical_))
            throw NotConverged("tangential contact: the compliance is not positive definite");
    }

    template <class Real>
    void multiply(const std::vector<Real>& lower, double scale, std::vector<Real>& in,
                  std::vector<Real>& out, const TangentialField& t, TangentialField& u) const {
        for (std::size_t k = 0; k < n_; ++k) {
            in[k] = static_cast<Real>(area_[k] * t.x[k]);
            in[n_ + k] = static_cast<Real>(area_[k] * t.y[k]);
        }
        multiply_symmetric({lower.data(), 2 * n_}, std::span<const Real>(in), std::span(out));
        for (std::size_t k = 0; k < n_; ++k) u.set(k, scale * Vector2{out[k], out[n_ + k]});
    }

    template <class Real>
    void solve(const Cholesky<Real>& factor, std::vector<Real>& x, const TangentialField& r,
               TangentialField& z) const {
        for (std::size_t k = 0; k < n_; ++k) {
            x[k] = static_cast<Real>(r.x[k]);
            x[n_ + k] = static_cast<Real>(r.y[k]);
        }
        factor.solve(x);
        for (std::size_t k = 0; k < n_; ++k) z.set(k, Vector2{x[k], x[n_ + k]} / area_[k]);
    }

    OperatorMemory own_memory_;
    const std::size_t n_;
    // Displacement over force: [m/N], and over a typical one of the diagonal in single precision.
    OperatorMemory& memory_;
    double typical_ = 0;
    std::vector<double> area_;               // of the active points [m^2]
    std::optional<Cholesky<double>> exact_;  // where that in single precision fails
    mutable std::vector<double> in_, out_;
    mutable std::vector<float> single_in_, single_out_;
};

}  // namespace

std::unique_ptr<const ActiveOperator> make_active_operator(const Compliance& compliance,
                                                           const std::vector<std::size_t>& active,
                                                           OperatorMemory* memory) {
    if (compliance.dense()) return std::make_unique<DenseOperator>(compliance, active, memory);
    if (auto products = compliance.among(active)) return products;
    return std::make_unique<ProductOperator>(compliance, active);
}

}  // namespace tricontact::contact
