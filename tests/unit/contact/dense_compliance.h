#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "contact/compliances/compliance.h"

namespace tricontact::contact_test {

/// Softened Boussinesq and Cerruti kernels between scattered points of unequal areas, as dense
/// matrices: what a condensed finite element surface would look like. Displacements per force are
/// symmetric; per traction they are so only in the inner product weighted by the areas.
class DenseCompliance final : public contact::Compliance {
  public:
    static constexpr double nu = .3;

    /// `n` points in [-1, 1]^2, areas between .5 and 2 of the mean.
    DenseCompliance(int n, unsigned seed) {
        std::mt19937 random(seed);
        // No std distribution: those differ between libraries.
        auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
        for (int i = 0; i < n; ++i) {
            points_.x.push_back(2 * uniform() - 1);
            points_.y.push_back(2 * uniform() - 1);
            points_.area.push_back((.5 + 1.5 * uniform()) * 4 / n);
        }
        fill_matrices(n);
    }

    const contact::ContactPoints& points() const override { return points_; }
    bool is_coupled() const override { return false; }
    void normal(std::span<const double> p, std::span<double> u_z) const override {
        const int n = size();
        const Eigen::VectorXd u = normal_ * weights().cwiseProduct(map(p));
        std::copy_n(u.data(), n, u_z.data());
    }
    void tangential(const contact::TangentialField& t, contact::TangentialField& u) const override {
        unstack(tangential_ * weights2().cwiseProduct(stack(t)), u);
    }
    double local_tangential() const override {
        return tangential_.diagonal().mean() * weights().mean();
    }
    void precondition_tangential(const contact::TangentialField& r,
                                 contact::TangentialField& z) const override {
        unstack(stack(r).cwiseQuotient(tangential_.diagonal().cwiseProduct(weights2())), z);
    }

    int size() const { return static_cast<int>(points_.size()); }
    /// Displacement per force [m/N], 2n x 2n, x components first.
    const Eigen::MatrixXd& tangential_matrix() const { return tangential_; }
    Eigen::VectorXd weights2() const {
        Eigen::VectorXd w(2 * size());
        w << weights(), weights();
        return w;
    }
    static Eigen::VectorXd stack(const contact::TangentialField& f) {
        Eigen::VectorXd v(2 * f.x.size());
        v << map(f.x), map(f.y);
        return v;
    }
    static void unstack(const Eigen::VectorXd& v, contact::TangentialField& f) {
        const auto n = v.size() / 2;
        f.x.assign(v.data(), v.data() + n);
        f.y.assign(v.data() + n, v.data() + 2 * n);
    }

  private:
    static Eigen::VectorXd map(std::span<const double> v) {
        return Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size()));
    }
    Eigen::VectorXd weights() const { return map(points_.area); }

    void fill_matrices(int n) {
        normal_.resize(n, n);
        tangential_.resize(2 * n, 2 * n);
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                const double x = points_.x[i] - points_.x[j], y = points_.y[i] - points_.y[j];
                // softened more at the diagonal, which makes it dominant enough
                const double s = std::sqrt(x * x + y * y + (i == j ? .0025 : .01));
                normal_(i, j) = 1 / s;
                tangential_(i, j) = (1 - nu) / s + nu * x * x / (s * s * s);
                tangential_(n + i, n + j) = (1 - nu) / s + nu * y * y / (s * s * s);
                tangential_(i, n + j) = tangential_(n + j, i) = nu * x * y / (s * s * s);
            }
    }

    contact::ContactPoints points_;
    Eigen::MatrixXd normal_, tangential_;
};

}  // namespace tricontact::contact_test
