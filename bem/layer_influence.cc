#include "bem/layer_influence.h"

#include <algorithm>
#include <cmath>

namespace tricontact::bem {

namespace {

const theory::LayerStack& checked(const theory::LayerStack& stack) {
    theory::check(stack);
    return stack;
}

}  // namespace

theory::QuadratureRule cell_rule(double width_over_thickness) {
    const double more = std::min(10., std::ceil(5 * width_over_thickness));
    auto rule = theory::gauss_legendre(2 + static_cast<int>(more));
    for (double& x : rule.points) x -= .5;
    return rule;
}

LayerInfluence::LayerInfluence(const theory::LayerStack& stack,
                               const std::optional<contact::Material>& indenter, double width_x,
                               double width_y, double reach)
    : half_space_({indenter, checked(stack).sheets.front().material}, width_x, width_y),
      kernel_(stack, reach + std::hypot(width_x, width_y) / 2),
      width_x_(width_x),
      width_y_(width_y) {
    const double b = stack.sheets.front().thickness;
    auto rule = cell_rule(std::max(width_x, width_y) / b);
    points_ = std::move(rule.points);
    weights_ = std::move(rule.weights);
}

InfluenceCoefficients LayerInfluence::at(double x, double y) const {
    InfluenceCoefficients sum = half_space_.at(x, y);
    for (std::size_t i = 0; i < points_.size(); ++i)
        for (std::size_t j = 0; j < points_.size(); ++j) {
            const double dx = x - points_[i] * width_x_, dy = y - points_[j] * width_y_;
            const double r = std::hypot(dx, dy);
            const double force = weights_[i] * weights_[j] * width_x_ * width_y_;
            const double cos = r > 0 ? dx / r : 1, sin = r > 0 ? dy / r : 0;
            const auto g = kernel_.at(r);
            const double even = g.deviation * (cos * cos - sin * sin);
            sum.zz += force * g.normal;
            sum.xx += force * (g.mean + even);
            sum.yy += force * (g.mean - even);
            sum.xy += force * g.deviation * 2 * sin * cos;
            const double radial = force * g.coupling;
            sum.xz -= radial * cos;
            sum.yz -= radial * sin;
            sum.zx += radial * cos;
            sum.zy += radial * sin;
        }
    return sum;
}

}  // namespace tricontact::bem
