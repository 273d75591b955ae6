#include "theory/layer/layer_compliance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/base/error.h"
#include "contact/base/special_values.h"

namespace tricontact::theory {

namespace {

void check_poisson(double poisson) {
    if (!(poisson > -1 && poisson <= 0.5))
        throw contact::InputError(fmt::format(
            "layer: Poisson's ratio must lie in (-1, 0.5], but is {:.6g}; correct it", poisson));
}

// Sum of y^n/n! over n = first, first + 2, ...: converges to full precision for y <= 2.
double odd_or_even_tail(double y, int first) {
    double term = 1;
    for (int n = 1; n <= first; ++n) term *= y / n;
    double sum = term;
    for (int n = first + 2; n <= first + 20; n += 2) {
        term *= y * y / (n * (n - 1.));
        sum += term;
    }
    return sum;
}

// The hyperbolic functions of y = 2x times exp(-y), and what is left of them after their first
// terms. The direct form of the latter loses one digit at y = 2 and fewer beyond.
struct Scaled {
    double y, decay, sinh, cosh, cosh_minus_1;
    double sinh_tail;  // sinh y - y
    double cosh_tail;  // cosh y - 1 - y^2/2
};

Scaled scaled(double x) {
    const double y = 2 * x, decay = std::exp(-y), series_below = 2;
    const double sinh = -std::expm1(-2 * y) / 2, cosh_minus_1 = std::expm1(-y) * std::expm1(-y) / 2;
    return {.y = y,
            .decay = decay,
            .sinh = sinh,
            .cosh = (1 + decay * decay) / 2,
            .cosh_minus_1 = cosh_minus_1,
            .sinh_tail = y < series_below ? decay * odd_or_even_tail(y, 3) : sinh - decay * y,
            .cosh_tail = y < series_below ? decay * odd_or_even_tail(y, 4)
                                          : cosh_minus_1 - decay * y * y / 2};
}

// C G k: the dimensionless compliance of the header's formulas. Numerators are arranged in terms
// of one sign where the material allows it: kappa - 1 = 2 (1 - 2 nu) is exact at nu = 1/2.
LayerCompliance bonded(double nu, double x) {
    const double kappa = 3 - 4 * nu, excess = 2 * (1 - 2 * nu);
    const Scaled s = scaled(x);
    const double d = 2 * kappa * s.cosh + s.decay * (4 * x * x + 1 + kappa * kappa);
    const double normal = 2 * kappa * s.sinh_tail + 4 * x * excess * s.decay;
    const double along = 2 * kappa * s.sinh + 4 * x * s.decay;
    // kappa (kappa-1) 2 x^2 - 4 x^2 = 2 (kappa-2) (kappa+1) x^2 vanishes at nu = 1/4.
    const double coupling =
        kappa * excess * s.cosh_tail + 2 * (1 - 4 * nu) * (kappa + 1) * x * x * s.decay;
    return {.normal = (1 - nu) * normal / d,
            .along = (1 - nu) * along / d,
            .across = std::tanh(x),
            .coupling = coupling / (2 * d)};
}

LayerCompliance frictionless(double nu, double x) {
    const Scaled s = scaled(x);
    const double d = s.sinh + s.y * s.decay;
    const double coupling = (1 - 2 * nu) * s.sinh_tail - 2 * nu * s.y * s.decay;
    return {(1 - nu) * s.cosh_minus_1 / d, (1 - nu) * (s.cosh + s.decay) / d, 1 / std::tanh(x),
            coupling / (2 * d)};
}

LayerCompliance at_rest(const ElasticLayer& layer) {
    const double nu = layer.material.poisson;
    const double scale = layer.thickness / layer.material.shear_modulus();
    if (layer.base == LayerBase::bonded)
        return {scale * (1 - 2 * nu) / (2 * (1 - nu)), scale, scale, 0};
    const double coupling = nu == 0 ? 0 : std::copysign(contact::infinity, -nu);
    return {scale * (1 - nu) / 2, contact::infinity, contact::infinity, coupling};
}

}  // namespace

void check(const ElasticLayer& layer) {
    const contact::MaterialPair checked({}, layer.material);
    if (!(layer.thickness > 0) || !std::isfinite(layer.thickness))
        throw contact::InputError(fmt::format(
            "layer: the thickness must be positive and finite, but is {:.6g} m; for an infinite "
            "one use the half-space",
            layer.thickness));
}

LayerCompliance layer_compliance(const ElasticLayer& layer, double wave_number) {
    check(layer);
    if (!(wave_number >= 0) || !std::isfinite(wave_number))
        throw contact::InputError(fmt::format(
            "layer: the wave number must not be negative or infinite, but is {:.6g} 1/m; use the "
            "length of the wave vector",
            wave_number));
    if (wave_number == 0) return at_rest(layer);
    const double nu = layer.material.poisson, x = wave_number * layer.thickness;
    LayerCompliance c{1 - nu, 1 - nu, 1, (1 - 2 * nu) / 2};
    if (x < half_space_from)
        c = layer.base == LayerBase::bonded ? bonded(nu, x) : frictionless(nu, x);
    const double scale = 1 / (layer.material.shear_modulus() * wave_number);
    return {c.normal * scale, c.along * scale, c.across * scale, c.coupling * scale};
}

double bonded_coupling_ratio(double poisson, double x) {
    if (x >= half_space_from) return (1 - 2 * poisson) / 2 / (1 - poisson);
    const LayerCompliance c = bonded(poisson, x);
    return c.coupling / c.along;
}

HalfSpaceDeficit half_space_deficit(double poisson, LayerBase base, double x) {
    check_poisson(poisson);
    if (!(x >= 0))
        throw contact::InputError(
            fmt::format("layer: k b must not be negative, but is {:.6g}; correct it", x));
    if (x >= half_space_from) return {0, 0, 0};
    const Scaled s = scaled(x);
    const double y = s.y, decay = s.decay;
    if (base == LayerBase::bonded) {
        const double kappa = 3 - 4 * poisson;
        const double d = 2 * kappa * s.cosh + decay * (y * y + 1 + kappa * kappa);
        // D - 2 kappa sinh y +- 2y = 2 kappa exp(-y) + (1 +- y)^2 + kappa^2
        const double common = 2 * kappa * decay + kappa * kappa;
        return {decay * (common + (1 + y) * (1 + y)) / d, decay * (common + (1 - y) * (1 - y)) / d,
                2 * decay / (1 + decay)};
    }
    if (x == 0) return {1, -contact::infinity, -contact::infinity};
    const double d = s.sinh + y * decay;
    // D - cosh y +- 1 = y +- 1 - exp(-y)
    return {decay * (y - std::expm1(-y)) / d, decay * (y - 1 - decay) / d,
            2 * decay / std::expm1(-y)};
}

}  // namespace tricontact::theory
