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
    Eigen::MatrixXd basis(b.size(), 32);
    basis.col(0) = b / size;
    Eigen::MatrixXd triangle = Eigen::MatrixXd::Zero(max_iterations + 1, max_iterations);
    Eigen::VectorXd residual = Eigen::VectorXd::Zero(max_iterations + 1);
    residual[0] = size;
    std::vector<Eigen::JacobiRotation<double>> rotations;
    int k = 0;
    while (k < max_iterations && std::abs(residual[k]) > tolerance * size) {
        if (k + 1 == basis.cols()) basis.conservativeResize(Eigen::NoChange, 2 * basis.cols());
        Eigen::VectorXd w = product(precondition(basis.col(k)));
        const double whole = w.norm();
        auto column = triangle.col(k);
        double before = whole;
        for (int pass = 0; pass < 2; ++pass) {  // Gram and Schmidt's; once loses orthogonality
            const Eigen::VectorXd along = basis.leftCols(k + 1).transpose() * w;
            w.noalias() -= basis.leftCols(k + 1) * along;
            column.head(k + 1) += along;
            const double after = w.norm();
            if (after > .7 * before) break;  // hardly any was lost (Daniel et al. 1976)
            before = after;
        }
        column[k + 1] = w.norm();
        const bool exhausted = column[k + 1] <= 1e-14 * whole;  // the rest is rounding
        basis.col(k + 1) = w / column[k + 1];
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
    const Eigen::VectorXd sum = basis.leftCols(k) * y;
    return {precondition(sum), std::abs(residual[k]) / size, k};
}

}  // namespace tricontact::rolling
