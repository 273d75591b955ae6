#include "theory/layer/layer_stack.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "contact/error.h"
#include "theory/layer/interior_waves.h"
#include "theory/layer/layer_compliance.h"

namespace tricontact::theory {

namespace {

using contact::Material;

LayerCompliance half_space_compliance(const Material& material, double k) {
    const double scale = 1 / (material.shear_modulus() * k), nu = material.poisson;
    return {(1 - nu) * scale, (1 - nu) * scale, scale, (1 - 2 * nu) / 2 * scale};
}

LayerCompliance by_propagation(const LayerStack& stack, double k) {
    const InteriorWaves surface = interior_waves(stack, k, std::array{0.}).front();
    // u_along = i C13 p: of a cosine as -sin; u_z = -i C13 t_along: as sin.
    return {surface.pressed.u_z, surface.sheared.u_along, surface.across_u,
            (surface.sheared.u_z - surface.pressed.u_along) / 2};
}

}  // namespace

double LayerStack::thickness() const {
    double sum = 0;
    for (const Sheet& sheet : sheets) sum += sheet.thickness;
    return sum;
}

void check(const LayerStack& stack) {
    if (stack.sheets.empty())
        throw contact::InputError("layer: a stack needs at least one layer; add one");
    for (const auto& sheet : stack.sheets)
        check(ElasticLayer{sheet.material, sheet.thickness, stack.base});
    if (stack.half_space) contact::MaterialPair({}, *stack.half_space);
}

LayerCompliance surface_compliance(const LayerStack& stack, double wave_number) {
    check(stack);
    const auto& top = stack.sheets.front();
    if (stack.sheets.size() == 1 && !stack.half_space)
        return layer_compliance({top.material, top.thickness, stack.base}, wave_number);
    if (!(wave_number > 0) || !std::isfinite(wave_number))
        throw contact::InputError(fmt::format(
            "layer: the wave number must be positive and finite, but is {:.6g} 1/m; use the length "
            "of the wave vector",
            wave_number));
    if (wave_number * top.thickness >= half_space_from)
        return half_space_compliance(top.material, wave_number);
    return by_propagation(stack, wave_number);
}

double softest_wave_number(const LayerStack& stack) {
    double softness = 1;
    if (stack.half_space)
        for (const auto& sheet : stack.sheets)
            softness = std::min(softness,
                                stack.half_space->shear_modulus() / sheet.material.shear_modulus());
    // A membrane of the stiffness G b on the ground: u changes at k = G_ground/(G b).
    return std::min(1e-4, 1e-2 * softness) / stack.thickness();
}

}  // namespace tricontact::theory
