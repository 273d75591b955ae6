// What the reader of an identification refuses about friction and the loads that it grows with.

#include <algorithm>

#include "experiments/identification/friction_values.h"
#include "experiments/identification/identification_checks.h"
#include "experiments/identification/law_parameters.h"
#include "experiments/identification/loop_parameters.h"
#include "io/case/measurement_laws.h"
#include "io/case/measurement_models.h"
#include "io/keys/key_checks.h"
#include "io/keys/messages.h"

namespace tricontact::experiments {

using Input = IdentificationInput;
using Measurement = Input::Measurement;

namespace {

/// What is found is of the law that [friction] states, the number itself or not.
void check_stated_law(const std::vector<std::string>& find, const io::Document& document) {
    const auto is_free = [&](std::string_view key) { return std::ranges::count(find, key) > 0; };
    for (const std::string_view key : {exponent_key, strength_limit_key})
        if (is_free(key) && !is_free(coefficient_key) && !document.find(coefficient_key))
            io::refuse(document, "measurement.find",
                       "has " + std::string(key) + " of a law without mu",
                       "add friction.coefficient, to it or to [friction]");
    if (is_free(exponent_key) && !document.find(exponent_key))
        io::refuse(document, "measurement.find",
                   "has n of mu p_r (p/p_r)^n, which [friction] does not state",
                   "add pressure_exponent = 0.8 or the like, where the search starts, and "
                   "reference_pressure to [friction]");
}

}  // namespace

bool tells_young(Measurement measurement) {
    return measurement != Measurement::rolling_shift && measurement != Measurement::sliding_force;
}

void check_laws(const Input& input, const std::vector<std::string>& find,
                const io::Document& document) {
    if (input.find(Measurement::rolling_shift) && !input.find(Measurement::static_shift) &&
        input.find(Measurement::sliding_force))
        io::refuse(document, "measurement.sliding_force",
                   "beside rolling_shift friction follows from static shifts",
                   "add static_shift, or leave out one of both");
    if (input.laws.empty()) {
        check_stated_law(find, document);
        return;
    }
    if (!input.find(Measurement::static_shift) && !input.find(Measurement::sliding_force) &&
        !input.find(Measurement::friction_loop))
        io::refuse(document, "measurement.laws", "no table has friction",
                   "add static_shift, sliding_force or friction_loop, or leave measurement.laws "
                   "out");
    for (const std::string& key : find)
        if (is_of_law(key))
            io::refuse(
                document, "measurement.find",
                "has " + key + " beside measurement.laws, each of which finds its own numbers",
                "leave out " + key);
    if (const auto* friction = document.find_section("friction"))
        io::fail(friction->place, "[friction]",
                 "measurement.laws names the laws whose numbers are found", "omit it");
    for (const std::string& model : input.models)
        if (!io::measurement_model(model).knows_laws)
            io::refuse(document, "measurement.models",
                       "laws of friction are compared by half-space and layer, not by " + model,
                       "leave out " + model + ", or measurement.laws");
}

void check_loads(const Input& input, const io::Document& document) {
    check_loop_loads(input, document);
    const auto tables = input.all(Measurement::static_shift);
    const auto has_loads = [](const Input::Table* table) { return !table->normal_forces.empty(); };
    if (std::ranges::none_of(tables, has_loads)) return;
    const auto without = std::ranges::find_if_not(tables, has_loads);
    if (without != tables.end())
        io::refuse(document, "measurement.static_shift",
                   "of several tables all have a column normal_force or none, and " +
                       (*without)->label + " has none",
                   "add it there, the load of each row");
    if (document.find("load.normal_force") && !document.find_section("record"))
        io::refuse(document, "load.normal_force",
                   "the rows of static_shift state their own normal forces", "omit it");
    if (input.find(Measurement::rolling_shift))
        io::refuse(document, "measurement.rolling_shift",
                   "was measured under one load, and the rows of static_shift state several",
                   "leave out the column normal_force, or rolling_shift");
}

void check_rows_of_laws(const Input& input, const io::Document& document) {
    std::size_t n_rows = 0, n_numbers = 0;
    for (const auto& table : input.tables) n_rows += table.observed.size() - table.n_own();
    for (const std::string& law : input.laws)
        n_numbers = std::max<std::size_t>(n_numbers, io::measurement_law(law).n_numbers());
    n_numbers += input.parameters.size();
    if (!input.laws.empty() && n_rows <= n_numbers)
        io::refuse(document, "measurement.laws",
                   std::to_string(n_rows) + " rows do not determine " + std::to_string(n_numbers) +
                       " values and how well they are known",
                   "measure more, or leave out the laws of most numbers");
}

void check_friction(const Input& input, const io::Document& document) {
    const contact::Friction& friction = input.rig.friction;
    if (friction.map)
        io::refuse(document, "friction.map",
                   "material constants are identified under friction that is the same all over",
                   "leave it out");
    if (friction.rate)
        io::refuse(document, "friction.rate.law",
                   "material constants are identified under friction that no speed changes",
                   "leave out [friction.rate]");
    if (friction.temperature)
        io::refuse(document, "friction.temperature.change",
                   "material constants are identified under friction that no heat changes",
                   "leave out [friction.temperature]");
    if (friction.remembers())
        io::refuse(document, friction.weakening ? "friction.weakening.law" : "interface.hardening",
                   "material constants are identified under friction that no way of slip changes",
                   "leave it out");
    if (!friction.is_coulomb())
        for (const std::string& model : input.models)
            if (!io::measurement_model(model).knows_laws)
                io::refuse(document, "measurement.models",
                           model + " identifies under Coulomb's law, and the case has tau = " +
                               friction.formula(),
                           "take half-space or layer, or give friction.coefficient alone");
    check_layer_theory(input, document);
    const auto is_found = [](const FreeParameter& p) { return is_of_law(p.key); };
    if (std::ranges::any_of(input.parameters, is_found) || !input.laws.empty()) return;
    // Of other laws what the contact carries depends on its area, thus on E.
    if (!friction.is_coulomb() && input.is_free("substrate.young")) return;
    for (const auto* shifts : input.all(Measurement::static_shift))
        for (const LoadedRows& load : rows_by_load(*shifts, input.rig, shifts->given)) {
            const double largest = std::ranges::max(load.given);
            const double limit = sliding_forces(false, input.rig, {load.normal_force}).front();
            if (largest >= limit)
                io::refuse(
                    document,
                    friction.coefficient ? "friction.coefficient" : "friction.shear_strength",
                    "the contact would slide: F_T of the table reaches " + io::shortest(largest) +
                        (friction.is_coulomb() ? " N, mu F_N is " : " N, friction carries ") +
                        io::shortest(limit) + " N",
                    "correct it, or name it in measurement.find");
        }
}

}  // namespace tricontact::experiments
