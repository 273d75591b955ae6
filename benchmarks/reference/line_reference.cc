#include <algorithm>
#include <cmath>

#include "benchmarks/reference/exact_parts.h"
#include "benchmarks/reference/plane_contact.h"

namespace tricontact::benchmarks {

namespace {

using contact::Case;
using contact::NormalControl;
namespace keys = quantity_keys;

constexpr double line_accuracy = 1e-9;  // of the exact contact, see theory/layer/line_contact.h

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

std::string line_theory(const Case& c) {
    return c.layer.thickness ? "exact layer under a cylinder" : "Hertz (1882)";
}

}  // namespace

void refer_line(Reference& reference, const contact::ModelRunner& runner) {
    const Case& c = reference.c;
    const NormalControl control = final_normal(c);
    const PlaneContact contact(c, control);
    const std::string source = line_theory(c);
    reference.contact_radius = contact.half_width();
    reference.models = {source};
    for (const auto& [key, value] : exact_line_scalars(contact))
        reference.values[key] = {
            .value = value, .grid = line_accuracy * std::abs(value), .source = source};
    compare_with_cells(reference, pressed_alone(c, control), runner);
    const RadialFields::Bars bars{
        .pressure = relative_bar(reference, keys::peak_pressure),
        .radius = relative_bar(reference, keys::contact_radius),
        .displacement = std::max(relative_bar(reference, keys::normal_force),
                                 relative_bar(reference, keys::indentation))};
    reference.fields = std::make_shared<RadialFields>(
        true, contact.half_width(), bars, [&](double x) -> RadialFields::Values {
            return {contact.pressure(x), contact.displacement_along(x),
                    contact.normal_displacement(x), contact.load_within(x)};
        });
    add_pressing_effects(reference, control, contact.half_width() / c.indenter.radius,
                         [&](const NormalControl& near) -> EnvelopeIntegrals {
                             const PlaneContact state(c, near);
                             return {.pressure_squared = state.pressure_squared(),
                                     .work_of_slope = state.work_of_slope()};
                         });
    if (control.kind == NormalControl::Kind::force) return;
    if (!c.layer.thickness)
        reference.remarks.emplace_back(
            "the depth of a line contact on the half-space is that of a body of the case's length");
}

void take_exact_line(Reference& reference) {
    if (!has_exact_line_contact(reference.c)) return;
    const PlaneContact contact(reference.c, final_normal(reference.c));
    const std::string source = line_theory(reference.c);
    for (const auto& [key, value] : exact_line_scalars(contact)) {
        if (key == keys::stored_energy) continue;  // that of tractions is not in it
        const auto computed = reference.values.find(key);
        const double difference =
            computed == reference.values.end() ? 0 : std::abs(computed->second.value - value);
        reference.values[key] = {.value = value,
                                 .grid = line_accuracy * std::abs(value),
                                 .model = difference,
                                 .source = source};
    }
    reference.models.push_back(source);
}

}  // namespace tricontact::benchmarks
