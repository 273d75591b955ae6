#include "bem/interior_influence.h"

#include <algorithm>
#include <cmath>

#include "bem/layer_influence.h"
#include "bem/layer_interior_kernel.h"

namespace tricontact::bem {

namespace {

using theory::HarmonicDerivatives;
using theory::InteriorResponse;

/// ln(s + r) and 1/(s + r) of r = sqrt(s^2 + rest^2), without cancellation where s < 0.
struct Sum {
    Sum(double s, double r, double rest_squared) {
        const double sum = s < 0 ? rest_squared / (r - s) : s + r;
        logarithm = std::log(sum);
        inverse = 1 / sum;
    }
    double logarithm, inverse;
};

/// Antiderivatives of L_xx in x and y: atan(y/x) - atan(y z/(x r)), as one angle.
double angle(double x, double y, double z, double r) {
    return std::atan2(x * y * (x * x + y * y), (r + z) * (x * x * r + y * y * z));
}

/// Antiderivatives in x and y of the derivatives of L and M; what cancels between the corners of a
/// rectangle is left out.
HarmonicDerivatives corner(double x, double y, double z) {
    using namespace theory;
    const double r = std::sqrt(x * x + y * y + z * z);
    const Sum xr(x, r, y * y + z * z), yr(y, r, x * x + z * z), zr(z, r, x * x + y * y);
    const double solid = std::atan2(x * y, z * r);
    const double angle_x = angle(x, y, z, r), angle_y = angle(y, x, z, r);
    HarmonicDerivatives c{};
    c[L_x] = y * zr.logarithm + z * yr.logarithm + x * angle_x;
    c[L_y] = x * zr.logarithm + z * xr.logarithm + y * angle_y;
    c[L_z] = x * yr.logarithm + y * xr.logarithm - z * solid;
    c[L_xx] = angle_x;
    c[L_xy] = zr.logarithm;
    c[L_yy] = angle_y;
    c[L_xz] = yr.logarithm;
    c[L_yz] = xr.logarithm;
    c[L_xxx] = -(y * zr.inverse + z * yr.inverse) / r;
    c[L_xxy] = x * zr.inverse / r;
    c[L_xyy] = y * zr.inverse / r;
    c[L_yyy] = -(x * zr.inverse + z * xr.inverse) / r;
    c[L_xxz] = x * yr.inverse / r;
    c[L_xyz] = 1 / r;
    c[L_yyz] = y * xr.inverse / r;
    c[M_xx] = z * angle_x - x * yr.logarithm;
    c[M_xy] = z * zr.logarithm - r;
    c[M_yy] = z * angle_y - y * xr.logarithm;
    c[M_xxx] = y * zr.inverse - yr.logarithm;
    c[M_xxy] = -x * zr.inverse;
    c[M_xyy] = -y * zr.inverse;
    c[M_yyy] = x * zr.inverse - xr.logarithm;
    return c;
}

HarmonicDerivatives over_rectangle(double x, double y, double z, contact::Vector2 widths) {
    const double half_x = widths[0] / 2, half_y = widths[1] / 2;
    const auto a = corner(x + half_x, y + half_y, z), b = corner(x - half_x, y + half_y, z),
               c = corner(x + half_x, y - half_y, z), d = corner(x - half_x, y - half_y, z);
    HarmonicDerivatives sum{};
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] = (a[k] - b[k]) - (c[k] - d[k]);
    return sum;
}

}  // namespace

/// What is added to the half-space.
struct InteriorInfluence::Difference {
    LayerInteriorKernel kernel;
    theory::QuadratureRule rule;

    void add(std::size_t level, double x, double y, contact::Vector2 widths,
             InteriorResponse& sum) const {
        for (std::size_t i = 0; i < rule.points.size(); ++i)
            for (std::size_t j = 0; j < rule.points.size(); ++j)
                kernel.add(level, x - rule.points[i] * widths[0], y - rule.points[j] * widths[1],
                           rule.weights[i] * rule.weights[j] * widths[0] * widths[1], sum);
    }
};

InteriorInfluence::InteriorInfluence(InteriorBody body, contact::Vector2 widths,
                                     std::vector<double> depths, double reach)
    : body_(std::move(body)), widths_(widths), depths_(std::move(depths)) {
    if (!body_.layers) return;
    const auto& stack = *body_.layers;
    difference_ = std::make_unique<Difference>(Difference{
        LayerInteriorKernel(stack, depths_, reach + std::hypot(widths[0], widths[1]) / 2),
        cell_rule(std::max(widths[0], widths[1]) / stack.sheets.front().thickness)});
}

InteriorInfluence::~InteriorInfluence() = default;

InteriorResponse InteriorInfluence::at(std::size_t level, double x, double y) const {
    const double z = depths_[level];
    auto out = theory::half_space_response(body_.material, z, over_rectangle(x, y, z, widths_));
    if (difference_) difference_->add(level, x, y, widths_, out);
    return out;
}

}  // namespace tricontact::bem
