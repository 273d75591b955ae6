#include "experiments/identification/adhesion_parameter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiments/identification/adhesion/adhesive_rows.h"
#include "experiments/identification/identification_checks.h"
#include "io/case/measurement_models.h"
#include "io/keys/key_checks.h"
#include "io/keys/messages.h"
#include "statistics/estimate.h"

namespace tricontact::experiments {

namespace {

using Input = IdentificationInput;
using Table = Input::Table;
using Measurement = Input::Measurement;

// Of the largest force, where no tension shows.
constexpr double hidden_tension = 1e-2;
// Around the guess.
constexpr double least_work = 1e-6, largest_work = 1e3;

template <typename Value>
void keep(const std::vector<std::size_t>& rows, std::vector<Value>& values) {
    if (values.empty()) return;
    std::vector<Value> kept;
    for (const std::size_t row : rows) kept.push_back(values[row]);
    values = std::move(kept);
}

}  // namespace

void check_adhesive_tables(const Input& input, const std::vector<std::string>& find,
                           const io::Document& document) {
    const bool is_free = std::ranges::count(find, work_key) > 0;
    const bool has_approach =
        std::ranges::count(find, approach_key) > 0 || document.find(approach_key);
    if (has_approach && !is_free && !document.find(work_key))
        io::refuse(document, "measurement.find",
                   "the work of approach is found beside that of separation",
                   "add \"adhesion.work\", or state it in [adhesion]");
    if (!is_free && !document.find_section("adhesion")) return;
    const std::string place = is_free ? "measurement.find" : std::string(work_key);
    const auto refuse = [&](const std::string& rule, const std::string& remedy) {
        io::refuse(document, place, rule, remedy);
    };
    const std::string omit = is_free ? "leave out adhesion.work" : "leave out [adhesion]";
    for (const Table& table : input.tables)
        if (table.measurement != Measurement::force_indentation &&
            table.measurement != Measurement::contact_radius &&
            table.measurement != Measurement::sliding_force)
            refuse(std::string(key_of(table.measurement)) +
                       " is evaluated without adhesion; force_indentation, contact_radius and "
                       "sliding_force know it",
                   "identify that table in a file of its own, or " + omit);
    for (const Table& table : input.tables)
        if (has_approach && table.measurement != Measurement::force_indentation)
            refuse(std::string(key_of(table.measurement)) +
                       " depends on what was pressed before where approach and separation differ",
                   "identify that table in a file of its own, or leave out " +
                       std::string(approach_key));
    for (const std::string& model : input.models) {
        const io::MeasurementModel& kind = io::measurement_model(model);
        if (!kind.is_theory)
            refuse("adhesion is identified by half-space and layer, not by " + model,
                   "leave out " + model + ", or " + omit);
        if (kind.is_layer && std::ranges::count(find, "substrate.poisson"))
            refuse("adhesion on a layer is that of a known nu",
                   "leave out substrate.poisson, or the model " + model);
    }
    if (document.find("adhesion.range") || document.find("adhesion.peak_stress")) {
        const char* const key =
            document.find("adhesion.range") ? "adhesion.range" : "adhesion.peak_stress";
        if (has_approach)
            io::refuse(document, key, "with a range one work of adhesion is known",
                       "omit it, or leave out " + std::string(approach_key));
        if (document.find("adhesion.law"))
            io::refuse(document, "adhesion.law",
                       "curves with a range are Maugis', of Dugdale's constant stress", "omit it");
        for (const std::string& model : input.models)
            if (io::measurement_model(model).is_layer)
                io::refuse(document, key, "a range is known on the half-space alone",
                           "leave out the model " + model + ", or omit it");
    }
    if (!input.laws.empty())
        io::refuse(document, "measurement.laws",
                   "laws of friction are compared without adhesion: under tension only tau_0 holds",
                   "find friction.shear_strength instead, or " + omit);
    if (is_free && find.size() == 1)
        refuse("the tables determine the work of adhesion only together with the modulus",
               "add \"substrate.young\", and \"zero_depth\" where depths count from anywhere");
}

void check_adhesive_friction(const Input& input, const io::Document& document) {
    if (!input.rig.adhesion || !input.find(Measurement::sliding_force)) return;
    const contact::Friction& friction = input.rig.friction;
    if (friction.shear_strength && !friction.coefficient) return;
    io::refuse(document, "measurement.sliding_force",
               "where surfaces attract each other what slides carries tau_0 over the contact, and "
               "this law has mu",
               "find friction.shear_strength, or state it, without friction.coefficient");
}

double guessed_work(const Input& input, double radius) {
    double pull = 0, largest = 0;
    for (const Table& table : input.tables) {
        pull = std::max(pull, adhesive_pull(table));
        const bool is_depth = table.measurement == Measurement::force_indentation;
        largest = std::max(largest, std::ranges::max(is_depth ? table.observed : table.given));
    }
    return std::max(pull, hidden_tension * largest) / (2 * std::numbers::pi * radius);
}

FreeParameter work_parameter(const Input& input) {
    const double start = input.rig.adhesion->work;
    return {.key = std::string(work_key),
            .name = "work_of_adhesion_J_per_m2",
            .symbol = "w",
            .unit = "J/m2",
            .low = least_work * start,
            .high = largest_work * start,
            .start = start};
}

FreeParameter approach_parameter() {
    return {.key = std::string(approach_key),
            .name = "approach_work_ratio",
            .symbol = "w_r",
            .scale = FreeParameter::Scale::linear,
            .low = 0,
            .high = 1,
            .start = .5};
}

void keep_adhesive_rows(Table& table, const std::string& name) {
    if (!table.is_adhesive || table.measurement != Measurement::force_indentation) return;
    const std::vector<double>& errors =
        table.row_errors.observed.empty() ? table.standard_errors : table.row_errors.observed;
    const double error = errors.empty() ? 0 : statistics::median(errors);
    const std::size_t n = table.given.size();
    AdhesiveRows kept = adhesive_rows(table.given, table.observed, error);
    constexpr int most_onsets = 2;  // one, and a stray row
    if (kept.n_onsets > most_onsets)
        io::fail(name, "",
                 "tension comes and goes " + std::to_string(kept.n_onsets) +
                     " times from row to row, as where approach and retraction are sorted together",
                 "write the rows in the order of time");
    keep(kept.rows, table.given);
    keep(kept.rows, table.observed);
    keep(kept.rows, table.standard_errors);
    keep(kept.rows, table.row_errors.observed);
    keep(kept.rows, table.row_errors.given);
    table.ways = std::move(kept.ways);
    if (kept.shows_jump)
        table.reading += fmt::format(
            "{}{} of {} rows: those in contact up to the largest tension, beyond which the "
            "machine's stiffness and the range of the attraction decide where it jumps",
            table.reading.empty() ? "" : "; ", table.given.size(), n);
}

}  // namespace tricontact::experiments
