#include "bem/influence.h"

#include <algorithm>
#include <boost/math/interpolators/cardinal_quintic_b_spline.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

// Frame and signs of all coefficients, Johnson (1985), section 3.2 and 3.6; bem.md and bem-layer.md
// in docs/explanation/models use them:
//
//            p > 0 presses          u: substrate minus indenter, at (x, y) from the centre
//              |  t_x > 0           K_zz > 0: pressure sinks the surface
//      --------v==>-------- x       K_xx > 0: it follows the traction on the substrate
//              |   substrate        K_xz < 0 at x > 0: pressure draws the surface of a
//              v z                     half-space towards itself, nu < 1/2
//
// Forces on a half-space at the distance s = sqrt(x^2 + y^2), eq. 3.19 for P and 3.75 at z = 0 for
// Q:
//
//   u_z = (1 - nu)/(2 pi G) P/s                   u_x = Q/(2 pi G) [(1 - nu)/s + nu x^2/s^3]
//   u_x = -(1 - 2 nu)/(4 pi G) P x/s^2            u_y = Q/(2 pi G) nu x y/s^3
//
// A rectangle's coefficient is the integral over its area: the antiderivative F in x and y
// (`Corner`) at the four corners, F(a) - F(b) - F(c) + F(d), exact at any distance, the rectangle
// itself included.
//
// Layers add the difference of both bodies' compliances, D(k) = C_layers - C_half-space. That falls
// as exp(-2 k b), so the Hankel integrals of LayerKernel converge at r = 0, too, and the singular
// part stays in closed form. The integrals are the same for all cells: they are tabulated over
// asinh(r/b), whose steps are even near the force and grow with r beyond b.

namespace tricontact::bem {

namespace {

// The antiderivatives of `Corner`, each checked by differentiating in x and in y, s^2 = x^2 + y^2:
//
//   1/s        x asinh(y/|x|) + y asinh(x/|y|)
//   x^2/s^3    y asinh(x/|y|)
//   x y/s^3    -s
//   x/s^2      y ln s + x atan(y/x)
/// Antiderivatives in x and y of the kernels, s = sqrt(x^2 + y^2). Terms that cancel between the
/// corners of a rectangle are left out: y ln(x + s) = y asinh(x/|y|) + y ln|y|.
struct Corner {
    double one_over_s;  // 1/s
    double xx_over_s3;  // x^2/s^3
    double xy_over_s3;  // x y/s^3
    double x_over_s2;   // x/s^2
    double y_over_s2;   // y/s^2
};

double times_asinh(double factor, double x, double y) {
    return factor == 0 ? 0 : factor * std::asinh(x / std::abs(y));
}

/// int int x/(x^2+y^2) = y ln(s) + x atan(y/x), less the term linear in y.
double plane_kernel(double x, double y, double s) {
    const double logarithm = y == 0 ? 0 : y * std::log(s);
    return logarithm + (x == 0 ? 0 : x * std::atan(y / x));
}

Corner corner(double x, double y) {
    const double s = std::hypot(x, y);
    const double y_term = times_asinh(y, x, y), x_term = times_asinh(x, y, x);
    return {x_term + y_term, y_term, -s, plane_kernel(x, y, s), plane_kernel(y, x, s)};
}

constexpr int points_per_panel = 10;   // Gauss: exact to rounding over half a wave
constexpr double phase_per_panel = 4;  // of the waves of the argument k r

/// Ends of panels over k b: finer towards zero, where what lies deep is seen, and never wider than
/// the waves allow.
std::vector<double> panels(double first, double farthest, double last) {
    const double widest = std::min(0.5, phase_per_panel / farthest);
    std::vector<double> ends{0};
    for (double width = std::min(widest, first); ends.back() < last;
         width = std::min(widest, 2 * width))
        ends.push_back(ends.back() + width);
    return ends;
}

using theory::LayerCompliance;
using theory::LayerStack;
using Spline = boost::math::interpolators::cardinal_quintic_b_spline<double>;

constexpr int beyond = 8;  // points of the table past either end

/// A wave number with the weights of the four integrands, 1/(2 pi) and k included.
struct KernelWave {
    double k;
    double normal, mean, deviation, coupling;
};

std::vector<KernelWave> kernel_waves(const LayerStack& stack, double farthest) {
    std::vector<KernelWave> waves;
    for (const Wave& wave : layer_waves(stack, farthest)) {
        const LayerCompliance c = theory::surface_compliance(stack, wave.k),
                              h = theory::half_space_compliance_at(stack.sheets.front().material,
                                                                   wave.k);
        const double factor = wave.weight * wave.k / (2 * std::numbers::pi);
        const double along = c.along - h.along, across = c.across - h.across;
        waves.push_back({wave.k, factor * (c.normal - h.normal), factor * (along + across) / 2,
                         -factor * (along - across) / 2, factor * (c.coupling - h.coupling)});
    }
    return waves;
}

LayerKernel::Values integrate(const std::vector<KernelWave>& waves, double r, double hold) {
    LayerKernel::Values sum{};
    for (const KernelWave& w : waves) {
        const double x = w.k * r, j0 = ::j0(x), j1 = ::j1(x);
        const double j2 = x < 1e-3 ? x * x / 8 : 2 * j1 / x - j0;
        sum.normal += w.normal * j0;
        sum.mean += w.mean * (hold > 0 ? j0 - ::j0(w.k * hold) : j0);
        sum.deviation += w.deviation * j2;
        sum.coupling += w.coupling * j1;
    }
    return sum;
}

/// Values over asinh(r/b) from 0 on, continued to the other side of 0 by their parity: the spline's
/// ends, whose slopes it guesses, lie outside what is asked for.
Spline spline(const std::vector<double>& values, double parity) {
    std::vector<double> all;
    for (int i = beyond; i > 0; --i) all.push_back(parity * values[i]);
    all.insert(all.end(), values.begin(), values.end());
    return {all.data(), all.size(), -beyond * table_step, table_step};
}

const theory::LayerStack& checked(const theory::LayerStack& stack) {
    theory::check(stack);
    return stack;
}

}  // namespace

RectangleInfluence::RectangleInfluence(const contact::MaterialPair& materials, double width_x,
                                       double width_y)
    : half_x_(width_x / 2),
      half_y_(width_y / 2),
      symmetric_(materials.one_minus_nu_over_g() / (2 * std::numbers::pi)),
      skew_(materials.nu_over_g() / (2 * std::numbers::pi)),
      coupling_(materials.one_minus_two_nu_over_g() / (4 * std::numbers::pi)) {}

InfluenceCoefficients RectangleInfluence::at(double x, double y) const {
    const Corner a = corner(x + half_x_, y + half_y_), b = corner(x - half_x_, y + half_y_),
                 c = corner(x + half_x_, y - half_y_), d = corner(x - half_x_, y - half_y_);
    auto over_rectangle = [&](double Corner::*term) {
        return (a.*term - b.*term) - (c.*term - d.*term);
    };
    const double one = over_rectangle(&Corner::one_over_s);
    const double xx = over_rectangle(&Corner::xx_over_s3);
    const double xy = over_rectangle(&Corner::xy_over_s3);
    const double radial_x = coupling_ * over_rectangle(&Corner::x_over_s2);
    const double radial_y = coupling_ * over_rectangle(&Corner::y_over_s2);
    // y^2/s^3 = 1/s - x^2/s^3.
    return {.xx = symmetric_ * one + skew_ * xx,
            .xy = skew_ * xy,
            .yy = symmetric_ * one + skew_ * (one - xx),
            .xz = -radial_x,
            .yz = -radial_y,
            .zz = symmetric_ * one};
}

std::vector<Wave> layer_waves(const theory::LayerStack& stack, double farthest, double last) {
    using Rule = boost::math::quadrature::gauss<double, points_per_panel>;
    const double b = stack.sheets.front().thickness;
    const auto ends = panels(theory::softest_wave_number(stack) * b, farthest / b, last);
    std::vector<Wave> waves;
    for (std::size_t p = 1; p < ends.size(); ++p) {
        const double middle = (ends[p] + ends[p - 1]) / (2 * b),
                     half = (ends[p] - ends[p - 1]) / (2 * b);
        for (std::size_t i = 0; i < Rule::abscissa().size(); ++i)
            for (const int side : {-1, 1})
                waves.push_back(
                    {middle + side * half * Rule::abscissa()[i], half * Rule::weights()[i]});
    }
    return waves;
}

theory::LayerStack continued(const theory::LayerStack& stack) {
    const auto& top = stack.sheets.front();
    return {{{top.material, stack.thickness()}}, stack.base, top.material};
}

struct LayerKernel::Tables {
    Spline normal, mean, deviation, coupling;
};

LayerKernel::LayerKernel(const LayerStack& stack, double reach) : unit_(0) {
    theory::check(stack);
    unit_ = stack.sheets.front().thickness;
    const double hold = LayerKernel::hold(stack);
    const auto waves = kernel_waves(stack, std::max({reach, hold, unit_}));

    const int n = 1 + beyond + static_cast<int>(std::ceil(std::asinh(reach / unit_) / table_step));
    std::vector<double> normal, mean, deviation, coupling;
    for (int i = 0; i < n; ++i) {
        const auto at = integrate(waves, unit_ * std::sinh(i * table_step), hold);
        normal.push_back(at.normal);
        mean.push_back(at.mean);
        deviation.push_back(at.deviation);
        coupling.push_back(at.coupling);
    }
    tables_ = std::make_unique<Tables>(
        Tables{spline(normal, 1), spline(mean, 1), spline(deviation, 1), spline(coupling, -1)});
}

LayerKernel::~LayerKernel() = default;

LayerKernel::Values LayerKernel::at(double r) const {
    const double s = std::asinh(r / unit_);
    return {tables_->normal(s), tables_->mean(s), tables_->deviation(s), tables_->coupling(s)};
}

contact::QuadratureRule cell_rule(double width_over_thickness) {
    const double more = std::min(10., std::ceil(5 * width_over_thickness));
    auto rule = contact::gauss_legendre(2 + static_cast<int>(more));
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
        }
    return sum;
}

}  // namespace tricontact::bem
