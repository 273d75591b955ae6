#include "contact/bodies/rough_scales.h"

#include <cmath>
#include <numbers>

namespace tricontact::contact {

namespace {

struct Spread {
    double height = 0, slope = 0;  // root mean squares [m], [-]
};

/// Map and roughness are independent of each other.
Spread spread(const Case::IndenterData& indenter) {
    Spread sum;
    if (const auto& map = indenter.height_map) sum = {rms_height(*map), rms_slope(*map)};
    if (const auto& r = indenter.roughness)
        sum = {std::hypot(sum.height, rms_height(*r)), std::hypot(sum.slope, r->rms_slope)};
    return sum;
}

}  // namespace

bool is_nominally_flat(const Case& c) {
    return c.indenter.shape == Case::Shape::flat || c.indenter.shape == Case::Shape::height_map;
}

double nominal_area(const Case& c) {
    if (c.bem.period) return *c.bem.period * *c.bem.period;
    const Vector2 side = c.indenter.height_map->period();
    return side[0] * side[1];
}

HalfSpaceScales rough_scales(const Case& c) {
    const MaterialPair materials = c.materials();
    const auto [height, slope] = spread(c.indenter);
    const double area = nominal_area(c), pressure = materials.effective_modulus() * slope / 2;
    const double radius = std::sqrt(area / std::numbers::pi);
    return {.contact_radius = radius,
            .indentation = height,
            .normal_force = c.load.normal_force.value_or(pressure * area),
            .peak_pressure = pressure,
            .unit_shift = c.friction_coefficient * materials.effective_modulus() /
                          materials.effective_shear_modulus() * height,
            .half_widths = {radius, radius}};
}

}  // namespace tricontact::contact
