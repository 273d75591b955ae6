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

constexpr double theory_accuracy = 1e-9;  // of the exact contact, see elastic_layer.h

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

}  // namespace

void refer_radial(Reference& reference, const contact::ModelRunner& runner) {
    const Case& c = reference.c;
    const NormalControl control = final_normal(c);
    const RadialContact contact(c, control);
    const std::string source = theory_name(c);
    reference.contact_radius = contact.radius();
    reference.models = {source};
    for (const auto& [key, value] : exact_scalars(c, contact))
        reference.values[key] = {
            .value = value, .grid = theory_accuracy * std::abs(value), .source = source};
    const Case pressed = pressed_alone(c, control);
    compare_with_springs(reference, pressed, runner);
    compare_with_cells(reference, pressed, runner);
    const auto body = c.make_axisymmetric_indenter();
    const bool has_tip = contact::has_conical_tip(c);
    const RadialFields::Bars bars{
        .pressure = relative_bar(reference, has_tip ? keys::normal_force : keys::peak_pressure),
        .radius = relative_bar(reference, keys::contact_radius),
        .displacement = std::max(relative_bar(reference, keys::indentation),
                                 relative_bar(reference, keys::normal_force))};
    // Under a tip the pressure is infinite at the axis: the table begins beside it.
    const double nearest = has_tip ? 1e-3 * contact.radius() : 0;
    reference.fields = std::make_shared<RadialFields>(
        false, contact.radius(), bars, [&](double r) -> RadialFields::Values {
            return {contact.pressure(std::max(r, nearest)), contact.radial_displacement(r),
                    contact.normal_displacement(r), contact.load_within(r)};
        });
    if (has_tip)
        reference.remarks.emplace_back(
            "the pressure under the tip is infinite: the field is cut at a thousandth of the "
            "contact's radius");
    add_pressing_effects(reference, control, body->profile_slope(contact.radius()),
                         [&](const NormalControl& near) -> EnvelopeIntegrals {
                             const RadialContact state(c, near);
                             return {.pressure_squared = state.pressure_squared(),
                                     .work_of_slope = state.work_of_slope()};
                         });
}

void take_exact_pressing(Reference& reference) {
    const Case& c = reference.c;
    if (!has_exact_radial_contact(c)) return;
    const RadialContact contact(c, final_normal(c));
    const std::string source = theory_name(c);
    for (const auto& [key, value] : exact_scalars(c, contact)) {
        if (key == keys::stored_energy) continue;  // that of tractions is not in it
        const auto computed = reference.values.find(key);
        const double difference =
            computed == reference.values.end() ? 0 : std::abs(computed->second.value - value);
        reference.values[key] = {.value = value,
                                 .grid = theory_accuracy * std::abs(value),
                                 .model = difference,
                                 .source = source};
    }
    reference.models.push_back(source);
}

}  // namespace tricontact::benchmarks
