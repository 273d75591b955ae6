#include <algorithm>
#include <cmath>

#include "benchmarks/reference/exact_parts.h"
#include "benchmarks/reference/plane_contact.h"

namespace tricontact::benchmarks {

namespace {

using contact::Case;
using contact::NormalControl;
namespace keys = quantity_keys;

std::string line_theory(const Case& c) {
    return c.layer.thickness ? "exact layer under a cylinder" : "Hertz (1882)";
}

std::shared_ptr<const RadialFields> line_fields(const Reference& reference,
                                                const PlaneContact& contact) {
    const RadialFields::Bars bars{
        .pressure = relative_bar(reference, keys::peak_pressure),
        .radius = relative_bar(reference, keys::contact_radius),
        .displacement = std::max(relative_bar(reference, keys::normal_force),
                                 relative_bar(reference, keys::indentation))};
    return std::make_shared<RadialFields>(
        true, contact.half_width(), bars, [&](double x) -> RadialFields::Values {
            return {contact.pressure(x), contact.displacement_along(x),
                    contact.normal_displacement(x), contact.load_within(x)};
        });
}

}  // namespace

std::map<std::string, double> exact_line_scalars(const PlaneContact& contact) {
    std::map<std::string, double> values{{keys::normal_force, contact.load()},
                                         {keys::contact_radius, contact.half_width()},
                                         {keys::contact_area, 2 * contact.half_width()},
                                         {keys::peak_pressure, contact.centre_pressure()}};
    const auto add = [&values](const char* key, const std::optional<double>& value) {
        if (value) values[key] = *value;
    };
    add(keys::indentation, contact.indentation());
    add(keys::normal_stiffness, contact.stiffness());
    add(keys::stored_energy, contact.stored_energy());
    return values;
}

void add_line_effects(Reference& reference, const NormalControl& control, double half_width) {
    const Case& c = reference.c;
    add_pressing_effects(reference, control, half_width / c.indenter.radius,
                         [&](const NormalControl& near) -> EnvelopeIntegrals {
                             const PlaneContact state(c, near);
                             return {.pressure_squared = state.pressure_squared(),
                                     .work_of_slope = state.work_of_slope()};
                         });
    if (control.kind == NormalControl::Kind::indentation && !c.layer.thickness)
        reference.remarks.emplace_back(
            "the depth of a line contact on the half-space is that of a body of the case's length");
}

void refer_line(Reference& reference, const contact::ModelRunner& runner) {
    const Case& c = reference.c;
    const NormalControl control = final_normal(c);
    const PlaneContact contact(c, control);
    reference.contact_radius = contact.half_width();
    set_exact_values(reference, exact_line_scalars(contact), line_theory(c));
    compare_with_cells(reference, pressed_alone(c, control), runner);
    reference.fields = line_fields(reference, contact);
    add_line_effects(reference, control, contact.half_width());
}

void take_line_pressing(Reference& reference, const std::shared_ptr<const TabledFields>& shearing) {
    const NormalControl control = final_normal(reference.c);
    const PlaneContact contact(reference.c, control);
    replace_by_exact(reference, exact_line_scalars(contact), line_theory(reference.c));
    reference.contact_radius = contact.half_width();
    reference.fields = std::make_shared<SplitFields>(line_fields(reference, contact), shearing);
    add_line_effects(reference, control, contact.half_width());
}

}  // namespace tricontact::benchmarks
