#include "experiments/identification/identification_reader.h"

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>
#include <set>

#include "contact/error.h"
#include "io/case/case_reader.h"
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

struct Table {
    Measurement measurement;
    std::string_view name, key;
};
constexpr std::array<Table, 3> tables{
    {{Measurement::static_shift, "static-shift", "measurement.static_shift"},
     {Measurement::force_indentation, "force-indentation", "measurement.force_indentation"},
     {Measurement::contact_radius, "contact-radius", "measurement.contact_radius"}}};

const Table& table_of(Measurement measurement) {
    return *std::ranges::find(tables, measurement, &Table::measurement);
}
std::string key_of(const Input& input) {
    return std::string(table_of(input.measurement).key);
}

/// Keys of a case that describe a rig; loads along the surface and rolling are not in what was
/// measured.
bool describes_rig(std::string_view path) {
    constexpr std::array<std::string_view, 8> sections{
        "indenter", "substrate", "lower_layer", "ground", "friction", "contact", "bem", "fem"};
    constexpr std::array<std::string_view, 4> others{"title", "load.normal_force", "load.press",
                                                     "load.press_steps"};
    const auto top = path.substr(0, path.find('.'));
    return std::ranges::count(sections, top) || std::ranges::count(others, path);
}

double quantity_of(const io::Document& document, std::string_view path) {
    double value = 0;
    const io::Key& key = *io::find_key(path);
    io::read_field(key, io::required(key, document, io::case_key_list()), io::Field(&value));
    return value;
}

/// What the models of the case have to be so that its checks are those of the identification's. The
/// closed forms of the half-space need none.
std::vector<std::string> case_models(const Input& input) {
    const bool sheared = input.measurement == Measurement::static_shift;
    std::set<std::string> models;
    for (const std::string& model : input.models)
        if (model != "half-space")
            models.insert(model == "atlas"   ? "bem-layer"
                          : model != "layer" ? model
                          : sheared          ? "mdr-layer"
                                             : "mdr");
    if (models.empty()) models.insert("mdr");
    return {models.begin(), models.end()};
}

void check_models(const Input& input, const io::Document& document) {
    for (const std::string& model : input.models) {
        if (model != "half-space" && !document.find("substrate.thickness"))
            io::refuse(
                document, "measurement.models",
                model + " is a model of a layer, but substrate.thickness is missing",
                "add thickness = \"8 mm\" or the like to [substrate], or leave out " + model);
        if ((model == "bem-layer" || model == "atlas") &&
            input.measurement != Measurement::static_shift)
            io::refuse(
                document, "measurement.models",
                "without tangential force " + model + " approximates what layer knows exactly",
                "write \"layer\" instead");
    }
}

/// E by Hertz' theory of an incompressible half-space from the row of the largest value [Pa]; mu
/// infinite.
double guessed_young(const Input& input, double radius, double normal_force) {
    const auto row = std::ranges::max_element(input.observed) - input.observed.begin();
    const double x = input.given[row], y = input.observed[row];
    constexpr double over_plane = 0.75;                  // E/E*
    constexpr double shear_over_plane = 2. / 3;          // G*/E*
    const double cube = 3. / 4 * radius * normal_force;  // a^3 E*
    switch (input.measurement) {
        case Measurement::force_indentation:
            return over_plane * 3. / 4 * y / std::sqrt(radius * x * x * x);
        case Measurement::contact_radius:
            return over_plane * 3. / 4 * radius * x / (y * y * y);
        case Measurement::static_shift:
            break;
    }
    return over_plane * std::pow(x / (2 * shear_over_plane * y * std::cbrt(cube)), 1.5);
}

/// Lengths of a contact are small against the indenter's radius, unless their unit is wrong.
void check_lengths(const Input& input, double radius, const io::Document& document) {
    const bool deep = input.measurement == Measurement::force_indentation;
    const MeasuredColumns& columns = columns_of(input.measurement);
    const double largest = std::ranges::max(deep ? input.given : input.observed);
    if (largest >= radius)
        io::refuse(document, key_of(input),
                   std::string(deep ? columns.given.name : columns.observed.name) + " reaches " +
                       io::shortest(largest) + " m, the indenter's radius is " +
                       io::shortest(radius) + " m: small deformations are assumed",
                   "check the units of the table and of indenter.radius");
}

/// Hertz' theory is one of the models, and the others are laid over its radius.
void check_round(const io::Document& document) {
    const io::Entry* shape = document.find("indenter.shape");
    if (!shape) return;
    const auto* word = std::get_if<std::string>(&shape->value);
    if (word && (*word == "paraboloid" || *word == "sphere")) return;
    io::refuse(document, "indenter.shape",
               "material constants are identified under a round indenter",
               "take \"paraboloid\" or \"sphere\"");
}

/// The rig as a case: what is to be found has a guess.
contact::Case rig_of(const Input& input, const io::Document& document) {
    io::Document rig = document;
    std::erase_if(rig.entries, [&](const io::Entry& entry) {
        const bool is_free = (input.young_is_free && entry.path == "substrate.young") ||
                             (input.friction_is_free && entry.path == "friction.coefficient");
        return is_free || !describes_rig(entry.path);
    });
    std::erase_if(rig.sections, [](const io::Document::Section& section) {
        return section.name != "load" && !describes_rig(section.name);
    });
    const bool sheared = input.measurement == Measurement::static_shift;
    check_round(document);
    const double radius = quantity_of(document, "indenter.radius");
    check_lengths(input, radius, document);
    std::vector<io::Entry> guesses{
        io::overriding("models", case_models(input), document.place_of("measurement.models"))};
    const auto guess = [&](const char* path, io::Value value) {
        guesses.push_back(io::overriding(path, std::move(value), input.data_file));
    };
    guess("load.tangential_ratio", 0.);
    double normal_force = 0;
    if (sheared) {
        if (!document.find("load.normal_force"))
            io::fail(
                document.place_of("load.normal_force"), "", "missing key load.normal_force",
                "add the force under which the shifts were measured: normal_force = \"21.1 N\"");
        normal_force = quantity_of(document, "load.normal_force");
    } else {
        const bool given = input.measurement == Measurement::contact_radius;
        normal_force = std::ranges::max(given ? input.given : input.observed);
        guess("load.normal_force", io::shortest(normal_force) + " N");
    }
    // Frictionless contact knows no coupling, and the half-space's closed forms have none.
    const auto n_half_spaces = std::ranges::count(input.models, "half-space");
    if (!sheared || n_half_spaces == std::ssize(input.models)) guess("contact.coupling", false);
    if (input.young_is_free)
        guess("substrate.young", io::shortest(guessed_young(input, radius, normal_force)) + " Pa");
    if (input.friction_is_free || (!sheared && !rig.find("friction.coefficient"))) {
        const double largest = std::ranges::max(input.given);
        guess("friction.coefficient", sheared ? 1.5 * largest / normal_force : 1.);
    }
    try {
        return io::resolve_case(rig, guesses);
    } catch (const contact::InputError& error) {
        // It names the case's models; the file calls them otherwise.
        throw contact::InputError(
            boost::replace_all_copy(std::string(error.what()), "mdr-layer", "layer"));
    }
}

/// Of what is taken as known.
std::vector<Input::RigError> read_rig_errors(const Input& input, const io::Document& document) {
    const bool sheared = input.measurement == Measurement::static_shift;
    std::vector<Input::RigError> errors;
    for (const io::UncertainKey& one : io::uncertain_keys(document, io::case_key_list())) {
        const std::string_view path = one.key->path;
        const bool is_free = (input.young_is_free && path == "substrate.young") ||
                             (input.friction_is_free && path == "friction.coefficient");
        const bool is_used =
            sheared || (path != "friction.coefficient" && path != "load.normal_force");
        if (describes_rig(path) && !is_free && is_used)
            errors.push_back({io::find_key(path), one.number.value.standard_error});
    }
    return errors;
}

/// Sliding contacts have no static shift.
void check_friction(const Input& input, const io::Document& document) {
    if (input.measurement != Measurement::static_shift || input.friction_is_free) return;
    const double largest = std::ranges::max(input.given);
    const double limit = input.rig.friction_coefficient * *input.rig.load.normal_force;
    if (largest >= limit)
        io::refuse(document, "friction.coefficient",
                   "the contact would slide: F_T of the table reaches " + io::shortest(largest) +
                       " N, mu F_N is " + io::shortest(limit) + " N",
                   "correct it, or name it in measurement.find");
}

}  // namespace

std::string_view name_of(Measurement measurement) {
    return table_of(measurement).name;
}

Input read_identification(const std::string& path, const std::vector<std::string>& overrides) {
    const io::Document document = io::read_rig_document(
        path, overrides, "measurement", "nothing was measured",
        "add one with static_shift = \"shift.csv\", find = [\"substrate.young\"] and models = "
        "[\"half-space\", \"layer\"]");
    Input input;
    input.name = path;
    const auto table = std::ranges::find_if(
        tables, [&](const Table& one) { return document.find(one.key) != nullptr; });
    if (table == tables.end())
        io::refuse_missing(io::rig_key(tables.front().key), document, io::case_file_keys());
    input.measurement = table->measurement;
    std::vector<std::string> find;
    const auto read = [&](std::string_view key, const io::Field& field) {
        io::read_or_default(io::rig_key(key), field, document, io::case_file_keys());
    };
    read(table->key, &input.data_file);
    read("measurement.models", &input.models);
    read("measurement.find", &find);
    read("measurement.confidence", &input.confidence);
    if (const io::Entry* title = document.find("title"))
        io::read_field(*io::find_key("title"), *title, &input.title);
    input.data_file = document.path_of(input.data_file);
    input.young_is_free = std::ranges::count(find, "substrate.young") > 0;
    input.friction_is_free = std::ranges::count(find, "friction.coefficient") > 0;
    if (input.friction_is_free && input.measurement != Measurement::static_shift)
        io::refuse(document, "measurement.find",
                   "without tangential force nothing tells the coefficient of friction",
                   "leave out friction.coefficient");
    check_models(input, document);
    io::told_at(document, key_of(input), [&] { read_measured_table(input); });
    input.rig = rig_of(input, document);
    input.rig.title = input.title;
    check_friction(input, document);
    input.rig_errors = read_rig_errors(input, document);
    return input;
}

}  // namespace tricontact::experiments
