#include "benchmarks/reference/exact_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "contact/base/stopped.h"
#include "contact/half_space_scales.h"
#include "contact/models/model_kind.h"

namespace tricontact::benchmarks {

namespace {

using contact::Case;
using contact::NormalControl;
namespace keys = quantity_keys;

constexpr double difference_step = .01;   // of depth or force, in effects
constexpr double theory_accuracy = 1e-9;  // see elastic_layer.h and line_contact.h

/// Cells and springs are counted; that of the contact's radius is not.
double smooth_area(const Case& c, double radius) {
    return c.is_line_contact() ? 2 * radius : std::numbers::pi * radius * radius;
}

void note_differences(Reference& reference, const std::string& model,
                      const std::map<std::string, double>& values) {
    reference.models.push_back(model);
    for (const auto& [key, value] : values) {
        const auto found = reference.values.find(key);
        if (found == reference.values.end()) continue;
        double& difference = found->second.model;
        difference = std::max(difference, std::abs(value - found->second.value));
    }
}

/// A model that did not run stands behind nothing.
template <class Run>
void try_to(Reference& reference, const std::string& model, const Run& run) {
    const std::string why = contact::why_it_stopped(run);
    if (!why.empty()) reference.remarks.push_back(model + " is not compared: " + why);
}

}  // namespace

void set_exact_values(Reference& reference, const std::map<std::string, double>& exact,
                      const std::string& source) {
    reference.models.push_back(source);
    for (const auto& [key, value] : exact)
        reference.values[key] = {
            .value = value, .grid = theory_accuracy * std::abs(value), .source = source};
}

void replace_by_exact(Reference& reference, const std::map<std::string, double>& exact,
                      const std::string& source) {
    reference.models.push_back(source);
    for (const auto& [key, value] : exact) {
        if (key == keys::stored_energy) continue;
        const auto computed = reference.values.find(key);
        double difference =
            computed == reference.values.end() ? 0 : std::abs(computed->second.value - value);
        if (key == keys::contact_area)  // not what cells count
            difference = std::abs(smooth_area(reference.c, reference.contact_radius) - value);
        reference.values[key] = {.value = value,
                                 .grid = theory_accuracy * std::abs(value),
                                 .model = difference,
                                 .source = source};
    }
}

void compare_with_springs(Reference& reference, const Case& pressed,
                          const contact::ModelRunner& runner) {
    const std::string model =
        pressed.layer.thickness ? contact::models::mdr_layer : contact::models::mdr;
    try_to(reference, model, [&] {
        const EndState end = end_state(runner, model, pressed);
        auto values = scalars_of(pressed, end);
        values[keys::contact_area] = smooth_area(pressed, end.scales.contact_radius);
        // Theirs is that of the centre.
        if (!contact::pressure_falls(pressed)) values.erase(keys::peak_pressure);
        note_differences(reference, model, values);
    });
}

void compare_with_cells(Reference& reference, const Case& pressed,
                        const contact::ModelRunner& runner) {
    const std::string model =
        pressed.layer.thickness ? contact::models::bem_layer : contact::models::bem;
    try_to(reference, model, [&] {
        std::map<std::string, double> values;
        for (const auto& [key, value] :
             values_of_levels(pressed, end_states(runner, model, pressed), model))
            values[key] = value.value;
        values[keys::contact_area] = smooth_area(pressed, values.at(keys::contact_radius));
        note_differences(reference, model, values);
    });
}

// -1/2 d/dd under a depth, 1/2 d/dF under a force, of the squares; twice that of the works.
void add_pressing_effects(
    Reference& reference, const NormalControl& control, double edge_slope,
    const std::function<EnvelopeIntegrals(const NormalControl&)>& integrals_at) {
    std::array<EnvelopeIntegrals, 4> states;
    constexpr std::array steps{-2., -1., 1., 2.};
    for (std::size_t k = 0; k < steps.size(); ++k)
        states[k] = integrals_at({control.kind, control.value * (1 + steps[k] * difference_step)});
    const auto effect = [&](double EnvelopeIntegrals::*f, double factor) {
        ReferenceValue value = central_difference(difference_step * control.value, states[0].*f,
                                                  states[1].*f, states[2].*f, states[3].*f);
        value.value *= factor;
        value.grid *= std::abs(factor);
        value.source = "envelope theorem";
        return value;
    };
    const double sign = control.kind == NormalControl::Kind::force ? 1 : -1;
    reference.effects.normal_compliance = effect(&EnvelopeIntegrals::pressure_squared, sign / 2);
    ReferenceValue displaced = effect(&EnvelopeIntegrals::work_of_slope, sign);
    displaced.model = second_order_of_slope * edge_slope * std::abs(displaced.value);
    reference.effects.displaced_surface = displaced;
}

double relative_bar(const Reference& reference, const char* key) {
    const ReferenceValue* value = reference.find(key);
    return value && value->value != 0 ? std::abs(value->bar() / value->value) : 0;
}

}  // namespace tricontact::benchmarks
