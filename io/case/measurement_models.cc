#include "io/case/measurement_models.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace tricontact::io {

namespace {

namespace models = contact::models;

constexpr std::array kinds{
    MeasurementModel{.name = "half-space",
                     .model = models::bem,
                     .rules = "",
                     .is_layer = false,
                     .shifts_find_poisson = true,
                     .knows_laws = true},
    MeasurementModel{.name = "layer",
                     .model = models::mdr_layer,
                     .pressed_rules = models::mdr,
                     .knows_laws = true},
    MeasurementModel{.name = models::atlas,
                     .model = models::atlas,
                     .rules = models::bem_layer,
                     .is_theory = false,
                     .approximates_theory = true,
                     .shifts_find_poisson = true,
                     .has_rolling_shift = false},
    MeasurementModel{.name = models::bem_layer,
                     .model = models::bem_layer,
                     .is_theory = false,
                     .approximates_theory = true},
    MeasurementModel{
        .name = models::fem, .model = models::fem, .is_theory = false, .finds_poisson = false},
};

}  // namespace

std::span<const MeasurementModel> measurement_models() {
    return kinds;
}

const MeasurementModel* find_measurement_model(std::string_view name) {
    const auto found = std::ranges::find(kinds, name, &MeasurementModel::name);
    return found == kinds.end() ? nullptr : &*found;
}

const MeasurementModel& measurement_model(std::string_view name) {
    if (const MeasurementModel* model = find_measurement_model(name)) return *model;
    throw std::out_of_range("no model of measurements: " + std::string(name));
}

const MeasurementModel& layer_theory() {
    return *std::ranges::find_if(
        kinds, [](const MeasurementModel& model) { return model.is_layer && model.is_theory; });
}

}  // namespace tricontact::io
