#include "theory/layer/layer_equation.h"

#include <fmt/format.h>

#include <numbers>
#include <utility>

#include "contact/base/error.h"
#include "contact/base/special_values.h"

namespace tricontact::theory {

namespace {

using std::numbers::pi;
Eigen::Map<const Eigen::VectorXd> vector(const std::vector<double>& v) {
    return {v.data(), static_cast<Eigen::Index>(v.size())};
}

const ElasticLayer& checked(const ElasticLayer& layer) {
    check(layer);
    return layer;
}

}  // namespace

LayerEquation::LayerEquation(const ElasticLayer& layer, LineMesh mesh)
    : layer_(checked(layer)),
      mesh_(std::move(mesh)),
      waves_(mesh_.radius() / layer.thickness),
      kernel_(waves_.size()),
      cosines_(waves_.size(), mesh_.size()) {
    for (Eigen::Index m = 0; m < waves_.size(); ++m)
        kernel_[m] =
            2 / (pi * layer.thickness) * waves_.weights()[m] *
            half_space_deficit(layer.material.poisson, layer.base, waves_.points()[m]).normal;
    for (int i = 0; i < mesh_.size(); ++i)
        cosines_.col(i) = waves_.cosines(mesh_.positions()[i] / layer.thickness);

    // Symmetric in the unknowns sqrt(weight) q.
    const Eigen::VectorXd root = vector(mesh_.weights()).cwiseSqrt();
    const Eigen::MatrixXd v = kernel_.cwiseSqrt().asDiagonal() * cosines_ * root.asDiagonal();
    Eigen::MatrixXd a = Eigen::MatrixXd::Identity(mesh_.size(), mesh_.size());
    a.selfadjointView<Eigen::Lower>().rankUpdate(v.transpose(), -1);
    factor_.compute(a);
    if (factor_.info() != Eigen::Success)
        throw contact::NotConverged(
            fmt::format("layer: {} points do not resolve a contact of a/b = {:.6g}; use more",
                        mesh_.size(), mesh_.radius() / layer.thickness));
}

LayerEquation::Solution LayerEquation::solve(const std::vector<double>& g, double g_edge) const {
    const auto weights = vector(mesh_.weights());
    const Eigen::VectorXd root = weights.cwiseSqrt();
    const Eigen::VectorXd q = factor_.solve(root.cwiseProduct(vector(g))).cwiseQuotient(root);
    const Eigen::VectorXd transform = cosines_ * weights.cwiseProduct(q);
    const double edge =
        g_edge +
        waves_.cosines(mesh_.radius() / layer_.thickness).cwiseProduct(kernel_).dot(transform);
    return {{q.begin(), q.end()}, edge, weights.dot(q)};
}

double LayerEquation::centre_shift(const std::vector<double>& q) const {
    if (layer_.base == LayerBase::frictionless) return contact::infinity;
    const double nu = layer_.material.poisson, shear_modulus = layer_.material.shear_modulus();
    const Eigen::VectorXd transform = cosines_ * vector(mesh_.weights()).cwiseProduct(vector(q));
    double missing = 0;  // G times the integral: k D11 = -(1 - nu)/G deficit, k D22 = -deficit/G
    for (int m = 0; m < waves_.size(); ++m) {
        const auto deficit = half_space_deficit(nu, layer_.base, waves_.points()[m]);
        missing += waves_.weights()[m] * ((1 - nu) * deficit.along + deficit.across) / 2 *
                   transform[m] / (pi * layer_.thickness);
    }
    const double centre = LineLoad(mesh_, q).value(0);
    return ((2 - nu) * centre / 4 - missing) / shear_modulus;
}

}  // namespace tricontact::theory
