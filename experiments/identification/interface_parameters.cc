// Springs of the interface as what is to be found, and what of them is refused.

#include "experiments/identification/interface_parameters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/base/special_values.h"
#include "experiments/identification/identification_checks.h"
#include "experiments/identification/layer_contact.h"
#include "io/case/measurement_models.h"
#include "io/keys/messages.h"

namespace tricontact::experiments {

namespace {

using Input = IdentificationInput;
using Measurement = Input::Measurement;
using std::numbers::pi;

// Noise may make a row say more than there is.
constexpr double below_softest = .1;
// Springs that are so much stiffer are rigid.
constexpr double stiffest = 1e5, nearly_rigid = 1e4, guessed = 5;

double square(double x) {
    return x * x;
}

/// The softest k_n of a row without tangential force: F = pi k R d^2 = pi k a^4/(4 R).
double softest_normal(const Input::Table& table, std::size_t row, double radius, double zero) {
    const double x = table.given[row], y = table.observed[row];
    switch (table.measurement) {
        case Measurement::force_indentation:
            return x > zero ? y / (pi * radius * square(x - zero)) : 0;
        case Measurement::contact_radius:
            return 4 * x * radius / (pi * square(square(y)));
        default:
            return 0;
    }
}

/// The least of those that are positive; infinite without one.
void take(double& least, double value) {
    if (value > 0 && value < least) least = value;
}

}  // namespace

bool is_stiffness(std::string_view key) {
    return key == normal_stiffness_key || key == tangential_stiffness_key;
}

double softest_stiffness(const Input& input, std::string_view key, double radius, double modulus,
                         double normal_force) {
    const auto hertz_radius = [&](double force) {
        return std::cbrt(.75 * force * radius / modulus);
    };
    double softest = contact::infinity;
    for (const Input::Table& table : input.tables) {
        const double zero = table.has_free_zero ? zero_depth_guess(table) : 0;
        for (std::size_t row = 0; row < table.given.size(); ++row) {
            if (key == normal_stiffness_key)
                take(softest, softest_normal(table, row, radius, zero));
            else if (table.measurement == Measurement::static_shift)
                take(softest, table.given[row] / table.observed[row] /
                                  (pi * square(hertz_radius(table.normal_forces.empty()
                                                                ? normal_force
                                                                : table.normal_forces[row]))));
        }
    }
    // Shifts tell k_n by the radius alone.
    if (std::isinf(softest)) softest = modulus / hertz_radius(normal_force);
    return below_softest * softest;
}

double guessed_stiffness(double softest) {
    return guessed * softest / below_softest;
}

FreeParameter stiffness_parameter(const Input& input, const std::string& key) {
    const bool is_normal = key == normal_stiffness_key;
    const double softest =
        softest_stiffness(input, key, input.rig.indenter.radius,
                          input.rig.materials().effective_modulus(), *input.rig.load.normal_force);
    const double given = is_normal ? *input.rig.interface.normal_stiffness
                                   : *input.rig.interface.tangential_stiffness;
    FreeParameter p{
        .key = key,
        .name = is_normal ? "normal_stiffness_Pa_per_m" : "tangential_stiffness_Pa_per_m",
        .symbol = is_normal ? "k_n" : "k_t",
        .unit = "Pa/m",
        .scale = FreeParameter::Scale::reciprocal,
        .low = softest,
        .high = stiffest * softest};
    p.start = std::clamp(given, 1.1 * p.low, p.high / 1.1);
    p.further_starts = {nearly_rigid * softest};
    return p;
}

void check_interface(const Input& input, const std::vector<std::string>& find,
                     const io::Document& document) {
    const auto is_free = [&](const char* key) { return std::ranges::count(find, key) > 0; };
    std::string place;
    for (const char* key : {tangential_stiffness_key, normal_stiffness_key}) {
        if (document.find(key)) place = key;
        if (is_free(key)) place = "measurement.find";
    }
    if (place.empty()) return;
    for (const std::string& model : input.models)
        if (!io::measurement_model(model).knows_laws)
            io::refuse(
                document, "measurement.models",
                "springs of the interface are identified by half-space and layer, not by " + model,
                "leave out " + model + ", or " +
                    (place == "measurement.find" ? "the springs of measurement.find"
                                                 : std::string("[interface]")));
    for (const Input::Table& table : input.tables)
        if (table.is_history())
            io::refuse(document, place,
                       "springs of the interface do not relax, and histories are closed forms of "
                       "what relaxes as a whole",
                       "leave out " + std::string(key_of(table.measurement)) + ", or the springs");
    if (is_free(tangential_stiffness_key) && !input.find(Measurement::static_shift))
        io::refuse(document, "measurement.find",
                   "without static_shift nothing determines interface.tangential_stiffness",
                   "add static_shift, or leave out interface.tangential_stiffness");
    const bool tells_normal = input.find(Measurement::static_shift) ||
                              input.find(Measurement::force_indentation) ||
                              input.find(Measurement::contact_radius) ||
                              (input.find(Measurement::sliding_force) && !input.laws.empty());
    if (is_free(normal_stiffness_key) && !tells_normal)
        io::refuse(document, "measurement.find", "no table determines interface.normal_stiffness",
                   "add force_indentation or contact_radius, or leave out "
                   "interface.normal_stiffness");
}

void check_layer_theory(const Input& input, const io::Document& document) {
    // The rules of the models that know springs let these pass.
    if (input.rig.interface.is_elastic() && input.rig.indenter.roughness)
        io::refuse(document, "indenter.roughness.hurst",
                   "springs of the interface stand for the roughness of a smooth body",
                   "leave out [indenter.roughness], or the springs");
    if (input.rig.interface.is_elastic() && input.rig.period)
        io::refuse(document, "bem.period", "springs are identified under one indenter",
                   "leave it out, or the springs");
    const bool has_layer =
        std::ranges::any_of(input.models, &io::MeasurementModel::is_layer, io::measurement_model);
    const bool has_loops = input.find(Measurement::friction_loop) != nullptr;
    if (!has_layer || (input.laws.empty() && !is_beyond_coulomb(input.rig) && !has_loops)) return;
    const std::string why = why_no_layer_contact(input.rig);
    const auto colon = why.find(": ");
    if (!why.empty())
        io::refuse(
            document, why.substr(0, colon),
            (has_loops ? "in loops, " : "under other laws than Coulomb's, and on springs, ") +
                why.substr(colon + 2),
            "change it, or take models = [\"half-space\"]");
    if (input.is_free("substrate.poisson"))
        io::refuse(document, "measurement.find",
                   "laws of friction and springs on a layer are those of a known nu",
                   "leave out substrate.poisson, or the model layer");
}

}  // namespace tricontact::experiments
