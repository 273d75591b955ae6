#include "theory/layer/wave_numbers.h"

#include <algorithm>
#include <cmath>

namespace tricontact::theory {

namespace {

constexpr double end_of_deficit = 24;  // in k b
constexpr int points_per_panel = 30;

}  // namespace

// 30 Gauss points per panel. The poles of the deficit lie at |Im x| >= 0.739 (cos y = y): a panel
// of width 2 leaves 3^-60 or less; cos(kx) cos(kt) turns by 2 a/b per unit of x: a panel may hold a
// phase of 48, the last at which 30 points keep full precision.
QuadratureRule wave_number_rule(double radius_over_thickness) {
    const QuadratureRule panel = gauss_legendre(points_per_panel);
    const double widest = std::min(2., 24 / radius_over_thickness);
    const int n_panels = static_cast<int>(std::ceil(end_of_deficit / widest));
    const double width = end_of_deficit / n_panels;
    QuadratureRule rule;
    for (int p = 0; p < n_panels; ++p)
        for (std::size_t i = 0; i < panel.points.size(); ++i) {
            rule.points.push_back(width * (p + panel.points[i]));
            rule.weights.push_back(width * panel.weights[i]);
        }
    return rule;
}

}  // namespace tricontact::theory
