#include "theory/layer/wave_numbers.h"

#include <algorithm>
#include <cmath>

#include "contact/base/gauss_legendre.h"

namespace tricontact::theory {

namespace {

constexpr double end_of_deficit = 24;  // in k b
constexpr int points_per_panel = 30;

Eigen::Index panels(double radius_over_thickness) {
    const double widest = std::min(2., 24 / radius_over_thickness);
    return static_cast<Eigen::Index>(std::ceil(end_of_deficit / widest));
}

}  // namespace

// 30 Gauss points per panel. The poles of the deficit lie at |Im x| >= 0.739 (cos y = y): a panel
// of width 2 leaves 3^-60 or less; cos(kx) cos(kt) turns by 2 a/b per unit of x: a panel may hold a
// phase of 48, the last at which 30 points keep full precision.
WaveNumbers::WaveNumbers(double radius_over_thickness)
    : n_panels_(panels(radius_over_thickness)),
      width_(end_of_deficit / static_cast<double>(n_panels_)),
      points_(n_panels_ * points_per_panel),
      weights_(points_.size()) {
    const contact::QuadratureRule& panel = contact::gauss_legendre(points_per_panel);
    const Eigen::Map<const Eigen::VectorXd> points(panel.points.data(), points_per_panel),
        weights(panel.weights.data(), points_per_panel);
    for (Eigen::Index p = 0; p < n_panels_; ++p) {
        points_.segment(p * points_per_panel, points_per_panel) =
            width_ * (static_cast<double>(p) + points.array());
        weights_.segment(p * points_per_panel, points_per_panel) = width_ * weights;
    }
}

// Panels are alike: exp(ixt) is that of the panel's begin times that of the place within.
Eigen::VectorXd WaveNumbers::cosines(double t) const {
    const Eigen::ArrayXd within = points_.head(points_per_panel).array() * t;
    const Eigen::VectorXd cosine = within.cos(), sine = within.sin();
    Eigen::VectorXd result(size());
    for (Eigen::Index p = 0; p < n_panels_; ++p) {
        const double begin = static_cast<double>(p) * width_ * t;
        result.segment(p * points_per_panel, points_per_panel) =
            std::cos(begin) * cosine - std::sin(begin) * sine;
    }
    return result;
}

}  // namespace tricontact::theory
