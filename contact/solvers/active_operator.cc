#include "contact/solvers/active_operator.h"

#include <Eigen/Dense>

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
/// Its Cholesky factor is the exact inverse as long as all points stick.
class DenseOperator final : public ActiveOperator {
  public:
    DenseOperator(const Compliance& compliance, const std::vector<std::size_t>& active)
        : active_(active),
          area_(compliance.points().area),
          matrix_(2 * active.size(), 2 * active.size()),
          in_(2 * active.size()),
          out_(2 * active.size()) {
        const std::size_t n = area_.size(), m = active_.size();
        const double* const all = compliance.dense();
        for (std::size_t l = 0; l < 2 * m; ++l) {
            const double* const column = all + 3 * n * (l / m * n + active_[l % m]);
            for (std::size_t k = 0; k < 2 * m; ++k)
                matrix_(k, l) = column[k / m * n + active_[k % m]];
        }
        factorise();
    }

    void apply(const TangentialField& t, TangentialField& u) const override {
        gather(t, true);
        out_.noalias() = matrix_.selfadjointView<Eigen::Lower>() * in_;
        scatter(u);
    }

    void precondition(const TangentialField& r, TangentialField& z) const override {
        gather(r, false);
        out_ = factor_.solve(in_);
        const std::size_t m = active_.size();
        for (std::size_t k = 0; k < m; ++k)
            for (std::size_t c = 0; c < 2; ++c) out_[c * m + k] /= area_[active_[k]];
        scatter(z);
    }

  private:
    /// Held components have zero rows: any number on their diagonal keeps them at zero.
    void factorise() {
        Eigen::MatrixXd regular = matrix_;
        const double typical = regular.diagonal().mean();
        for (Eigen::Index k = 0; k < regular.rows(); ++k)
            if (regular(k, k) == 0) regular(k, k) = typical;
        factor_.compute(regular);
        if (factor_.info() != Eigen::Success)
            throw NotConverged("tangential contact: the compliance is not positive definite");
    }

    void gather(const TangentialField& f, bool times_area) const {
        const std::size_t m = active_.size();
        for (std::size_t k = 0; k < m; ++k) {
            const double factor = times_area ? area_[active_[k]] : 1;
            in_[k] = factor * f.x[k];
            in_[m + k] = factor * f.y[k];
        }
    }

    void scatter(TangentialField& f) const {
        const std::size_t m = active_.size();
        for (std::size_t k = 0; k < m; ++k) {
            f.x[k] = out_[k];
            f.y[k] = out_[m + k];
        }
    }

    const std::vector<std::size_t> active_;
    const std::vector<double>& area_;
    Eigen::MatrixXd matrix_;  // displacement over force
    Eigen::LLT<Eigen::MatrixXd> factor_;
    mutable Eigen::VectorXd in_, out_;
};

}  // namespace

std::unique_ptr<const ActiveOperator> make_active_operator(const Compliance& compliance,
                                                           const std::vector<std::size_t>& active) {
    if (compliance.dense()) return std::make_unique<DenseOperator>(compliance, active);
    if (auto products = compliance.among(active)) return products;
    return std::make_unique<ProductOperator>(compliance, active);
}

}  // namespace tricontact::contact
