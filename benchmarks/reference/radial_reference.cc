#include <algorithm>
#include <cmath>
#include <numbers>

#include "benchmarks/reference/model_levels.h"
#include "benchmarks/reference/radial_contact.h"
#include "benchmarks/reference/reference_kinds.h"
#include "contact/base/stopped.h"
#include "contact/half_space_scales.h"
#include "contact/models/model_kind.h"

namespace tricontact::benchmarks {

namespace {

using contact::Case;
using contact::NormalControl;
using std::numbers::pi;
namespace keys = quantity_keys;

constexpr double theory_accuracy = 1e-9;  // of the exact contact, see elastic_layer.h
constexpr double difference_step = .01;   // of depth or force, in effects

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

/// The largest differences from the exact values, by key, of models that are exact for pressing.
class ModelDifferences {
  public:
    explicit ModelDifferences(Reference& reference) : reference_(reference) {}

    void add(const std::string& model, const std::map<std::string, double>& values) {
        reference_.models.push_back(model);
        for (const auto& [key, value] : values) {
            const auto found = reference_.values.find(key);
            if (found == reference_.values.end()) continue;
            double& difference = found->second.model;
            difference = std::max(difference, std::abs(value - found->second.value));
        }
    }
    /// A model that did not run stands behind nothing.
    template <class Run>
    void try_to(const std::string& model, const Run& run) {
        const std::string why = contact::why_it_stopped(run);
        if (!why.empty()) reference_.remarks.push_back(model + " is not compared: " + why);
    }

  private:
    Reference& reference_;
};

/// Areas of cells and springs are counted; that of the contact's radius is not.
std::map<std::string, double> smooth_scalars(const Case& c, const EndState& end) {
    auto values = scalars_of(c, end);
    values[keys::contact_area] = pi * end.scales.contact_radius * end.scales.contact_radius;
    return values;
}

void compare_springs(ModelDifferences& differences, const Case& pressed,
                     const contact::ModelRunner& runner) {
    const std::string model =
        pressed.layer.thickness ? contact::models::mdr_layer : contact::models::mdr;
    differences.try_to(model, [&] {
        differences.add(model, smooth_scalars(pressed, end_state(runner, model, pressed)));
    });
}

void compare_cells(ModelDifferences& differences, const Case& pressed,
                   const contact::ModelRunner& runner) {
    const std::string model =
        pressed.layer.thickness ? contact::models::bem_layer : contact::models::bem;
    differences.try_to(model, [&] {
        std::map<std::string, double> values;
        for (const auto& [key, value] :
             values_of_levels(pressed, end_states(runner, model, pressed), model))
            if (key != keys::contact_area) values[key] = value.value;
        values[keys::contact_area] =
            pi * values[keys::contact_radius] * values[keys::contact_radius];
        differences.add(model, values);
    });
}

NormalControl scaled(NormalControl control, double factor) {
    control.value *= factor;
    return control;
}

/// -1/2 d/dd under a depth, 1/2 d/dF under a force, of ∫ p^2 dA; twice that of ∫ p h' u_r dA.
void add_effects(Reference& reference, const NormalControl& control, double edge_slope) {
    double squares[4], works[4];
    const double factors[] = {1 - 2 * difference_step, 1 - difference_step, 1 + difference_step,
                              1 + 2 * difference_step};
    for (int k = 0; k < 4; ++k) {
        const RadialContact contact(reference.c, scaled(control, factors[k]));
        squares[k] = contact.pressure_squared();
        works[k] = contact.work_of_slope();
    }
    const double sign = control.kind == NormalControl::Kind::force ? 1 : -1;
    const double step = difference_step * control.value;
    const auto effect = [&](const double(&f)[4], double factor) {
        ReferenceValue value = central_difference(step, f[0], f[1], f[2], f[3]);
        value.value *= factor;
        value.grid *= std::abs(factor);
        value.source = "envelope theorem";
        return value;
    };
    reference.effects.normal_compliance = effect(squares, sign / 2);
    reference.effects.displaced_surface = effect(works, sign);
    reference.effects.displaced_surface->model =
        second_order_of_slope * edge_slope * std::abs(reference.effects.displaced_surface->value);
}

double relative_bar(const Reference& reference, const char* key) {
    const ReferenceValue* value = reference.find(key);
    return value && value->value != 0 ? std::abs(value->bar() / value->value) : 0;
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
    ModelDifferences differences(reference);
    compare_springs(differences, pressed, runner);
    compare_cells(differences, pressed, runner);
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
    add_effects(reference, control, body->profile_slope(contact.radius()));
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
