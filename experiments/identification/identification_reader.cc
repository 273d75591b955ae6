#include "experiments/identification/identification_reader.h"

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>
#include <filesystem>
#include <set>

#include "contact/base/error.h"
#include "experiments/identification/adhesion_parameter.h"
#include "experiments/identification/identification_checks.h"
#include "experiments/identification/interface_parameters.h"
#include "experiments/identification/law_parameters.h"
#include "experiments/identification/loop_parameters.h"
#include "experiments/identification/loop_values.h"
#include "experiments/identification/rig_guesses.h"
#include "io/case/case_reader.h"
#include "io/case/measurement_models.h"
#include "io/case/rig_file.h"
#include "io/case/rig_keys.h"
#include "io/keys/field_reader.h"
#include "io/keys/input_file.h"
#include "io/keys/key_checks.h"
#include "io/keys/messages.h"

namespace tricontact::experiments {

namespace {

using Input = IdentificationInput;
using Measurement = Input::Measurement;
constexpr double guessed_poisson = .45;

using Table = Input::Table;

bool is_section_of_models(std::string_view section) {
    return std::ranges::any_of(io::measurement_models(), [&](const io::MeasurementModel& model) {
        return model.kind().section == section;
    });
}

/// Keys of a case that describe a rig; loads along the surface and rolling are not in what was
/// measured.
bool describes_rig(std::string_view path) {
    constexpr std::array<std::string_view, 8> sections{"indenter", "substrate", "lower_layer",
                                                       "ground",   "friction",  "interface",
                                                       "contact",  "adhesion"};
    constexpr std::array<std::string_view, 4> others{"title", "load.normal_force", "load.press",
                                                     "load.press_steps"};
    const auto top = path.substr(0, path.find('.'));
    return std::ranges::count(sections, top) || std::ranges::count(others, path) ||
           is_section_of_models(top);
}

/// What the models of the case have to be so that its checks are those of the identification's. The
/// closed forms of the half-space need none.
std::vector<std::string> case_models(const Input& input, bool needs_cells) {
    const bool sheared = is_sheared(input);
    std::set<std::string> models;
    for (const std::string& name : input.models) {
        const io::MeasurementModel& model = io::measurement_model(name);
        const std::string rules = sheared ? model.rules : model.pressed_rules;
        if (!rules.empty()) models.insert(rules);
    }
    if (models.empty()) models.insert(needs_cells ? contact::models::bem : contact::models::mdr);
    return {models.begin(), models.end()};
}

/// The rig as a case: what is to be found has a guess.
contact::Case rig_of(const Input& input, const std::vector<std::string>& find,
                     const io::Document& document) {
    io::Document rig = document;
    std::erase_if(rig.entries, [&](const io::Entry& entry) {
        const bool is_guessed = entry.path == "substrate.young" || entry.path == work_key ||
                                entry.path == approach_key ||
                                (is_of_law(entry.path) && entry.path != exponent_key);
        if (!input.laws.empty() && entry.path.starts_with("friction.")) return true;
        return (is_guessed && std::ranges::count(find, entry.path)) || !describes_rig(entry.path);
    });
    std::erase_if(rig.sections, [](const io::Document::Section& section) {
        return section.name != "load" && !describes_rig(section.name);
    });
    const bool sheared = is_sheared(input);
    check_round(input, document);
    const double radius = quantity_of(document, "indenter.radius");
    for (const Table& table : input.tables) check_lengths(table, radius, document);
    const bool has_springs =
        rig.find_section("interface") || std::ranges::any_of(find, is_stiffness);
    const bool has_range = rig.find("adhesion.range") || rig.find("adhesion.peak_stress");
    // No rows of mdr's.
    const bool needs_cells = has_springs || has_range || is_cylinder(document);
    std::vector<io::Entry> guesses{io::overriding("models", case_models(input, needs_cells),
                                                  document.place_of("measurement.models"))};
    const auto is_free = [&](std::string_view key) { return std::ranges::count(find, key) > 0; };
    const auto guess = [&](std::string_view path, io::Value value) {
        guesses.push_back(
            io::overriding(std::string(path), std::move(value), input.tables.front().data_file));
    };
    guess("load.tangential_ratio", 0.);
    double normal_force = 0;
    if (sheared) {
        if (document.find("load.indentation"))
            io::refuse(document, "load.indentation",
                       "shifts were measured under a normal force, which follows from no depth "
                       "before the modulus is known",
                       "give load.normal_force");
        bool has_loads = false;
        for (const Table* shifts : input.all(Measurement::static_shift))
            for (const double load : shifts->normal_forces) {
                has_loads = true;
                normal_force = std::max(normal_force, load);
            }
        for (const Table* measured : input.all(Measurement::friction_loop))
            for (const MeasuredLoop& loop : measured->loops.loops) {
                has_loads = has_loads || loop.normal_force > 0;
                normal_force = std::max(normal_force, loop.normal_force);
            }
        if (has_loads) {
            guess("load.normal_force", io::shortest(normal_force) + " N");
        } else if (!document.find("load.normal_force"))
            io::fail(
                document.place_of("load.normal_force"), "", "missing key load.normal_force",
                "add the force under which the shifts were measured: normal_force = \"21.1 N\"");
        if (!has_loads) normal_force = quantity_of(document, "load.normal_force");
    } else {
        for (const Table& table : input.tables)
            normal_force = std::max(normal_force, largest_force(table));
        guess("load.normal_force", io::shortest(normal_force) + " N");
    }
    // Frictionless contact knows no coupling, and the half-space's closed forms have none.
    // At finite strains fem always couples, whatever the others do.
    const bool is_uncoupled =
        !sheared ||
        std::ranges::none_of(input.models, &io::MeasurementModel::is_layer, io::measurement_model);
    if (is_uncoupled && !is_finite_strain(document)) guess("contact.coupling", false);
    const double young = !is_free("substrate.young") ? quantity_of(document, "substrate.young")
                         : is_cylinder(document)
                             ? guessed_young_of_lines(table_of_young(input),
                                                      quantity_of(document, "indenter.length"))
                             : guessed_young(table_of_young(input), radius, normal_force);
    if (is_free("substrate.young")) guess("substrate.young", io::shortest(young) + " Pa");
    for (const char* key : {normal_stiffness_key, tangential_stiffness_key})
        if (is_free(key) && !document.find(key))
            guess(key, io::shortest(guessed_stiffness(softest_stiffness(
                           input, key, radius, young / guessed_plane_share, normal_force))) +
                           " Pa/m");
    if (is_free(work_key)) guess(work_key, io::shortest(guessed_work(input, radius)) + " J/m2");
    if (is_free(approach_key)) guess(approach_key, "0 J/m2");
    if (is_free("substrate.poisson") && !rig.find("substrate.poisson"))
        guess("substrate.poisson", guessed_poisson);
    const double ratio = guessed_friction(input, normal_force);
    const bool needs_friction = !sheared && !rig.find(coefficient_key) && !rig.find(strength_key) &&
                                std::ranges::none_of(find, is_of_law);
    if (is_free(coefficient_key) || !input.laws.empty() || needs_friction)
        guess(coefficient_key, needs_friction && input.laws.empty() ? 1. : ratio);
    for (auto& [key, value] : guessed_law(find, rig, ratio, young, radius, normal_force))
        guess(key, value);
    try {
        return io::resolve_case(rig, guesses);
    } catch (const contact::InputError& error) {
        // It names the case's models; the file calls them otherwise.
        throw contact::InputError(boost::replace_all_copy(
            std::string(error.what()), io::layer_theory().rules, io::layer_theory().name));
    }
}

/// A table for each file that a key names.
std::vector<Table> tables_of(const TableKey& one, const io::Document& document) {
    const io::Key& key = io::rig_key(one.key);
    std::vector<std::string> files(1);
    const bool is_list = key.kind == io::Key::Kind::choice_list;
    io::read_field(key, *document.find(one.key),
                   is_list ? io::Field(&files) : io::Field(&files.front()));
    std::vector<Table> tables;
    std::set<std::string> opened;
    for (const std::string& file : files) {
        Table& table = tables.emplace_back(
            Table{.measurement = one.measurement, .data_file = document.path_of(file)});
        if (!one.held.empty())
            io::read_or_default(io::rig_key(one.held), io::Field(&table.held), document,
                                io::case_file_keys());
        if (files.size() == 1) continue;
        table.place = tables.size() - 1;
        table.label = file;
        if (!opened.insert(std::filesystem::path(table.data_file).lexically_normal().string())
                 .second)
            io::refuse(document, std::string(one.key), file + " stands twice",
                       "name each table once");
    }
    return tables;
}

std::vector<std::string> unread_keys(const io::Document& document, bool has_loops) {
    constexpr std::array<std::string_view, 4> sections{"load", "rolling", "tractive_rolling",
                                                       "rig"};
    constexpr std::array<std::string_view, 3> read{pivot_key, "rig.work_of_adhesion",
                                                   "rig.interatomic_distance"};
    std::vector<std::string> keys;
    for (const io::Entry& entry : document.entries) {
        const std::string top = entry.path.substr(0, entry.path.find('.'));
        if (std::ranges::count(sections, top) && !describes_rig(entry.path) &&
            !std::ranges::count(read, entry.path) && !std::ranges::count(keys, entry.path) &&
            !(has_loops && entry.path == rig_stiffness_key))
            keys.push_back(entry.path);
    }
    return keys;
}

/// Of what is taken as known.
std::vector<Input::RigError> read_rig_errors(const Input& input, const io::Document& document) {
    const bool sheared = is_sheared(input);
    std::vector<Input::RigError> errors;
    for (const io::UncertainKey& one : io::uncertain_numbers(document, input.rig)) {
        const std::string_view path = one.key->path;
        const bool is_used = sheared || (path != coefficient_key && path != "load.normal_force");
        if (io::find_key(path) && describes_rig(path) && !input.is_free(path) && is_used)
            errors.push_back({io::find_key(path), one.number.value.standard_error});
    }
    return errors;
}

}  // namespace

const Table* Input::find(Measurement measurement) const {
    const auto found = std::ranges::find(tables, measurement, &Table::measurement);
    return found == tables.end() ? nullptr : &*found;
}

std::vector<const Table*> Input::all(Measurement measurement) const {
    std::vector<const Table*> found;
    for (const Table& table : tables)
        if (table.measurement == measurement) found.push_back(&table);
    return found;
}

bool Input::is_free(std::string_view key) const {
    return std::ranges::find(parameters, key, &FreeParameter::key) != parameters.end();
}

Input read_identification(const std::string& path, const std::vector<std::string>& overrides) {
    const io::Document document = io::read_rig_document(
        path, overrides, "measurement", "nothing was measured",
        "add one with static_shift = \"shift.csv\", find = [\"substrate.young\"] and models = "
        "[\"half-space\", \"layer\"]");
    if (const auto* loads = document.find_section("path"))
        io::fail(loads->place, "[path]", "what was measured stands in tables of [measurement]",
                 "omit it, and give load.normal_force; tricontact run computes paths");
    Input input;
    input.name = path;
    std::vector<std::string> find;
    const auto read = [&](std::string_view key, const io::Field& field) {
        io::read_or_default(io::rig_key(key), field, document, io::case_file_keys());
    };
    for (const TableKey& one : table_keys()) {
        if (!document.find(one.key)) continue;
        for (Table& table : tables_of(one, document)) input.tables.push_back(std::move(table));
    }
    if (input.tables.empty())
        io::fail(
            document.place_of("measurement.find"), "", "nothing was measured",
            "name a table: static_shift = \"shift.csv\", force_indentation, contact_radius, "
            "force_relaxation, indentation_creep, rolling_shift, sliding_force or friction_loop");
    read("measurement.models", &input.models);
    if (document.find("measurement.laws")) read("measurement.laws", &input.laws);
    read("measurement.find", &find);
    const bool is_adhesive =
        std::ranges::count(find, work_key) > 0 || document.find_section("adhesion");
    for (Table& table : input.tables) {
        table.has_free_zero = table.measurement == Measurement::force_indentation &&
                              std::ranges::count(find, zero_depth_key) > 0;
        table.is_adhesive = is_adhesive;
    }
    read("measurement.confidence", &input.confidence);
    if (const io::Entry* title = document.find("title"))
        io::read_field(*io::find_key("title"), *title, &input.title);
    check_find(input, find, document);
    check_adhesive_tables(input, find, document);
    check_loop_tables(input, find, document);
    check_laws(input, find, document);
    check_interface(input, find, document);
    check_models(input, document);
    // Of several tables each needs a row that is left for its own error.
    input.rig_compliance = compliance_of_rig(input, document);
    const std::size_t least_rows = input.tables.size() == 1 ? find.size() + 1 : 2;
    for (Table& table : input.tables)
        io::told_at(document, std::string(key_of(table.measurement)),
                    [&] { read_measured_table(table, least_rows + table.has_free_origin()); });
    check_loads(input, document);
    input.rig = rig_of(input, find, document);
    input.rig.refuse_extras("identified values", {contact::Case::Extra::elastic_interface,
                                                  contact::Case::Extra::adhesion});
    input.rig.title = input.title;
    input.unread = unread_keys(document, input.find(Measurement::friction_loop) != nullptr);
    if (std::ranges::count(find, "substrate.young") > 0 && io::states_unrelaxed(document))
        io::refuse(document, "substrate.relaxation.modulus",
                   "measurement.find has substrate.young, which is found as the relaxed modulus",
                   "omit it");
    input.parameters =
        io::told_at(document, "measurement.find", [&] { return free_parameters(input, find); });
    check_rows_of_laws(input, document);
    check_friction(input, document);
    check_adhesive_friction(input, document);
    input.rig_errors = read_rig_errors(input, document);
    const auto of_rig = [&](const char* key) -> std::optional<double> {
        const io::Entry* entry = document.find(key);
        if (!entry) return {};
        return io::read_uncertain_number(io::rig_key(key), *entry).value.value;
    };
    input.work_of_adhesion = of_rig("rig.work_of_adhesion");
    if (const auto distance = of_rig("rig.interatomic_distance"))
        input.interatomic_distance = *distance;
    input.correlations =
        io::correlations(document, io::uncertain_keys(document, io::case_file_keys()));
    return input;
}

}  // namespace tricontact::experiments
