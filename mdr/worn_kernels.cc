#include "mdr/worn_kernels.h"

#include <Eigen/LU>
#include <cmath>
#include <numbers>

namespace tricontact::mdr {

using std::numbers::pi;

WornKernels::WornKernels(int n, double h, double c)
    : image(Eigen::MatrixXd::Zero(n, n)), pressure(image), slip(image) {
    const auto rho = [&](int j) { return j * h; };
    const auto x = [&](int j) { return std::hypot(c, rho(j)); };
    const auto root = [&](int j, int k) {
        return std::sqrt((rho(j) - rho(k)) * (rho(j) + rho(k)));
    };
    if (c == 0) slip(0, 0) = 1;
    for (int j = 0; j < n; ++j) {
        for (int k = 0; k < j; ++k) {
            // ∫ dx and x^2 dx over sqrt(r^2 - x^2), r = x_j
            const double arc = std::asin(x(k + 1) / x(j)) - std::asin(x(k) / x(j));
            const double square =
                (x(j) * x(j) * arc - x(k + 1) * root(j, k + 1) + x(k) * root(j, k)) / 2;
            const double upper =
                (square - x(k) * x(k) * arc) / ((rho(k + 1) - rho(k)) * (rho(k + 1) + rho(k)));
            slip(j, k) += 2 / pi * (arc - upper);
            slip(j, k + 1) += 2 / pi * upper;
        }
        for (int k = j; k + 1 < n; ++k) {
            // ∫ drho/sqrt(rho^2 - rho_j^2); about the axis q is a parabola, see abel_weights()
            const double weight =
                j > 0   ? std::acosh(rho(k + 1) / rho(j)) - std::acosh(rho(k) / rho(j))
                : k > 0 ? std::log(rho(k + 1) / rho(k))
                        : 2;
            pressure(j, k + 1) -= weight / h / pi;
            pressure(j, k) += weight / h / pi;
        }
    }
    image = slip;
    if (c > 0) {
        // The worn depth at c is 0 whatever g is there: g goes on as its neighbours have it.
        image.row(0).setZero();
        image.row(0).head(3) << 3, -4, 1;
    }
    image = Eigen::MatrixXd(image.inverse());
    if (c > 0) image.col(0).setZero();
    if (c > 0) pressure.row(0) = pressure.row(1);  // infinite, where nothing slips
}

}  // namespace tricontact::mdr
