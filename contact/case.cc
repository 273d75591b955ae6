#include "contact/case.h"

#include <cmath>
#include <numbers>

#include "contact/line_contact_scales.h"
#include "contact/rough_scales.h"

namespace tricontact::contact {

double Case::Layer::total_thickness() const {
    double sum = *thickness;
    for (const Lower& one : lower) sum += one.thickness;
    return sum;
}

// Hertz (1882); Johnson (1985), ch. 4: a^2 = R d, F_N = 4/3 E* sqrt(R) d^(3/2).
HalfSpaceScales half_space_scales(const Case& c) {
    if (is_nominally_flat(c)) return rough_scales(c);
    if (c.is_line_contact()) return line_contact_scales(c);
    const MaterialPair materials = c.materials();
    const double e_star = materials.effective_modulus();
    const double radius = c.indenter.radius;
    const double d =
        c.load.indentation
            ? *c.load.indentation
            : std::pow(3 * *c.load.normal_force / (4 * e_star * std::sqrt(radius)), 2. / 3);
    return {
        .contact_radius = std::sqrt(radius * d),
        .indentation = d,
        .normal_force = 4. / 3 * e_star * std::sqrt(radius) * std::pow(d, 1.5),
        .peak_pressure = 2 / std::numbers::pi * e_star * std::sqrt(d / radius),
        .unit_shift = c.friction_coefficient * e_star / materials.effective_shear_modulus() * d};
}

double rolling_amplitude(const Case::Rolling& rolling, double reference_radius) {
    return rolling.amplitude ? *rolling.amplitude : *rolling.amplitude_ratio * reference_radius;
}

}  // namespace tricontact::contact
