#include "theory/layer/line_layer_forms.h"

#include <cmath>

#include "theory/oscillating_cylinder.h"

namespace tricontact::theory {

namespace {

struct Line {
    double beta, chi, q, s;
};

Line line_of(const LayerForm& layer) {
    check(layer);
    const double beta = 2 * layer.thickness_ratio, q = layer.poisson / (1 - layer.poisson);
    return {beta, 1 / beta, q, std::pow(q, 1.4)};
}

}  // namespace

double line_layer_width_ratio(const LayerForm& layer) {
    const auto [beta, chi, q, s] = line_of(layer);
    const double square = chi * chi;
    return 1 / std::sqrt(1 + (.623 + .324 * s) * square / std::sqrt(1 + (2.17 - .56 * s) * square));
}

double line_layer_pressure_shape(const LayerForm& layer) {
    const auto [beta, chi, q, s] = line_of(layer);
    const double cube = chi * chi * chi;
    return (.065 + .033 * s) * cube * chi / (1 + 2.14 * cube);
}

double line_layer_pressure_ratio(const LayerForm& layer) {
    return (1 + line_layer_pressure_shape(layer)) / line_layer_width_ratio(layer);
}

double line_layer_shift_factor(const LayerForm& layer) {
    const auto [beta, chi, q, s] = line_of(layer);
    return 1.331 + .628 * q - .076 * q * q +
           .5 * std::log(beta * beta + (.315 + .172 * q) * beta + .249 + .104 * q);
}

double line_layer_depth_factor(const LayerForm& layer) {
    const auto [beta, chi, q, s] = line_of(layer);
    return .801 - .143 * q - .471 * q * q +
           .5 * std::log(beta * beta + (.34 - .021 * s + .173 * s * s) * beta + .401 + .334 * s +
                         .093 * s * s);
}

double line_layer_shakedown_limit(const LayerForm& layer, double w) {
    const double shape = line_layer_pressure_shape(layer);
    return line_shakedown_limit(w) - 1.24 * shape * w * std::pow((1 - w) * (1 + w), 1.5);
}

}  // namespace tricontact::theory
