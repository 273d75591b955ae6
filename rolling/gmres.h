#pragma once

#include <Eigen/Dense>
#include <vector>

namespace tricontact::rolling {

/// Generalised minimal residuals (Saad and Schultz 1986), preconditioned from the right and without
/// restarts, for a matrix known by its `product`. Eigen's own wants a sparse matrix' interface.
/// Ends with |b - A x| <= tolerance |b|, or with the best of `max_iterations`.
struct GmresResult {
    Eigen::VectorXd x;
    double residual = 0;  ///< |b - A x|/|b|
    int iterations = 0;
};
template <class Product, class Precondition>
GmresResult gmres(const Product& product, const Precondition& precondition,
                  const Eigen::VectorXd& b, double tolerance, int max_iterations) {
    const double size = b.norm();
    if (!(size > 0)) return {Eigen::VectorXd::Zero(b.size())};
    std::vector<Eigen::VectorXd> basis = {b / size};
    Eigen::MatrixXd triangle = Eigen::MatrixXd::Zero(max_iterations + 1, max_iterations);
    Eigen::VectorXd residual = Eigen::VectorXd::Zero(max_iterations + 1);
    residual[0] = size;
    std::vector<Eigen::JacobiRotation<double>> rotations;
    int k = 0;
    while (k < max_iterations && std::abs(residual[k]) > tolerance * size) {
        Eigen::VectorXd w = product(precondition(basis[k]));
        const double whole = w.norm();
        auto column = triangle.col(k);
        for (int pass = 0; pass < 2; ++pass)  // once loses orthogonality
            for (int i = 0; i <= k; ++i) {
                const double along = w.dot(basis[i]);
                column[i] += along;
                w -= along * basis[i];
            }
        column[k + 1] = w.norm();
        const bool exhausted = column[k + 1] <= 1e-14 * whole;  // the rest is rounding
        basis.push_back(w / column[k + 1]);
        for (int i = 0; i < k; ++i) column.applyOnTheLeft(i, i + 1, rotations[i].adjoint());
        rotations.emplace_back();
        rotations[k].makeGivens(column[k], column[k + 1]);
        column.applyOnTheLeft(k, k + 1, rotations[k].adjoint());
        residual.applyOnTheLeft(k, k + 1, rotations[k].adjoint());
        ++k;
        if (exhausted) break;
    }
    const Eigen::VectorXd y =
        triangle.topLeftCorner(k, k).triangularView<Eigen::Upper>().solve(residual.head(k));
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(b.size());
    for (int i = 0; i < k; ++i) sum += y[i] * basis[i];
    return {precondition(sum), std::abs(residual[k]) / size, k};
}

}  // namespace tricontact::rolling
