#include "theory/layer/layer_forms.h"

#include <cmath>
#include <stdexcept>

#include "contact/base/special_values.h"
#include "theory/cattaneo_mindlin.h"
#include "theory/layer/layer_compliance.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::theory {

namespace {

/// chi and the layer's constants.
struct Constants {
    double chi, incompressibility, lift, tangential_lift, bending;
};

Constants constants_of(const LayerForm& layer) {
    check(layer);
    const double nu = layer.poisson;
    const double s = std::pow(nu / (1 - nu), 1.4);
    return {.chi = 1 / (2 * layer.thickness_ratio),
            .incompressibility = s,
            .lift = .514 + .237 * s,
            .tangential_lift = .325 - .1 * nu + .07 * nu * nu,
            .bending = .266 + .276 * s};
}

/// u of the layer from that of the half-space.
double lifted(const LayerForm& layer, double u, double f) {
    const Constants c = constants_of(layer);
    const double lift = c.tangential_lift * c.chi / (1 + c.chi / 2);
    return (u - lift * f) / (1 - lift);
}

}  // namespace

void check(const LayerForm& layer) {
    if (!(layer.thickness_ratio >= .25))
        throw std::domain_error("layer forms: b/D_c must be 0.25 or more");
    if (!(layer.poisson >= 0 && layer.poisson <= .5))
        throw std::domain_error("layer forms: nu must lie in [0, 1/2]");
}

double layer_radius_ratio(const LayerForm& layer) {
    const auto [chi, s, lift, tangential_lift, bending] = constants_of(layer);
    const double square = chi * chi;
    return 1 / std::sqrt(1 + bending * chi * square / (1 + (1.35 + .25 * s) * square));
}

double layer_indentation_ratio(const LayerForm& layer) {
    const auto [chi, s, lift, tangential_lift, bending] = constants_of(layer);
    const double lifted = lift * chi;
    return 1 / (1 + lifted + lifted * lifted / (1 + (1.37 - .82 * s) * chi * chi));
}

double layer_pressure_shape(const LayerForm& layer) {
    const Constants c = constants_of(layer);
    const double fourth = std::pow(c.chi, 4);
    return (.083 + .058 * c.incompressibility) * fourth * c.chi / (1 + 1.1 * fourth);
}

double layer_pressure_ratio(const LayerForm& layer) {
    const double radius = layer_radius_ratio(layer);
    return (1 + 2 * layer_pressure_shape(layer) / 3) / (radius * radius);
}

double layer_unit_shift_ratio(const LayerForm& layer) {
    const auto [chi, s, lift, tangential_lift, bending] = constants_of(layer);
    const double square = chi * chi;
    const double next = tangential_lift * tangential_lift + (.172 + .046 * s) * chi;
    return layer_pressure_ratio(layer) /
           (1 + tangential_lift * chi + square * next / (1 + .64 * square));
}

double layer_shakedown_limit(const LayerForm& layer, double w) {
    if (!(w >= 0 && w <= .85)) throw std::domain_error("layer forms: w must lie in [0, 0.85]");
    const double shape = layer_pressure_shape(layer), rest = (1 - w) * (1 + w);
    return shakedown_limit(w) - .375 * shape * w * std::pow(rest, 2 + shape);
}

double layer_static_shift_ratio(const LayerForm& layer, double f) {
    return lifted(layer, static_shift_ratio(f), f);
}

double layer_coupling(const LayerForm& layer, double friction) {
    check(layer);
    if (!(friction >= .4)) throw std::domain_error("layer forms: mu must be 0.4 or more");
    // x = k b at k = 2/a_H, b = 2 a_H b/D_c.
    return bonded_coupling_ratio(layer.poisson, 4 * layer.thickness_ratio) / friction;
}

std::optional<double> layer_settled_shift_ratio(const LayerForm& layer, const MappedRolling& point,
                                                double friction) {
    const double coupling = layer_coupling(layer, friction);
    const double w = point.amplitude_ratio, f = point.tangential_ratio;
    MappedRolling own = point;
    own.poisson = layer.poisson;
    const double half_space = half_space_settled_shift_ratio(own).value_or(contact::undefined);
    if (std::isnan(half_space) || f > layer_shakedown_limit(layer, w)) return std::nullopt;
    return lifted(layer, half_space, f) * (1 + coupling * coupling * w);
}

}  // namespace tricontact::theory
