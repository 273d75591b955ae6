#include "experiments/identification/identification_checks.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <variant>

#include "comparisons/quantities/left_out.h"
#include "experiments/identification/law_parameters.h"
#include "io/case/measurement_models.h"
#include "io/case/rig_keys.h"
#include "io/keys/field_reader.h"
#include "io/keys/key_checks.h"
#include "io/keys/messages.h"

namespace tricontact::experiments {

namespace {

using Input = IdentificationInput;
using Table = Input::Table;
using Measurement = Input::Measurement;
using Model = io::MeasurementModel;

/// What a key says; empty without it, or if it is no text.
std::string word_of(const io::Document& document, std::string_view path) {
    const io::Entry* entry = document.find(path);
    const auto* word = entry ? std::get_if<std::string>(&entry->value) : nullptr;
    return word ? *word : std::string();
}

using Refuse = std::function<void(const std::string& rule, const std::string& remedy)>;

void check_rolling(const Input& input, const std::vector<std::string>& find, const Refuse& refuse) {
    const auto is_free = [&](std::string_view key) { return std::ranges::count(find, key) > 0; };
    const bool has_table = input.find(Measurement::rolling_shift);
    if (has_table != is_free(pivot_key))
        has_table
            ? refuse("rolling_shift determines the pivot's height",
                     "add rig.pivot_height, or leave out rolling_shift")
            : refuse("nothing determines rig.pivot_height", "add rolling_shift, or leave it out");
    if (!has_table) return;
    const auto is_told = [](std::string_view key) {
        return key == pivot_key || key == "indenter.radius";
    };
    const bool is_alone = input.all(Measurement::rolling_shift).size() == input.tables.size();
    if (is_alone && !std::ranges::all_of(find, is_told))
        refuse("rolling_shift alone determines the pivot's height, and nothing of the substrate",
               "add static_shift or another table, or find rig.pivot_height alone");
}

}  // namespace

bool is_sheared(const Input& input) {
    return input.find(Measurement::static_shift) || input.find(Measurement::rolling_shift) ||
           input.find(Measurement::friction_loop);
}

double quantity_of(const io::Document& document, std::string_view path) {
    double value = 0;
    const io::Key& key = *io::find_key(path);
    io::read_field(key, io::required(key, document, io::case_key_list()), io::Field(&value));
    return value;
}

void check_models(const Input& input, const io::Document& document) {
    for (const std::string& model : input.models) {
        const io::MeasurementModel& kind = io::measurement_model(model);
        if (kind.is_layer && !document.find("substrate.thickness"))
            io::refuse(
                document, "measurement.models",
                model + " is a model of a layer, but substrate.thickness is missing",
                "add thickness = \"8 mm\" or the like to [substrate], or leave out " + model);
        if (kind.approximates_theory && !is_sheared(input))
            io::refuse(
                document, "measurement.models",
                "without tangential force " + model + " approximates what layer computes exactly",
                "write \"layer\" instead");
        if (!kind.has_rolling_shift && input.find(Measurement::rolling_shift))
            io::refuse(document, "measurement.models",
                       "the maps do not contain the shift of free rolling",
                       "take bem-layer, or leave out rolling_shift");
    }
}

void check_lengths(const Table& table, double radius, const io::Document& document) {
    if (table.measurement == Measurement::sliding_force) return;
    const bool deep = table.measurement == Measurement::force_indentation;
    if (table.measurement == Measurement::force_relaxation) {
        if (table.held >= radius)
            io::refuse(document, "measurement.held_indentation",
                       "not below the indenter's radius: small deformations are assumed",
                       "check the units");
        return;
    }
    const MeasuredColumns& columns = columns_of(table.measurement);
    double largest = 0;
    const double zero = table.has_free_zero ? zero_depth_guess(table) : 0;
    const bool is_given = deep || table.measurement == Measurement::friction_loop;
    for (const double value : is_given ? table.given : table.observed)
        largest = std::max(largest, deep && table.has_free_zero ? value - zero : std::abs(value));
    if (largest >= radius)
        io::refuse(document, std::string(key_of(table.measurement)),
                   std::string(is_given ? columns.given.name : columns.observed.name) +
                       " reaches " + io::shortest(largest) + " m, the indenter's radius is " +
                       io::shortest(radius) + " m: small deformations are assumed",
                   "check the units of the table and of indenter.radius");
}

bool is_finite_strain(const io::Document& document) {
    const std::string material = word_of(document, "substrate.material");
    return !material.empty() && material != "linear";
}

bool is_cylinder(const io::Document& document) {
    return word_of(document, "indenter.shape") == "cylinder";
}

void check_round(const Input& input, const io::Document& document) {
    if (!document.find("indenter.shape")) return;
    const std::string shape = word_of(document, "indenter.shape");
    if (shape == "paraboloid" || shape == "sphere") return;
    if (is_cylinder(document) && input.find(Measurement::friction_loop)) return;
    io::refuse(document, "indenter.shape",
               "material constants are identified under a round indenter",
               "take \"paraboloid\" or \"sphere\"; friction loops also \"cylinder\"");
}

void check_find(const Input& input, const std::vector<std::string>& find,
                const io::Document& document) {
    const auto is_free = [&](std::string_view key) { return std::ranges::count(find, key) > 0; };
    const auto refuse = [&](const std::string& rule, const std::string& remedy) {
        io::refuse(document, "measurement.find", rule, remedy);
    };
    const bool has_friction = input.find(Measurement::static_shift) ||
                              input.find(Measurement::sliding_force) ||
                              input.find(Measurement::friction_loop);
    if (is_free(coefficient_key) && !has_friction)
        refuse("without tangential force nothing determines the coefficient of friction",
               "leave out friction.coefficient");
    for (const std::string& key : find)
        if (is_of_law(key) && !has_friction)
            refuse("without tangential force nothing determines " + key, "leave it out");
    check_rolling(input, find, refuse);
    const auto tells = [](const Table& table) { return tells_young(table.measurement); };
    if (is_free("substrate.young") && std::ranges::none_of(input.tables, tells) &&
        input.find(Measurement::sliding_force))
        refuse("sliding_force does not determine the modulus",
               "add static_shift, force_indentation or contact_radius, or leave out "
               "substrate.young");
    if (is_free(zero_depth_key) && !input.find(Measurement::force_indentation))
        refuse("zero_depth is where force_indentation begins, and there is no such table",
               "add it, or leave zero_depth out");
    const bool presses_alone =
        input.all(Measurement::force_indentation).size() == input.tables.size();
    if (is_free(zero_depth_key) && find.size() == 1 && presses_alone)
        refuse("force_indentation determines zero_depth only together with the modulus",
               "add \"substrate.young\"");
    const bool is_timed = std::ranges::any_of(input.tables, &Table::is_history);
    for (const char* key : {"substrate.relaxation.relative_moduli", "substrate.relaxation.times"})
        if (is_free(key) && !is_timed)
            refuse(std::string("no history determines ") + key,
                   "add force_relaxation or indentation_creep, or leave it out");
    if (is_timed && !document.find_section("substrate.relaxation"))
        refuse("the tables hold a history, but the case has no [substrate.relaxation]",
               "add relative_moduli and times, whose values are where the search starts");
    const auto has = [&](const auto& property) {
        return std::ranges::any_of(input.models, property, io::measurement_model);
    };
    const auto is_half_space = [](const Model& model) { return !model.is_layer; };
    if (is_free("substrate.thickness") && has(is_half_space) && find.size() == 1)
        refuse("a half-space has no thickness", "leave out half-space of models");
    if (is_free("substrate.poisson") && is_sheared(input))
        for (const std::string& model : input.models)
            if (!io::measurement_model(model).shifts_find_poisson)
                refuse("with shifts, nu is found by half-space and atlas, not by " + model,
                       "take the model atlas, or leave out substrate.poisson");
    if (is_free("substrate.poisson"))
        for (const std::string& model : input.models)
            if (!io::measurement_model(model).finds_poisson)
                refuse(model + " does not find nu", "take the model layer");
    const auto is_strained = [](const Model& model) { return model.kind().sees_finite_strains; };
    const bool is_scaled = is_free("indenter.radius") || is_free("substrate.thickness");
    if (is_timed && has(is_strained) && is_finite_strain(document))
        refuse("histories are closed forms of linear materials", "leave out fem");
    if (is_scaled && has(is_strained) && is_finite_strain(document))
        refuse("at finite strains lengths of fem are not in proportion to thickness and radius",
               "leave fem out, or the thickness and the radius");
    if (is_scaled && word_of(document, "indenter.shape") == "sphere" && has(&Model::is_layer))
        refuse("lengths of a layer under a sphere are not in proportion to each other",
               "take shape = \"paraboloid\", which the sphere is near its tip");
}

std::vector<std::string> left_out_lines(const Input& input) {
    std::vector<std::string> lines;
    for (const std::string& model : input.models) {
        const std::string in_cases = io::measurement_model(model).model;
        for (const std::string& one : comparisons::left_out(input.rig, in_cases))
            lines.push_back(model + " leaves out " + one);
    }
    if (input.rig.relaxation && !std::ranges::all_of(input.tables, &Table::is_history))
        lines.emplace_back(
            "identify leaves out substrate.relaxation in tables without times: their rows are "
            "taken as those of the relaxed substrate");
    std::vector<std::string> done, of_rig;
    for (const std::string& key : input.unread)
        (key.starts_with("rig.") ? of_rig : done).push_back(key);
    if (!done.empty())
        lines.push_back("identify leaves out " + io::joined(done) +
                        ": what was done stands in the tables of [measurement]");
    if (!of_rig.empty())
        lines.push_back("identify leaves out " + io::joined(of_rig) + ": no part of its models");
    return lines;
}

}  // namespace tricontact::experiments
