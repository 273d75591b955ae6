#include <cmath>

#include "benchmarks/reference/exact_parts.h"
#include "benchmarks/reference/plane_contact.h"
#include "comparisons/quantities/reference.h"
#include "contact/half_space_scales.h"
#include "theory/creep_law.h"

namespace tricontact::benchmarks {

namespace {

using contact::Case;
namespace keys = quantity_keys;

constexpr int carter_points = 2001;  // of tractions, along x

/// f = F_T/(mu F_N), in (0, 1] of what drives the case along the rolling; 0 of nothing.
double driving_ratio(const Case& c, const PlaneContact& contact) {
    const double mu = c.friction_coefficient();
    if (const auto creepage = c.tractive_rolling->longitudinal_creepage)
        return *creepage > 0 ? theory::carter_force_ratio(*creepage * c.indenter.radius /
                                                          (mu * contact.half_width()))
                             : 0;
    return comparisons::tangential_ratio(c,
                                         {contact.load() * c.indenter.length, contact::undefined});
}

/// Tractions of Carter's contact, rolling towards +x; displacements are not known.
std::shared_ptr<const GridFields> carter_tractions(const Case& c, const PlaneContact& contact,
                                                   double f) {
    const double a = contact.half_width(), h = 2 * a / (carter_points - 1);
    const double bound = c.friction_coefficient() * contact.centre_pressure();
    GridFields::Channels values, bars;
    for (std::size_t k = 0; k < values.size(); ++k) {
        constexpr std::size_t first_displacement = 3;
        const double rest = k < first_displacement ? 0 : contact::undefined;
        values[k].assign(carter_points, rest);
        bars[k] = values[k];
    }
    for (int i = 0; i < carter_points; ++i) {
        const double x = i + 1 == carter_points ? a : -a + i * h;
        values[0][i] = contact.pressure(x);
        values[1][i] = bound * theory::carter_traction(x / a, f);
    }
    return std::make_shared<GridFields>(GridFields::Grid{carter_points, 1, -a, 0, h, h},
                                        std::move(values), std::move(bars));
}

}  // namespace

bool has_carter(const Case& c) {
    if (!c.tractive_rolling || !c.is_line_contact() || c.layer.thickness || !is_uncoupled(c))
        return false;
    const Case::TractiveRolling& rolling = *c.tractive_rolling;
    if (rolling.lateral_creepage.value_or(0) != 0 || rolling.spin != 0) return false;
    const double f = driving_ratio(c, PlaneContact(c, final_normal(c)));
    return f > 0 && f < 1;
}

void refer_carter(Reference& reference) {
    const Case& c = reference.c;
    const contact::NormalControl control = final_normal(c);
    const PlaneContact contact(c, control);
    const double f = driving_ratio(c, contact), mu = c.friction_coefficient();
    const double a = contact.half_width();
    reference.contact_radius = a;
    set_exact_values(reference, exact_line_scalars(contact), "Hertz (1882)");
    set_exact_values(
        reference,
        {{keys::tangential_force, f * mu * contact.load()},
         {keys::stick_area, 2 * a * theory::carter_stick_ratio(f)},
         {keys::creepage, theory::carter_creepage_ratio(f) * mu * a / c.indenter.radius}},
        "Carter (1926)");
    reference.has_tractions = true;
    reference.fields = carter_tractions(c, contact, f);
    add_line_effects(reference, control, a);
    reference.remarks.emplace_back("steady rolling towards +x; no other model is compared");
}

}  // namespace tricontact::benchmarks
