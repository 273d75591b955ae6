#include "experiments/identification/loop_parameters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/base/error.h"
#include "experiments/identification/identification_checks.h"
#include "experiments/identification/law_parameters.h"
#include "experiments/identification/loop_values.h"
#include "experiments/identification/loops/loop_stiffness.h"
#include "experiments/identification/rig_guesses.h"
#include "io/case/case_keys.h"
#include "io/case/measurement_models.h"
#include "io/case/rig_file.h"
#include "io/keys/key_checks.h"
#include "io/keys/messages.h"

namespace tricontact::experiments {

namespace {

using Input = IdentificationInput;
using Table = Input::Table;
using Measurement = Input::Measurement;

// Of the stiffness seen, below which no rig is looked for, and above which it is rigid.
constexpr double softest_rig = .3, stiffest_rig = 1e5;
constexpr std::size_t least_cycles = 3;

/// dF/dU [N/m] behind the reversals; of rows that show none of both reversals.
double stiffness_of(const LoopRows& rows) {
    const auto weights = initial_stiffness(rows, stiff_part);
    const double slope = weights ? weighted(*weights, rows.forces) : 0;
    const auto [least, most] = std::ranges::minmax(rows.forces);
    return slope > 0 ? slope : (most - least) / (2 * rows.loop.amplitude);
}

/// What loops of a line contact determine. A half-space under a line load has no shift of its own:
/// it goes with the logarithm of the size of the bodies, in proportion to the force, as the rig's
/// does.
void check_lines(const Input& input, const std::vector<std::string>& find,
                 const io::Document& document) {
    const auto refuse = [&](const char* key, const char* rule, const char* remedy) {
        io::refuse(document, key, rule, remedy);
    };
    if (!input.laws.empty())
        refuse("measurement.laws", "loops of cylinders are evaluated under Coulomb's law",
               "leave it out, and find friction.coefficient");
    for (const std::string& key : find)
        if (is_of_law(key) && key != coefficient_key)
            refuse("measurement.find", "loops of cylinders are evaluated under Coulomb's law",
                   "find friction.coefficient");
    if (document.find(strength_key) || document.find(strength_limit_key) ||
        document.find(exponent_key))
        refuse("indenter.shape", "loops of cylinders are evaluated under Coulomb's law",
               "leave out what [friction] has beside its coefficient");
    if (document.find_section("interface"))
        refuse("indenter.shape", "loops of cylinders are those of a rigid interface",
               "leave out [interface]");
    if (io::measurement_model(input.models.front()).is_layer)
        refuse("measurement.models", "loops of cylinders are evaluated on a half-space",
               "take models = [\"half-space\"]");
    if (!std::ranges::count(find, rig_stiffness_key))
        refuse("measurement.find",
               "the shift of a line contact goes with the size of its bodies, which nothing tells "
               "from the rig's",
               "add rig.tangential_stiffness, which is found as that of both");
}

}  // namespace

void check_loop_tables(const Input& input, const std::vector<std::string>& find,
                       const io::Document& document) {
    const bool has_loops = input.find(Measurement::friction_loop) != nullptr;
    const auto is_free = [&](std::string_view key) { return std::ranges::count(find, key) > 0; };
    const auto refuse = [&](const char* key, const std::string& rule, const std::string& remedy) {
        io::refuse(document, key, rule, remedy);
    };
    if (!has_loops) {
        if (is_free(rig_stiffness_key))
            refuse("measurement.find",
                   "the rig's stiffness is in series with the contact in friction_loop alone",
                   "add friction_loop, or leave out rig.tangential_stiffness");
        return;
    }
    for (const Table& table : input.tables)
        if (table.measurement != Measurement::friction_loop)
            refuse("measurement.friction_loop",
                   "loops are evaluated on their own, and there is " +
                       std::string(key_of(table.measurement)),
                   "identify that in a file of its own");
    for (const std::string& model : input.models)
        if (!io::measurement_model(model).knows_laws)
            refuse("measurement.models",
                   "loops are evaluated by half-space or layer, not by " + model,
                   "take models = [\"half-space\"] or [\"layer\"]");
    if (input.models.size() > 1)
        refuse("measurement.models", "loops are evaluated by one model",
               "take models = [\"half-space\"] or [\"layer\"]");
    if (input.laws.empty() && std::ranges::none_of(find, is_of_law))
        refuse("measurement.find", "loops find friction beside whatever else",
               "add friction.coefficient, or measurement.laws");
    for (const std::string& key : find)
        if (key != "substrate.young" && key != rig_stiffness_key && !is_of_law(key))
            refuse("measurement.find", "friction_loop does not determine " + key,
                   "find substrate.young, numbers of [friction] and rig.tangential_stiffness");
    if (is_cylinder(document)) check_lines(input, find, document);
    if (document.find_section("substrate.relaxation"))
        refuse("substrate.relaxation.relative_moduli", "loops are those of elastic bodies",
               "leave out [substrate.relaxation]");
}

void check_loop_loads(const Input& input, const io::Document& document) {
    const auto states = [](const Table* table) {
        return table->loops.loops.front().normal_force > 0;
    };
    const auto tables = input.all(Measurement::friction_loop);
    if (std::ranges::none_of(tables, states)) return;
    if (!std::ranges::all_of(tables, states))
        io::refuse(document, "measurement.friction_loop",
                   "of several tables all have a column normal_force or none", "add it to each");
    if (document.find("load.normal_force"))
        io::refuse(document, "load.normal_force",
                   "the rows of friction_loop state their own normal forces", "omit it");
}

double compliance_of_rig(const Input& input, const io::Document& document) {
    const io::Entry* entry = document.find(rig_stiffness_key);
    if (!entry || !input.find(Measurement::friction_loop)) return 0;
    const auto number = io::read_uncertain_number(*io::find_key(rig_stiffness_key), *entry);
    if (number.value.standard_error > 0)
        io::refuse(document, std::string(rig_stiffness_key),
                   "its error is not carried into loops, which tell it themselves",
                   "name it in measurement.find, or state it without ±");
    return 1 / number.value.value;
}

double guessed_young_of_loops(const Table& table, double radius, double normal_force) {
    double stiffest = 0, load = normal_force;
    for (const MeasuredLoop& loop : table.loops.loops) {
        const double seen = stiffness_of(rows_of(table, loop));
        if (seen <= stiffest) continue;
        stiffest = seen;
        if (loop.normal_force > 0) load = loop.normal_force;
    }
    // Mindlin: dF/dU = 2 G* a, a^3 = 3 F R/(4 E*), G* = 2/3 E* of what is incompressible.
    constexpr double shear_over_plane = 2. / 3, rig_share = 2;
    const double modulus = std::pow(
        rig_share * stiffest / (2 * shear_over_plane * std::cbrt(.75 * load * radius)), 1.5);
    return guessed_plane_share * modulus;
}

double guessed_young_of_lines(const Table& table, double length) {
    double stiffest = 0;
    for (const MeasuredLoop& loop : table.loops.loops)
        stiffest = std::max(stiffest, stiffness_of(rows_of(table, loop)));
    // dF/dU = pi E* L/(2 lambda - 1), lambda about 5 where L is some ten half widths.
    constexpr double shift_factor = 5, rig_share = 2;
    return guessed_plane_share * rig_share * stiffest * (2 * shift_factor - 1) /
           (std::numbers::pi * length);
}

double largest_ratio_of_loops(const Table& table, double normal_force) {
    double ratio = 0;
    for (const MeasuredLoop& loop : table.loops.loops) {
        const auto [least, most] = std::ranges::minmax(rows_of(table, loop).forces);
        const double load = loop.normal_force > 0 ? loop.normal_force : normal_force;
        ratio = std::max(ratio, (most - least) / 2 / load);
    }
    return ratio;
}

FreeParameter rig_stiffness_parameter(const Input& input) {
    double seen = 0;
    for (const Table& table : input.tables)
        for (const MeasuredLoop& loop : table.loops.loops)
            seen = std::max(seen, stiffness_of(rows_of(table, loop)));
    return {.key = std::string(rig_stiffness_key),
            .name = "rig_tangential_stiffness_N_per_m",
            .symbol = "k_rig",
            .unit = "N/m",
            .scale = FreeParameter::Scale::reciprocal,
            .low = softest_rig * seen,
            .high = stiffest_rig * seen,
            .start = 2 * seen,
            .further_starts = {30 * seen}};
}

std::vector<FreeParameter> drift_parameters(const Input& input) {
    const auto shows_drift = [](const Table& table) {
        std::vector<std::size_t> n_cycles(table.loops.n_series());
        for (const MeasuredLoop& loop : table.loops.loops) ++n_cycles[loop.series];
        return std::ranges::any_of(n_cycles, [](std::size_t n) { return n >= least_cycles; });
    };
    if (std::ranges::none_of(input.tables, shows_drift)) return {};
    constexpr double most_drift = 1.9;  // nothing would be left in the first or last cycle
    return {{.key = std::string(drift_key),
             .name = "friction_drift",
             .symbol = "drift",
             .scale = FreeParameter::Scale::either_sign,
             .low = -most_drift,
             .high = most_drift,
             .start = 0,
             .size = 1}};
}

}  // namespace tricontact::experiments
