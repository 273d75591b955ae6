#include "theory/layer/layer_equation.h"

#include <fmt/format.h>

#include <numbers>
#include <utility>

#include "contact/error.h"
#include "contact/special_values.h"

namespace tricontact::theory {

namespace {

using std::numbers::pi;
Eigen::Map<const Eigen::VectorXd> vector(const std::vector<double>& v) {
    return {v.data(), static_cast<Eigen::Index>(v.size())};
}

}  // namespace

LayerEquation::LayerEquation(const ElasticLayer& layer, LineMesh mesh)
    : layer_(layer), mesh_(std::move(mesh)) {
    check(layer);
    const QuadratureRule waves = wave_number_rule(mesh_.radius() / layer.thickness);
    wave_ = vector(waves.points);
    wave_weights_ = vector(waves.weights);
    kernel_.resize(wave_.size());
    for (int m = 0; m < wave_.size(); ++m)
        kernel_[m] = 2 / (pi * layer.thickness) * wave_weights_[m] *
                     half_space_deficit(layer.material.poisson, layer.base, wave_[m]).normal;
    cosines_.resize(wave_.size(), mesh_.size());
    for (int i = 0; i < mesh_.size(); ++i) cosines_.col(i) = cosines(mesh_.positions()[i]);

    // Symmetric in the unknowns sqrt(weight) q.
    const Eigen::VectorXd root = vector(mesh_.weights()).cwiseSqrt();
    const Eigen::MatrixXd v =
        root.asDiagonal() * cosines_.transpose() * kernel_.cwiseSqrt().asDiagonal();
    Eigen::MatrixXd a = Eigen::MatrixXd::Identity(mesh_.size(), mesh_.size());
    a.selfadjointView<Eigen::Lower>().rankUpdate(v, -1);
    factor_.compute(a);
    if (factor_.info() != Eigen::Success)
        throw contact::NotConverged(
            fmt::format("layer: {} points do not resolve a contact of a/b = {:.6g}; use more",
                        mesh_.size(), mesh_.radius() / layer.thickness));
}

Eigen::VectorXd LayerEquation::cosines(double x) const {
    return (wave_ * (x / layer_.thickness)).array().cos();
}

LayerEquation::Solution LayerEquation::solve(const std::vector<double>& g, double g_edge) const {
    const auto weights = vector(mesh_.weights());
    const Eigen::VectorXd root = weights.cwiseSqrt();
    const Eigen::VectorXd q = factor_.solve(root.cwiseProduct(vector(g))).cwiseQuotient(root);
    const Eigen::VectorXd transform = cosines_ * weights.cwiseProduct(q);
    const double edge = g_edge + cosines(mesh_.radius()).cwiseProduct(kernel_).dot(transform);
    return {{q.begin(), q.end()}, edge, weights.dot(q)};
}

double LayerEquation::centre_shift(const std::vector<double>& q) const {
    if (layer_.base == LayerBase::frictionless) return contact::infinity;
    const double nu = layer_.material.poisson, shear_modulus = layer_.material.shear_modulus();
    const Eigen::VectorXd transform = cosines_ * vector(mesh_.weights()).cwiseProduct(vector(q));
    double missing = 0;  // G times the integral: k D11 = -(1 - nu)/G deficit, k D22 = -deficit/G
    for (int m = 0; m < wave_.size(); ++m) {
        const auto deficit = half_space_deficit(nu, layer_.base, wave_[m]);
        missing += wave_weights_[m] * ((1 - nu) * deficit.along + deficit.across) / 2 *
                   transform[m] / (pi * layer_.thickness);
    }
    const double centre = LineLoad(mesh_, q).value(0);
    return ((2 - nu) * centre / 4 - missing) / shear_modulus;
}

}  // namespace tricontact::theory
