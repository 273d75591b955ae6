#include "bem/interior_influence.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <tuple>

#include "bem/influence.h"

// Fields below the surface, docs/how-to/subsurface.md, of a point force: plane waves of
// theory/layer/layer_stack.h, along the wave vector, across it and down, summed over its
// directions. That sum leaves Bessel functions. Under pressure, which has no direction in the
// plane, u_z and sigma_zz go with J0, what points along r with J1, and the difference of the
// principal stresses with J2. A force along x adds a factor cos theta or sin theta: orders go from
// 0 to 3 (`order`).
//
// Of layers only the difference from the half-space of the top layer is summed, which is smooth;
// the half-space itself is integrated over the cell in closed form (`corner`).

namespace tricontact::bem {

namespace {

using theory::InteriorWaves;
using theory::LayerStack;

constexpr int lagrange_points = 6;

/// Radial functions: of pressure, then of a force along x, theta = 0.
enum Function : std::size_t {
    pressed_z,      // u_z
    pressed_r,      // u_r
    pressed_sigma,  // sigma_zz
    pressed_tau,    // sigma_rz
    pressed_mean,   // (sigma_xx + sigma_yy)/2
    pressed_shear,  // (sigma_rr - sigma_tt)/2
    sheared_mean,   // u_x and, over cos 2 theta, its deviation
    sheared_deviation,
    sheared_z,      // u_z over cos theta
    sheared_sigma,  // sigma_zz over cos theta
    sheared_tau,    // sigma_xz and, over cos 2 theta, its deviation
    sheared_tau_deviation,
    sheared_in_plane,  // (sigma_xx + sigma_yy)/2 over cos theta
    sheared_first,     // (sigma_xx - sigma_yy)/2 over cos theta
    sheared_third,     // and over cos 3 theta
    n_functions
};
using Values = LayerInteriorKernel::Values;
static_assert(n_functions == std::tuple_size_v<Values>);

/// Order m of the Bessel function that goes with each.
constexpr std::array<int, n_functions> order = {0, 1, 0, 1, 0, 2, 0, 2, 1, 1, 0, 2, 1, 1, 3};

/// What stands before Jm.
Values amplitudes(const InteriorWaves& w) {
    const auto &p = w.pressed, &t = w.sheared;
    const double deviation = (t.sigma_along - t.sigma_across) / 2;
    Values v{};
    v[pressed_z] = p.u_z;
    v[pressed_r] = p.u_along;
    v[pressed_sigma] = p.sigma_z;
    v[pressed_tau] = p.tau;
    v[pressed_mean] = (p.sigma_along + p.sigma_across) / 2;
    v[pressed_shear] = -(p.sigma_along - p.sigma_across) / 2;
    v[sheared_mean] = (t.u_along + w.across_u) / 2;
    v[sheared_deviation] = -(t.u_along - w.across_u) / 2;
    v[sheared_z] = t.u_z;
    v[sheared_sigma] = t.sigma_z;
    v[sheared_tau] = (t.tau + w.across_tau) / 2;
    v[sheared_tau_deviation] = -(t.tau - w.across_tau) / 2;
    v[sheared_in_plane] = (t.sigma_along + t.sigma_across) / 2;
    v[sheared_first] = (deviation + w.across_shear) / 2;
    v[sheared_third] = -(deviation - w.across_shear) / 2;
    return v;
}

struct InsideWave {
    double k;
    std::vector<Values> amplitude;  // per depth, weights included
};

std::vector<InsideWave> waves_of(const LayerStack& stack, const std::vector<double>& depths,
                                 double farthest) {
    std::vector<InsideWave> waves;
    const LayerStack half_space = continued(stack);
    for (const auto& [k, weight] : layer_waves(stack, farthest, last_inside_wave)) {
        const double factor = weight * k / (2 * std::numbers::pi);
        const auto layers = theory::interior_waves(stack, k, depths),
                   plain = theory::interior_waves(half_space, k, depths);
        InsideWave& wave = waves.emplace_back(InsideWave{k, {}});
        for (std::size_t d = 0; d < depths.size(); ++d) {
            Values of = amplitudes(layers[d]);
            const Values less = amplitudes(plain[d]);
            for (std::size_t f = 0; f < n_functions; ++f) of[f] = factor * (of[f] - less[f]);
            wave.amplitude.push_back(of);
        }
    }
    return waves;
}

/// J0 to J3; near 0 by their first terms.
std::array<double, 4> bessel(double x) {
    const double j0 = ::j0(x), j1 = ::j1(x);
    if (x < 0.1) {
        const double y = x * x / 4;
        return {j0, j1, y / 2 * (1 - y / 3 + y * y / 24), x * y / 12 * (1 - y / 4 + y * y / 40)};
    }
    const double j2 = 2 * j1 / x - j0;
    return {j0, j1, j2, 4 * j2 / x - j1};
}

std::vector<Values> integrate(const std::vector<InsideWave>& waves, std::size_t n_depths, double r,
                              double hold) {
    std::vector<Values> sums(n_depths, Values{});
    for (const auto& [k, amplitude] : waves) {
        const auto j = bessel(k * r);
        Values factor;
        for (std::size_t f = 0; f < n_functions; ++f) factor[f] = j[order[f]];
        if (hold > 0) factor[sheared_mean] -= ::j0(k * hold);
        for (std::size_t d = 0; d < n_depths; ++d)
            for (std::size_t f = 0; f < n_functions; ++f) sums[d][f] += factor[f] * amplitude[d][f];
    }
    return sums;
}

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

LayerInteriorKernel::LayerInteriorKernel(const LayerStack& stack, const std::vector<double>& depths,
                                         double reach)
    : unit_(0) {
    theory::check(stack);
    unit_ = stack.sheets.front().thickness;
    const double hold = LayerKernel::hold(stack);
    const auto waves = waves_of(stack, depths, std::max({reach, hold, unit_}));
    tables_.resize(depths.size());
    const int n = lagrange_points + static_cast<int>(std::asinh(reach / unit_) / table_step);
    for (int i = 0; i < n; ++i) {
        const double r = unit_ * std::sinh(i * table_step);
        const auto sums = integrate(waves, depths.size(), r, hold);
        for (std::size_t d = 0; d < depths.size(); ++d) tables_[d].push_back(sums[d]);
    }
}

// All functions at once by Lagrange's polynomial through the points around, whose weights they
// share.
LayerInteriorKernel::Values LayerInteriorKernel::at(std::size_t level, double r) const {
    const double s = std::asinh(r / unit_) / table_step;
    const int first = static_cast<int>(s) - lagrange_points / 2 + 1;
    const auto& table = tables_[level];
    Values out{};
    for (int i = 0; i < lagrange_points; ++i) {
        double weight = 1;
        for (int j = 0; j < lagrange_points; ++j)
            if (j != i) weight *= (s - first - j) / (i - j);
        const Values& value = table[std::abs(first + i)];
        for (std::size_t f = 0; f < n_functions; ++f)
            out[f] += first + i < 0 && order[f] % 2 == 1 ? -weight * value[f] : weight * value[f];
    }
    return out;
}

void LayerInteriorKernel::add(std::size_t level, double x, double y, double force,
                              theory::InteriorResponse& sum) const {
    const double r = std::hypot(x, y);
    Values v = at(level, r);
    for (double& value : v) value *= force;
    const double c = r > 0 ? x / r : 1, n = r > 0 ? y / r : 0;
    const double c2 = c * c - n * n, n2 = 2 * c * n, c3 = c * c2 - n * n2, n3 = n * c2 + c * n2;
    auto& u = sum.displacement;
    auto& stress = sum.stress;
    u[0][2] += v[pressed_r] * c;
    u[1][2] += v[pressed_r] * n;
    u[2][2] += v[pressed_z];
    stress[0][2] += v[pressed_mean] + v[pressed_shear] * c2;
    stress[1][2] += v[pressed_mean] - v[pressed_shear] * c2;
    stress[2][2] += v[pressed_sigma];
    stress[3][2] += v[pressed_shear] * n2;
    stress[4][2] += v[pressed_tau] * n;
    stress[5][2] += v[pressed_tau] * c;

    // Along y: x and y change places, theta becomes a right angle less theta.
    u[0][0] += v[sheared_mean] + v[sheared_deviation] * c2;
    u[1][1] += v[sheared_mean] - v[sheared_deviation] * c2;
    u[1][0] += v[sheared_deviation] * n2;
    u[0][1] += v[sheared_deviation] * n2;
    u[2][0] += v[sheared_z] * c;
    u[2][1] += v[sheared_z] * n;
    const double first = v[sheared_first], third = v[sheared_third], mean = v[sheared_in_plane];
    stress[0][0] += (mean + first) * c + third * c3;
    stress[1][0] += (mean - first) * c - third * c3;
    stress[0][1] += (mean - first) * n + third * n3;
    stress[1][1] += (mean + first) * n - third * n3;
    stress[3][0] += first * n + third * n3;
    stress[3][1] += first * c - third * c3;
    stress[2][0] += v[sheared_sigma] * c;
    stress[2][1] += v[sheared_sigma] * n;
    stress[5][0] += v[sheared_tau] + v[sheared_tau_deviation] * c2;
    stress[4][1] += v[sheared_tau] - v[sheared_tau_deviation] * c2;
    stress[4][0] += v[sheared_tau_deviation] * n2;
    stress[5][1] += v[sheared_tau_deviation] * n2;
}

InteriorBody::InteriorBody(const contact::Material& half_space) : material(half_space) {}
InteriorBody::InteriorBody(LayerStack stack, bool under_strips)
    : material(stack.sheets.front().material),
      layers(std::move(stack)),
      plane_strain(under_strips) {}

InteriorInfluence::InteriorInfluence(InteriorBody body, contact::Vector2 widths,
                                     std::vector<double> depths, double reach)
    : body_(std::move(body)), widths_(widths), depths_(std::move(depths)) {
    if (!body_.layers) return;
    const auto& stack = *body_.layers;
    difference_.emplace(stack, depths_, reach + std::hypot(widths[0], widths[1]) / 2);
    rule_ = cell_rule(std::max(widths[0], widths[1]) / stack.sheets.front().thickness);
}

InteriorResponse InteriorInfluence::at(std::size_t level, double x, double y) const {
    const double z = depths_[level];
    auto out = theory::half_space_response(body_.material, z, over_rectangle(x, y, z, widths_));
    if (!difference_) return out;
    const auto& [points, weights] = rule_;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < points.size(); ++j)
            difference_->add(level, x - points[i] * widths_[0], y - points[j] * widths_[1],
                             weights[i] * weights[j] * widths_[0] * widths_[1], out);
    return out;
}

}  // namespace tricontact::bem
