#include "contact/contact_radius.h"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "contact/error.h"

namespace tricontact::contact {

double contact_radius(const ContactPoints& points, const std::vector<double>& pressure,
                      const Vector2& centre) {
    double area = 0;
    for (std::size_t i = 0; i < pressure.size(); ++i)
        if (pressure[i] > 0) area += points.area[i];
    const double counted = std::sqrt(area / std::numbers::pi);

    // Normal equations in s = (r / counted)^2, four terms: well conditioned on [0.25, 0.81].
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    Eigen::Vector4d rhs = Eigen::Vector4d::Zero();
    int n = 0;
    for (std::size_t i = 0; i < pressure.size(); ++i) {
        const double r = std::hypot(points.x[i] - centre[0], points.y[i] - centre[1]) / counted;
        if (!(pressure[i] > 0) || r < 0.5 || r > 0.9) continue;
        const double s = r * r;
        const Eigen::Vector4d basis(1, s, s * s, s * s * s);
        matrix += points.area[i] * basis * basis.transpose();
        rhs += points.area[i] * pressure[i] * pressure[i] * basis;
        ++n;
    }
    if (n < 20) return counted;
    const Eigen::Vector4d c = matrix.ldlt().solve(rhs);

    double s = 1;  // Newton from the counted radius
    for (int k = 0; k < 30; ++k) {
        const double value = c[0] + s * (c[1] + s * (c[2] + s * c[3]));
        const double slope = c[1] + s * (2 * c[2] + s * 3 * c[3]);
        s -= value / slope;
    }
    return std::abs(s - 1) < 0.3 ? counted * std::sqrt(s) : counted;
}

}  // namespace tricontact::contact
