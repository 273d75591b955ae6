#pragma once

#include <span>
#include <string_view>

#include "contact/models/model_kind.h"

namespace tricontact::io {

/// A model that explains measured tables, a word of `measurement.models`: a closed form or theory,
/// or a model of cases. Whoever adds one adds its row in measurement_models.cc.
struct MeasurementModel {
    const char* name;
    /// The model of cases that takes the same as given; computes its shifts, if it is of a layer.
    const char* model;
    /// The model of cases whose rules its rig has to keep: where tables have tangential forces, and
    /// where they have none. Empty: no rules.
    const char* rules = model;
    const char* pressed_rules = rules;
    bool is_layer = true;   ///< or the half-space, by closed forms
    bool is_theory = true;  ///< exact without tangential force, where there is such a theory
    bool approximates_theory = false;  ///< that of the layer, which then answers
    bool finds_poisson = true;         ///< without tangential force
    bool shifts_find_poisson = false;  ///< with it
    bool knows_laws = false;           ///< other ones than Coulomb's, and springs of the interface
    bool has_rolling_shift = true;     ///< how far free rolling shifts a contact

    const contact::ModelKind& kind() const { return contact::model_kind(model); }
};

/// The more complete the later.
std::span<const MeasurementModel> measurement_models();
/// Null for other words.
const MeasurementModel* find_measurement_model(std::string_view name);
/// Throws std::out_of_range.
const MeasurementModel& measurement_model(std::string_view name);
/// The exact theory of the layer, which maps and cells approximate where there is no tangential
/// force.
const MeasurementModel& layer_theory();

}  // namespace tricontact::io
