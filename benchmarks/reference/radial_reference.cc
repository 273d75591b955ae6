#include <algorithm>
#include <cmath>
#include <numbers>

#include "benchmarks/reference/exact_parts.h"
#include "benchmarks/reference/radial_contact.h"
#include "benchmarks/reference/reference_kinds.h"
#include "contact/half_space_scales.h"

namespace tricontact::benchmarks {

namespace {

using contact::Case;
using contact::NormalControl;
using std::numbers::pi;
namespace keys = quantity_keys;

double largest_pressure(const RadialContact& contact) {
    double largest = contact.pressure(0);
    for (int i = 1; i < 400; ++i)
        largest = std::max(largest, contact.pressure(contact.radius() * std::sin(i * pi / 800)));
    return largest;
}

std::map<std::string, double> exact_scalars(const Case& c, const RadialContact& contact) {
    const double a = contact.radius();
    std::map<std::string, double> values{{keys::normal_force, contact.force()},
                                         {keys::indentation, contact.indentation()},
                                         {keys::contact_radius, a},
                                         {keys::contact_area, pi * a * a},
                                         {keys::stored_energy, contact.stored_energy()},
                                         {keys::normal_stiffness, contact.stiffness()}};
    if (!contact::has_conical_tip(c)) values[keys::peak_pressure] = largest_pressure(contact);
    return values;
}

std::string theory_name(const Case& c) {
    if (c.layer.thickness) return "exact layer, Lebedev and Ufliand (1958)";
    return contact::is_hertz_round(c) && c.indenter.shape == Case::Shape::paraboloid
               ? "Hertz (1882)"
               : "Sneddon (1965)";
}

std::shared_ptr<const RadialFields> radial_fields(Reference& reference,
                                                  const RadialContact& contact) {
    const bool has_tip = contact::has_conical_tip(reference.c);
    const RadialFields::Bars bars{
        .pressure = relative_bar(reference, has_tip ? keys::normal_force : keys::peak_pressure),
        .radius = relative_bar(reference, keys::contact_radius),
        .displacement = std::max(relative_bar(reference, keys::indentation),
                                 relative_bar(reference, keys::normal_force))};
    if (has_tip)
        reference.remarks.emplace_back(
            "the pressure under the tip is infinite: the field is cut at a thousandth of the "
            "contact's radius");
    // Under a tip the table begins beside the axis.
    const double nearest = has_tip ? 1e-3 * contact.radius() : 0;
    return std::make_shared<RadialFields>(
        false, contact.radius(), bars, [&](double r) -> RadialFields::Values {
            return {contact.pressure(std::max(r, nearest)), contact.radial_displacement(r),
                    contact.normal_displacement(r), contact.load_within(r)};
        });
}

void add_radial_effects(Reference& reference, const NormalControl& control, double radius) {
    const Case& c = reference.c;
    add_pressing_effects(reference, control, c.make_axisymmetric_indenter()->profile_slope(radius),
                         [&](const NormalControl& near) -> EnvelopeIntegrals {
                             const RadialContact state(c, near);
                             return {.pressure_squared = state.pressure_squared(),
                                     .work_of_slope = state.work_of_slope()};
                         });
}

}  // namespace

void refer_radial(Reference& reference, const contact::ModelRunner& runner) {
    const Case& c = reference.c;
    const NormalControl control = final_normal(c);
    const RadialContact contact(c, control);
    reference.contact_radius = contact.radius();
    set_exact_values(reference, exact_scalars(c, contact), theory_name(c));
    const Case pressed = pressed_alone(c, control);
    compare_with_springs(reference, pressed, runner);
    compare_with_cells(reference, pressed, runner);
    reference.fields = radial_fields(reference, contact);
    add_radial_effects(reference, control, contact.radius());
}

void take_radial_pressing(Reference& reference,
                          const std::shared_ptr<const TabledFields>& shearing) {
    const NormalControl control = final_normal(reference.c);
    const RadialContact contact(reference.c, control);
    replace_by_exact(reference, exact_scalars(reference.c, contact), theory_name(reference.c));
    reference.contact_radius = contact.radius();
    reference.fields = std::make_shared<SplitFields>(radial_fields(reference, contact), shearing);
    add_radial_effects(reference, control, contact.radius());
}

}  // namespace tricontact::benchmarks
