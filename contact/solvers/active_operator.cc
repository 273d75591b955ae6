#include "contact/solvers/active_operator.h"

#include <algorithm>
#include <optional>

#include "contact/error.h"

namespace tricontact::contact {

namespace {

/// By products among all points.
class ProductOperator final : public ActiveOperator {
  public:
    ProductOperator(const Compliance& compliance, const std::vector<std::size_t>& active)
        : compliance_(compliance),
          active_(active),
          in_(compliance.points().size()),
          out_(compliance.points().size()) {}
    void apply(const TangentialField& t, TangentialField& u) const override {
        scatter(t);
        compliance_.tangential(in_, out_);
        gather(u);
    }
    void precondition(const TangentialField& r, TangentialField& z) const override {
        scatter(r);
        compliance_.precondition_tangential(in_, out_);
        gather(z);
    }

  private:
    void scatter(const TangentialField& f) const {
        for (std::size_t k = 0; k < active_.size(); ++k) in_.set(active_[k], f.at(k));
    }
    void gather(TangentialField& f) const {
        for (std::size_t k = 0; k < active_.size(); ++k) f.set(k, out_.at(active_[k]));
    }

    const Compliance& compliance_;
    const std::vector<std::size_t> active_;
    mutable TangentialField in_, out_;
};

/// The matrix of the active points by itself: a fraction of all, and small enough to factorise.
/// Its Cholesky factor is the inverse as long as all points stick: in single precision, half the
/// time and memory, since it only preconditions; in double where the matrix is too ill-conditioned.
class DenseOperator final : public ActiveOperator {
  public:
    DenseOperator(const Compliance& compliance, const std::vector<std::size_t>& active,
                  OperatorMemory* memory)
        : n_(active.size()),
          stride_(2 * n_),
          lower_(memory ? memory->lower : own_memory_.lower),
          inverse_(memory ? memory->inverse : own_memory_.inverse),
          in_(stride_),
          out_(stride_),
          single_(stride_) {
        lower_.resize(stride_ * stride_);
        const std::size_t n = compliance.points().size();
        const double* const all = compliance.dense();
        for (std::size_t l = 0; l < 2 * n_; ++l) {
            const double* const column = all + 3 * n * (l / n_ * n + active[l % n_]);
            double* const own = lower_.data() + stride_ * l;
            if (l < n_)
                for (std::size_t k = l; k < n_; ++k) own[k] = column[active[k]];
            for (std::size_t k = l < n_ ? 0 : l - n_; k < n_; ++k)
                own[n_ + k] = column[n + active[k]];
        }
        for (const std::size_t i : active) area_.push_back(compliance.points().area[i]);
        factorise();
    }

    void apply(const TangentialField& t, TangentialField& u) const override {
        for (std::size_t k = 0; k < n_; ++k) {
            in_[k] = area_[k] * t.x[k];
            in_[n_ + k] = area_[k] * t.y[k];
        }
        multiply_symmetric({lower_.data(), stride_}, in_, out_);
        std::copy_n(out_.begin(), n_, u.x.begin());
        std::copy_n(out_.begin() + static_cast<std::ptrdiff_t>(n_), n_, u.y.begin());
    }

    void precondition(const TangentialField& r, TangentialField& z) const override {
        if (exact_)
            solve(*exact_, out_, r, z);
        else
            solve(inverse_, single_, r, z);
    }

  private:
    /// Held components have zero rows: any number on their diagonal keeps them at zero.
    void factorise() {
        const auto diagonal = [&](std::size_t k) { return lower_[stride_ * k + k]; };
        for (std::size_t k = 0; k < 2 * n_; ++k)
            typical_ += diagonal(k) / static_cast<double>(2 * n_);
        const auto entry = [&](std::size_t i, std::size_t j) {
            return i == j && diagonal(i) == 0 ? 1 : lower_[stride_ * j + i] / typical_;
        };
        inverse_.clear();
        if (inverse_.extend(2 * n_, entry)) return;
        exact_.emplace();
        if (!exact_->extend(2 * n_, entry))
            throw NotConverged("tangential contact: the compliance is not positive definite");
    }

    template <class Real>
    void solve(const Cholesky<Real>& factor, std::vector<Real>& x, const TangentialField& r,
               TangentialField& z) const {
        for (std::size_t k = 0; k < n_; ++k) {
            x[k] = static_cast<Real>(r.x[k]);
            x[n_ + k] = static_cast<Real>(r.y[k]);
        }
        factor.solve(x);
        for (std::size_t k = 0; k < n_; ++k)
            z.set(k, Vector2{x[k], x[n_ + k]} / (typical_ * area_[k]));
    }

    OperatorMemory own_memory_;
    const std::size_t n_, stride_;
    std::vector<double>& lower_;  // triangle by columns, displacement over force [m/N]
    std::vector<double> area_;    // of the active points [m^2]
    double typical_ = 0;          // of the diagonal; factors are of the matrix over it
    Cholesky<float>& inverse_;
    std::optional<Cholesky<double>> exact_;  // where that fails
    mutable std::vector<double> in_, out_;
    mutable std::vector<float> single_;
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
