#include "bem/periodic_influence.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "contact/error.h"

namespace tricontact::bem {

namespace {

using theory::LayerCompliance;
using theory::LayerStack;

constexpr int plain_aliases = 8, averaged_aliases = 10;
constexpr int n_aliases = plain_aliases + averaged_aliases;  // on either side
constexpr double last_kb = 24;  // from here on a half-space: exp(-2 kb) (kb)^2 < 1e-18

using Weights = std::array<double, n_aliases + 1>;

/// Euler's transformation of an alternating series: mean over its partial sums from plain_aliases
/// on, weighted binomially.
Weights euler_weights() {
    Weights weights{};
    double binomial = std::pow(.5, averaged_aliases), rest = 1;
    for (int q = 0; q <= n_aliases; ++q) {
        weights[q] = q <= plain_aliases ? 1 : rest;
        if (q < plain_aliases) continue;
        const int j = q - plain_aliases;
        rest -= binomial;
        binomial *= static_cast<double>(averaged_aliases - j) / (j + 1);
    }
    return weights;
}

/// sin(a)/a at the aliases a = theta + pi q, q from -n_aliases on, times the weights.
std::array<double, 2 * n_aliases + 1> weighted_sincs(double theta, const Weights& weights) {
    std::array<double, 2 * n_aliases + 1> values{};
    for (int q = -n_aliases; q <= n_aliases; ++q) {
        const double a = theta + std::numbers::pi * q;
        const double sinc = theta == 0 ? (q == 0 ? 1 : 0) : std::sin(theta) / a;
        values[q + n_aliases] = (q % 2 == 0 ? 1 : -1) * weights[std::abs(q)] * sinc;
    }
    return values;
}

LayerCompliance compliance_at(const LayerStack& stack, double k) {
    const auto& top = stack.sheets.front();
    if (k * top.thickness < last_kb) return theory::surface_compliance(stack, k);
    const double nu = top.material.poisson, scale = 1 / (top.material.shear_modulus() * k);
    return {(1 - nu) * scale, (1 - nu) * scale, scale, (1 - 2 * nu) / 2 * scale};
}

PeriodicCoefficients uniform_load(const LayerStack& stack) {
    PeriodicCoefficients k{};
    for (const auto& [material, thickness] : stack.sheets) {
        const double nu = material.poisson, b_over_g = thickness / material.shear_modulus();
        k.zz += b_over_g * (1 - 2 * nu) / (2 * (1 - nu));
        k.xx += b_over_g;
    }
    k.yy = k.xx;
    return k;
}

PeriodicCoefficients sum_of_aliases(const LayerStack& stack, double spacing, double theta_x,
                                    double theta_y, const Weights& weights) {
    const auto sinc_x = weighted_sincs(theta_x, weights), sinc_y = weighted_sincs(theta_y, weights);
    PeriodicCoefficients sum{};
    for (int q = 0; q < 2 * n_aliases + 1; ++q)
        for (int p = 0; p < 2 * n_aliases + 1; ++p) {
            const double factor = sinc_x[p] * sinc_y[q];
            if (factor == 0) continue;
            const double a_x = theta_x + std::numbers::pi * (p - n_aliases),
                         a_y = theta_y + std::numbers::pi * (q - n_aliases);
            const double a = std::hypot(a_x, a_y), cos = a_x / a, sin = a_y / a;
            const LayerCompliance c = compliance_at(stack, 2 * a / spacing);
            sum.zz += factor * c.normal;
            sum.xx += factor * (c.along * cos * cos + c.across * sin * sin);
            sum.yy += factor * (c.along * sin * sin + c.across * cos * cos);
            sum.xy += factor * (c.along - c.across) * sin * cos;
            // u_along = i C13 p
            sum.xz += factor * c.coupling * cos;
            sum.yz += factor * c.coupling * sin;
        }
    return sum;
}

void check_held(const LayerStack& stack) {
    theory::check(stack);
    if (stack.half_space)
        throw contact::InputError(
            "bem-layer: under a periodic load an elastic half-space gives way without bound, its "
            "compliance at k = 0 is infinite; take base = \"bonded\" or omit bem.period");
    if (stack.base == theory::LayerBase::frictionless)
        throw contact::InputError(
            "bem-layer: nothing holds periodic layers on a frictionless base, their tangential "
            "compliance at k = 0 is infinite; take base = \"bonded\" or omit bem.period");
}

}  // namespace

PeriodicInfluence::PeriodicInfluence(const LayerStack& stack, double spacing, int n, int n_threads)
    : n_(n),
      n_quadrant_(n / 2 + 1),
      quadrant_(static_cast<std::size_t>(n_quadrant_) * n_quadrant_) {
    check_held(stack);
    const Weights weights = euler_weights();
#pragma omp parallel for num_threads(n_threads) if (n_threads > 1) schedule(dynamic)
    for (int j = 0; j < n_quadrant_; ++j)
        for (int i = 0; i < n_quadrant_; ++i)
            quadrant_[static_cast<std::size_t>(j) * n_quadrant_ + i] =
                i == 0 && j == 0 ? uniform_load(stack)
                                 : sum_of_aliases(stack, spacing, std::numbers::pi * i / n,
                                                  std::numbers::pi * j / n, weights);
}

PeriodicCoefficients PeriodicInfluence::at(int m_x, int m_y) const {
    const int i = std::abs(m_x), j = std::abs(m_y);
    PeriodicCoefficients k = quadrant_[static_cast<std::size_t>(j) * n_quadrant_ + i];
    // A wave of two cells is its own mirror image: what is odd in it vanishes.
    const double sign_x = 2 * i == n_ ? 0 : m_x < 0 ? -1 : 1;
    const double sign_y = 2 * j == n_ ? 0 : m_y < 0 ? -1 : 1;
    k.xz *= sign_x;
    k.yz *= sign_y;
    k.xy *= sign_x * sign_y;
    return k;
}

}  // namespace tricontact::bem
