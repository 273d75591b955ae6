#include "bem/periodic_compliance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "bem/quadrants.h"
#include "contact/base/error.h"

// Periodic contact, docs/explanation/models/bem-layer.md ("Periodic"). A traction uniform on a cell
// of the edge h and repeated with the period L = n h has Fourier coefficients at all k = 2 pi m/L,
// not only at the n wave numbers of the grid. Displacements are read at the cells' centres, where
// the wave numbers m and m + q n coincide:
//
//   k_x h/2 = theta + pi q, theta = pi m/n:   sinc = (-1)^q sin(theta)/(theta + pi q)
//
// so the symbol of m is the sum over all these aliases q of C(k) sinc sinc. Because of C ~ 1/k and
// the sincs the terms fall as 1/q^2 with alternating signs: eight plain ones, then Euler's averages
// of ten partial sums.
//
// At m = 0 only q = 0 has a sinc: the uniform load, an oedometer and simple shear (`uniform_load`).

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
    return theory::half_space_compliance_at(top.material, k);
}

InfluenceCoefficients uniform_load(const LayerStack& stack) {
    InfluenceCoefficients k{};
    for (const auto& [material, thickness] : stack.sheets) {
        const double nu = material.poisson, b_over_g = thickness / material.shear_modulus();
        k.zz += b_over_g * (1 - 2 * nu) / (2 * (1 - nu));
        k.xx += b_over_g;
    }
    k.yy = k.xx;
    return k;
}

/// Both directions' part of a sum over aliases.
struct Aliases {
    Aliases(double theta, const Weights& weights) : factor(weighted_sincs(theta, weights)) {
        for (int q = 0; q < 2 * n_aliases + 1; ++q)
            a[q] = theta + std::numbers::pi * (q - n_aliases);
    }
    std::array<double, 2 * n_aliases + 1> factor, a;  // a = k h/2
};

InfluenceCoefficients sum_of_layers(const LayerStack& stack, double spacing, const Aliases& x,
                                    const Aliases& y) {
    InfluenceCoefficients sum{};
    for (int q = 0; q < 2 * n_aliases + 1; ++q)
        for (int p = 0; p < 2 * n_aliases + 1; ++p) {
            const double factor = x.factor[p] * y.factor[q];
            if (factor == 0) continue;
            const double a = std::hypot(x.a[p], y.a[q]), cos = x.a[p] / a, sin = y.a[q] / a;
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

/// C11 = C33 = (1 - nu)/(G k), C22 = 1/(G k), C13 = (1 - 2 nu)/(2 G k): Johnson (1985), sec. 13.2.
InfluenceCoefficients sum_of_half_spaces(const contact::MaterialPair& pair, double spacing,
                                         const Aliases& x, const Aliases& y) {
    double all = 0, along = 0, mixed = 0, odd_x = 0, odd_y = 0;  // 1, cos^2, sin cos, cos, sin
    for (int q = 0; q < 2 * n_aliases + 1; ++q) {
        const double a_y = y.a[q], factor_y = y.factor[q];
        if (factor_y == 0) continue;
#pragma omp simd reduction(+ : all, along, mixed, odd_x, odd_y)
        for (int p = 0; p < 2 * n_aliases + 1; ++p) {
            const double a_x = x.a[p], square = a_x * a_x + a_y * a_y;
            const double inverse = 1 / square, over_square = x.factor[p] * factor_y * inverse;
            const double over_a = over_square * std::sqrt(square);
            all += over_a;
            along += over_a * a_x * a_x * inverse;
            mixed += over_a * a_x * a_y * inverse;
            odd_x += over_square * a_x;
            odd_y += over_square * a_y;
        }
    }
    const double normal = pair.one_minus_nu_over_g() * spacing / 2,
                 across = normal + pair.nu_over_g() * spacing / 2,
                 coupling = pair.one_minus_two_nu_over_g() / 2 * spacing / 2;
    return {.xx = normal * along + across * (all - along),
            .xy = (normal - across) * mixed,
            .yy = normal * (all - along) + across * along,
            .xz = coupling * odd_x,
            .yz = coupling * odd_y,
            .zz = normal * all};
}

/// What is along x becomes what is along y: of isotropic bodies.
InfluenceCoefficients transposed(const InfluenceCoefficients& k) {
    return {.xx = k.yy, .xy = k.xy, .yy = k.xx, .xz = k.yz, .yz = k.xz, .zz = k.zz};
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

/// `sum`: of the aliases in x and y.
template <class Sum>
void PeriodicInfluence::fill(const InfluenceCoefficients& uniform, int n_threads, Sum sum) {
    const Weights weights = euler_weights();
    std::vector<Aliases> aliases;
    for (int i = 0; i < n_quadrant_; ++i) aliases.emplace_back(std::numbers::pi * i / n_, weights);
    auto at = [&](int i, int j) -> InfluenceCoefficients& {
        return quadrant_[static_cast<std::size_t>(j) * n_quadrant_ + i];
    };
#pragma omp parallel for num_threads(n_threads) if (n_threads > 1) schedule(dynamic)
    for (int j = 0; j < n_quadrant_; ++j)
        for (int i = 0; i <= j; ++i) {
            at(i, j) = j == 0 ? uniform : sum(aliases[i], aliases[j]);
            at(j, i) = transposed(at(i, j));
        }
}

PeriodicInfluence::PeriodicInfluence(const LayerStack& stack, double spacing, int n, int n_threads)
    : n_(n),
      n_quadrant_(n / 2 + 1),
      quadrant_(static_cast<std::size_t>(n_quadrant_) * n_quadrant_) {
    check_held(stack);
    fill(uniform_load(stack), n_threads,
         [&](const Aliases& x, const Aliases& y) { return sum_of_layers(stack, spacing, x, y); });
}

PeriodicInfluence::PeriodicInfluence(const contact::MaterialPair& half_spaces, double spacing,
                                     int n, int n_threads)
    : n_(n),
      n_quadrant_(n / 2 + 1),
      quadrant_(static_cast<std::size_t>(n_quadrant_) * n_quadrant_) {
    fill({}, n_threads, [&](const Aliases& x, const Aliases& y) {
        return sum_of_half_spaces(half_spaces, spacing, x, y);
    });
}

InfluenceCoefficients PeriodicInfluence::at(int m_x, int m_y) const {
    const int i = std::abs(m_x), j = std::abs(m_y);
    InfluenceCoefficients k = quadrant_[static_cast<std::size_t>(j) * n_quadrant_ + i];
    // A wave of two cells is its own mirror image: what is odd in it vanishes.
    const double sign_x = 2 * i == n_ ? 0 : m_x < 0 ? -1 : 1;
    const double sign_y = 2 * j == n_ ? 0 : m_y < 0 ? -1 : 1;
    k.xz *= sign_x;
    k.yz *= sign_y;
    k.xy *= sign_x * sign_y;
    return k;
}

PeriodicCompliance::PeriodicCompliance(const theory::LayerStack& stack, contact::ContactPoints grid,
                                       int n_threads, const contact::Interface& interface)
    : PeriodicCompliance{PeriodicInfluence(stack, grid.spacing[0], grid.n_x, n_threads),
                         std::move(grid), true, n_threads, interface} {}

PeriodicCompliance::PeriodicCompliance(const contact::MaterialPair& half_spaces,
                                       contact::ContactPoints grid, int n_threads,
                                       const contact::Interface& interface)
    : PeriodicCompliance{PeriodicInfluence(half_spaces, grid.spacing[0], grid.n_x, n_threads),
                         std::move(grid), bem::is_coupled(half_spaces), n_threads, interface} {}

PeriodicCompliance::PeriodicCompliance(const PeriodicInfluence& influence,
                                       contact::ContactPoints grid, bool coupled, int n_threads,
                                       const contact::Interface& interface)
    : ConvolvedCompliance(std::move(grid), coupled, n_threads) {
    grid_.periodic = true;
    grid_.on_springs = interface.is_elastic();
    GridConvolution convolution(grid_.n_x, grid_.n_y, grid_.n_x, grid_.n_y, n_threads_);
    const InfluenceCoefficients springs = springs_of(interface);
    const auto symbol = [&](double InfluenceCoefficients::*which) {
        return convolution.symbol_of_coefficients(
            [&](int m_x, int m_y) { return influence.at(m_x, m_y).*which + springs.*which; });
    };
    using K = InfluenceCoefficients;
    TangentialSymbols symbols{.tangential = {symbol(&K::xx), symbol(&K::xy), symbol(&K::yy)},
                              .inverse = {}};
    if (coupled_) {
        symbols.from_normal_x = symbol(&K::xz);
        symbols.from_normal_y = symbol(&K::yz);
    }
    auto& stiff = symbols.inverse = inverse(symbols.tangential, n_threads_);
    if (stiff.xx[0] == 0)  // of half-spaces the mean's: any positive one will do
        stiff.xx[0] = stiff.yy[0] = std::min(stiff.xx[1], stiff.yy[1]);
    auto normal = symbol(&K::zz);
    products_ = std::make_unique<ProductsBy<GridConvolution>>(
        std::move(convolution), std::nullopt, std::move(normal), std::move(symbols));

    contact::TangentialField one(grid_.size()), u(grid_.size());
    one.x[0] = 1;
    tangential(one, u);
    local_tangential_ = u.x[0];
}

InfluenceTable PeriodicCompliance::influence() const {
    const std::size_t n = grid_.size();
    std::vector<double> one(n), zz(n);
    contact::TangentialField along(n), across(n), by_x(n), by_y(n), by_z(n);
    one[0] = along.x[0] = across.y[0] = 1;
    normal(one, zz);
    tangential(along, by_x);
    tangential(across, by_y);
    tangential_from_normal(one, by_z);
    InfluenceTable table{grid_.spacing[0], grid_.n_x, grid_.n_y, {}};
    for (std::size_t i = 0; i < n; ++i)
        table.cells.push_back({.xx = by_x.x[i],
                               .xy = by_y.x[i],
                               .yy = by_y.y[i],
                               .xz = by_z.x[i],
                               .yz = by_z.y[i],
                               .zz = zz[i]});
    return table;
}

}  // namespace tricontact::bem
