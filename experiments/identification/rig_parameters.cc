#include <algorithm>
#include <cmath>

#include "contact/base/error.h"
#include "experiments/identification/adhesion_parameter.h"
#include "experiments/identification/identification_reader.h"
#include "experiments/identification/interface_parameters.h"
#include "experiments/identification/law_parameters.h"
#include "experiments/identification/loop_parameters.h"
#include "experiments/identification/loop_values.h"
#include "io/case/measurement_models.h"

namespace tricontact::experiments {

namespace {

using Measurement = IdentificationInput::Measurement;
using Scale = FreeParameter::Scale;

// Around the value of the case.
constexpr double widest_length = 100, widest_time = 1e4;
// Around zero, of what the shifts would say alone; and the least of that.
constexpr double widest_pivot = 1e4, least_pivot_slope = 1e-9;
// Before the first row, in ranges of the table.
constexpr double widest_zero = 10;
// Of a Prony term, over the unrelaxed modulus.
constexpr double least_modulus = 1e-6, largest_modulus = .999;

FreeParameter length(std::string key, std::string name, std::string symbol, double start) {
    return {.key = std::move(key),
            .name = std::move(name),
            .symbol = std::move(symbol),
            .unit = "m",
            .low = start / widest_length,
            .high = start * widest_length,
            .start = start};
}

/// Dh = R dU/dW (Wetter 2016, 5.1.11), of the size that the tables' shifts over their offsets have.
FreeParameter pivot_height(const std::vector<const IdentificationInput::Table*>& rolled,
                           double radius) {
    const auto range = [](const std::vector<double>& values) {
        const auto [least, largest] = std::ranges::minmax(values);
        return largest - least;
    };
    double slope = least_pivot_slope;
    for (const auto* table : rolled)
        slope = std::max(slope, range(table->observed) / range(table->given));
    FreeParameter p{.key = std::string(pivot_key),
                    .name = "pivot_height_m",
                    .symbol = "Dh",
                    .unit = "m",
                    .scale = Scale::either_sign,
                    .size = radius * slope};
    p.high = widest_pivot * p.size;
    p.low = -p.high;
    return p;
}

/// Of the size of the table's range of depths. `n_tables`: each has one of its own.
FreeParameter zero_depth(const IdentificationInput::Table& pressed, std::size_t n_tables) {
    const auto [least, largest] = std::ranges::minmax(pressed.given);
    const double range = largest - least;
    if (!(range > 0)) throw contact::InputError("zero_depth: all depths are the same");
    const std::string number = n_tables > 1 ? std::to_string(pressed.place + 1) : "";
    return {.key = std::string(zero_depth_key),
            .index = pressed.place,
            .name = "zero_depth" + (number.empty() ? "" : "_" + number) + "_m",
            .symbol = "d_0" + (number.empty() ? "" : "_" + number),
            .unit = "m",
            .scale = Scale::either_sign,
            .low = least - widest_zero * range,
            .high = largest,
            .start = zero_depth_guess(pressed),
            .size = range};
}

/// All terms of the case's series.
void add_terms(const contact::Relaxation& relaxation, const std::string& key,
               std::vector<FreeParameter>& parameters) {
    for (std::size_t i = 0; i < relaxation.branches.size(); ++i) {
        const auto& [ratio, time] = relaxation.branches[i];
        const std::string number = std::to_string(i + 1);
        FreeParameter p{.key = key, .index = i};
        if (key == "substrate.relaxation.times") {
            p.name = "relaxation_time_" + number + "_s";
            p.symbol = "tau_" + number;
            p.unit = "s";
            p.low = time / widest_time;
            p.high = time * widest_time;
            p.start = time;
        } else {
            p.name = "relative_modulus_" + number;
            p.symbol = "g_" + number;
            p.scale = Scale::linear;
            p.low = least_modulus;
            p.high = largest_modulus;
            p.start = ratio / relaxation.instantaneous_ratio();
        }
        parameters.push_back(std::move(p));
    }
}

}  // namespace

double adhesive_pull(const IdentificationInput::Table& table) {
    if (!table.is_adhesive) return 0;
    const bool is_depth = table.measurement == Measurement::force_indentation;
    const double least = std::ranges::min(is_depth ? table.observed : table.given);
    constexpr double over_pull_off = 4. / 3;
    return over_pull_off * std::max(0., -least);
}

double zero_depth_guess(const IdentificationInput::Table& table) {
    const double pull = adhesive_pull(table);
    const double largest = std::ranges::max(table.observed) + pull;
    const double deepest = std::ranges::max(table.given), least = std::ranges::min(table.given);
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (std::size_t i = 0; i < table.given.size(); ++i) {
        const double force = table.observed[i] + pull;
        if (!(force > .25 * largest)) continue;
        const double root = std::cbrt(force / largest);
        const double d = (table.given[i] - least) / (deepest - least), f = root * root;
        n += 1;
        x += d;
        y += f;
        xx += d * d;
        xy += d * f;
    }
    const double slope = (n * xy - x * y) / (n * xx - x * x);
    const double zero = (x - y / slope) / n;  // where the line crosses 0
    // Without a rise that tells, below all depths of a force.
    return std::isfinite(zero) && slope > 0 ? least + std::min(zero, .99) * (deepest - least)
                                            : least;
}

std::vector<FreeParameter> free_parameters(const IdentificationInput& input,
                                           const std::vector<std::string>& find) {
    const contact::Case& rig = input.rig;
    if (rig.relaxation && rig.relaxation->bulk == contact::Relaxation::Bulk::elastic &&
        rig.substrate.poisson < .5)
        throw contact::InputError(
            "histories are evaluated for a constant Poisson's ratio, but the bulk modulus does "
            "not relax; leave out substrate.relaxation.bulk");
    std::vector<FreeParameter> parameters;
    for (const std::string& key : find) {
        if (key == "substrate.young") {
            parameters.push_back(young_parameter(rig.substrate.young));
        } else if (key == "substrate.poisson") {
            parameters.push_back({.key = key,
                                  .name = "poisson",
                                  .symbol = "nu",
                                  .scale = Scale::linear,
                                  .low = 0,
                                  .high = .5,
                                  .start = rig.substrate.poisson});
        } else if (is_of_law(key)) {
            parameters.push_back(law_parameter(input, stated_law(rig.friction), key));
        } else if (key == "indenter.radius") {
            parameters.push_back(length(key, "indenter_radius_m", "R", rig.indenter.radius));
        } else if (key == "substrate.thickness") {
            if (!rig.layer.thickness)
                throw contact::InputError(
                    "substrate.thickness is missing; give a value from which the search starts");
            parameters.push_back(length(key, "thickness_m", "b", *rig.layer.thickness));
        } else if (key == work_key) {
            parameters.push_back(work_parameter(input));
        } else if (key == approach_key) {
            parameters.push_back(approach_parameter());
        } else if (is_stiffness(key)) {
            parameters.push_back(stiffness_parameter(input, key));
        } else if (key == rig_stiffness_key) {
            parameters.push_back(rig_stiffness_parameter(input));
        } else if (key == pivot_key) {
            parameters.push_back(
                pivot_height(input.all(Measurement::rolling_shift), rig.indenter.radius));
        } else if (key == zero_depth_key) {
            const auto tables = input.all(Measurement::force_indentation);
            for (const auto* table : tables)
                parameters.push_back(zero_depth(*table, tables.size()));
        } else {
            add_terms(*rig.relaxation, key, parameters);
        }
    }
    std::ranges::move(drift_parameters(input), std::back_inserter(parameters));
    std::size_t n_rows = 0;
    for (const auto& table : input.tables) n_rows += table.observed.size() - table.n_own();
    if (n_rows <= parameters.size())
        throw contact::InputError(std::to_string(n_rows) + " rows do not determine " +
                                  std::to_string(parameters.size()) +
                                  " values and how well they are known; measure more, find fewer");
    return parameters;
}

const char* half_space_model() {
    return std::ranges::find(io::measurement_models(), false, &io::MeasurementModel::is_layer)
        ->name;
}

std::vector<FreeParameter> parameters_of(const IdentificationInput& input,
                                         const std::string& model) {
    std::vector<FreeParameter> parameters = input.parameters;
    if (!io::measurement_model(model).is_layer)
        std::erase_if(parameters,
                      [](const FreeParameter& p) { return p.key == "substrate.thickness"; });
    return parameters;
}

}  // namespace tricontact::experiments
