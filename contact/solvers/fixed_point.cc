#include "contact/solvers/fixed_point.h"

#include <algorithm>
#include <cmath>

// Anderson's acceleration of x = g(x) with r = g(x) - x. From the last m changes of r and g, dr_j
// and dg_j, and a damping b:
//
//   gamma = argmin |r - sum gamma_j dr_j|,   x_next = x + b r - sum gamma_j (dg_j - (1 - b) dr_j)
//
// since the change of x is dg - dr. Of linear g these are the iterates of GMRES (Walker and Ni
// 2011), which is why an iteration with factors above 1 in modulus may converge. The least squares
// are solved by a complete orthogonal decomposition: changes that repeat each other leave the
// matrix without full rank.

namespace tricontact::contact {

namespace {
constexpr std::size_t most_remembered = 12;  // iterates
constexpr double much_grown = 4;             // over the least residual so far
constexpr double least_damping = .05;
}  // namespace

std::vector<double> FixedPoint::next(const std::vector<double>& x, const std::vector<double>& g,
                                     double residual) {
    const auto n = static_cast<Eigen::Index>(x.size());
    Eigen::VectorXd r(n), image(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const bool finite = std::isfinite(x[i]) && std::isfinite(g[i]);
        r[i] = finite ? g[i] - x[i] : 0;
        image[i] = finite ? g[i] : 0;
    }
    const bool first = last_residual_.size() == 0;
    if (!first) {
        changes_.push_back({r - last_residual_, image - last_image_});
        if (changes_.size() > most_remembered) changes_.pop_front();
    }
    if (!first && !(residual <= much_grown * least_)) {
        changes_.clear();
        damping_ = std::max(least_damping, damping_ / 2);
    }
    least_ = first ? residual : std::min(least_, residual);
    last_residual_ = r;
    last_image_ = image;

    Eigen::VectorXd step = image - (1 - damping_) * r;  // x + damping (g - x)
    if (!changes_.empty()) {
        const auto m = static_cast<Eigen::Index>(changes_.size());
        Eigen::MatrixXd residuals(n, m);
        for (Eigen::Index k = 0; k < m; ++k) residuals.col(k) = changes_[k].residual;
        // Of less than full rank when the last steps went the same way. Decomposed in its place.
        const Eigen::CompleteOrthogonalDecomposition<Eigen::Ref<Eigen::MatrixXd>> qr(residuals);
        const Eigen::VectorXd gamma = qr.solve(r);
        for (Eigen::Index k = 0; k < m; ++k)
            step -= gamma[k] * (changes_[k].image - (1 - damping_) * changes_[k].residual);
    }
    std::vector<double> result = g;
    for (Eigen::Index i = 0; i < n; ++i)
        if (std::isfinite(x[i]) && std::isfinite(g[i])) result[i] = step[i];
    return result;
}

}  // namespace tricontact::contact
