// RingContact of a cylinder: strips on either side of the line of first touch.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "benchmarks/reference/ring_contact.h"
#include "comparisons/half_space/layer.h"
#include "theory/layer/layer_compliance.h"

namespace tricontact::benchmarks {

namespace {

using std::numbers::pi;

constexpr double last_strip_wave = 24;  // k b
constexpr int points_of_strip_waves = 20;

/// Re F(x + i c), F'' = ln(z/scale).
double twice_integrated_log(double x, double c, double scale) {
    const double size2 = x * x + c * c;
    if (size2 == 0) return 0;
    const double logarithm = std::log(size2) / 2 - std::log(scale), angle = std::atan2(c, x);
    return (x * x - c * c) / 2 * logarithm - x * c * angle - .75 * (x * x - c * c);
}

}  // namespace

void RingContact::set_strips(const contact::Case& c) {
    const contact::MaterialPair pair = c.materials();
    const contact::Material& substrate = c.substrate;
    const std::optional<double> thickness = c.layer.thickness;
    const double nu = substrate.poisson, g = substrate.shear_modulus(), radius = c.indenter.radius;
    const double coupling = thickness ? (1 - 2 * nu) / g : pair.one_minus_two_nu_over_g();
    length_ = c.indenter.length;
    has_datum_ = thickness.has_value();
    for (Eigen::Index i = 0; i < areas_.size(); ++i) {
        const double in = edges_[i], out = edges_[i + 1];
        areas_[i] = 2 * (out - in);
        heights_[i] = (out * out + out * in + in * in) / (6 * radius);
        slopes_[i] = middles_[i] / radius;
        // The load within x, Johnson (1985), eq. 2.25.
        for (Eigen::Index j = 0; j < i; ++j) along_(i, j) = -coupling / 4 * areas_[j];
        along_(i, i) = -coupling / 4 * 2 * (middles_[i] - in);
    }
    stiff_ = strips_matrix(thickness ? 1 / substrate.plane_compliance() : pair.effective_modulus(),
                           thickness);
    tangential_ = stiff_;  // C11 of the half-space is its C33
    if (!thickness) return;
    const theory::ElasticLayer layer = comparisons::elastic_layer(c);
    const Waves waves{.last = last_strip_wave,
                      .panel = std::min(1., 12 * *thickness / (2 * edges_.back())),
                      .points = points_of_strip_waves,
                      .stiff = [](double) { return 1 / pi; },
                      .along = [](double) { return -1 / pi; },
                      .within = [](double k, double x) { return 2 * std::sin(k * x) / k; },
                      .beside = [](double k, double x) { return std::sin(k * x); }};
    add_layer(*thickness, waves, [&](double k) -> Lacks {
        const auto compliance = theory::layer_compliance(layer, k);
        const double taken = (1 - nu) / (g * k) * -std::expm1(-k * *thickness);
        return {compliance.normal - taken, compliance.along - taken,
                compliance.coupling - (1 - 2 * nu) / (2 * g * k)};
    });
}

// (1/pi) ∫ C cos(k x) dk with C = 2/(E* k) is -2/(pi E*) ln x, and with 2/(E* k) (1 - exp(-k b))
// it is 1/(pi E*) ln(1 + b^2/x^2): both integrated over pairs of strips.
Eigen::MatrixXd RingContact::strips_matrix(double modulus, std::optional<double> thickness) const {
    const Eigen::Index n = areas_.size();
    const double scale = 4 * edges_.back();  // lengths below it have a positive energy
    const auto kernel = [&](double x) {
        const double logarithm = twice_integrated_log(x, 0, scale);
        return 2 / (pi * modulus) *
               (thickness ? twice_integrated_log(x, *thickness, scale) - logarithm : -logarithm);
    };
    const auto pair = [&](double low, double high, double from, double to) {
        return kernel(high - from) - kernel(high - to) - kernel(low - from) + kernel(low - to);
    };
    Eigen::MatrixXd matrix(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j)
            matrix(i, j) = 2 * (pair(edges_[i], edges_[i + 1], edges_[j], edges_[j + 1]) +
                                pair(edges_[i], edges_[i + 1], -edges_[j + 1], -edges_[j]));
    return matrix;
}

}  // namespace tricontact::benchmarks
