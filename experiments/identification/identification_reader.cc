#include "experiments/identification/identification_reader.h"

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>
#include <set>

#include "contact/error.h"
#include "io/case/case_reader.h"
#include "io/keys/field_reader.h"
#include "io/keys/input_file.h"
#include "io/keys/key.h"
#include "io/keys/key_checks.h"
#include "io/keys/messages.h"
#include "io/keys/toml_document.h"

namespace tricontact::experiments {

namespace {

using Input = IdentificationInput;
using Measurement = Input::Measurement;
using Kind = io::Key::Kind;

constexpr std::string_view errors_section = "standard_errors";

const std::vector<io::PlacedKey<Input>>& own_keys() {
    using enum Input::Measurement;
    static const std::vector<io::PlacedKey<Input>> keys{
        {io::text_key("title", R"("Rig, static shift")", "what was measured"),
         io::at<&Input::title>},
        {io::choice_key("measurement",
                        {io::choice("static-shift", static_shift),
                         io::choice("force-indentation", force_indentation),
                         io::choice("contact-radius", contact_radius)},
                        R"("static-shift")", "what the table holds"),
         io::at<&Input::measurement>},
        {io::text_key("data", R"("shift.csv")", "the table"), io::at<&Input::data_file>},
        {io::list_of(io::choice_key("models",
                                    {{"half-space"}, {"layer"}, {"atlas"}, {"bem-layer"}, {"fem"}},
                                    R"(["half-space", "layer"])", "models that explain it")),
         io::at<&Input::models>},
        {io::number_key("confidence", {0.5, 0.9999}, "0.95", "level of the intervals"),
         io::at<&Input::confidence>}};
    return keys;
}

/// Keys of a case that describe a rig.
bool describes_rig(const io::Key& key) {
    constexpr std::array<std::string_view, 8> sections{
        "indenter", "substrate", "lower_layer", "ground", "friction", "contact", "bem", "fem"};
    constexpr std::array<std::string_view, 3> load{"load.normal_force", "load.press",
                                                   "load.press_steps"};
    return std::ranges::count(sections, key.section()) || std::ranges::count(load, key.path);
}

bool is_nested_in_measurement(std::string_view path) {
    return path.starts_with("standard_errors.");
}

/// Its own keys, and those that describe a rig.
const io::KeyList& key_list() {
    static const io::KeyList list = [] {
        std::vector<const io::Key*> keys;
        for (const io::Key& key : own_keys()) keys.push_back(&key);
        for (const io::Key& key : io::case_keys())
            if (describes_rig(key)) keys.push_back(&key);
        return io::KeyList(keys, "docs/identify.md");
    }();
    return list;
}

void check_measurement_keys(const io::Document& document) {
    const std::string listed = "docs/identify.md lists what it has";
    for (const io::Entry& entry : document.entries)
        if (io::find_key(entry.path) && !key_list().find(entry.path))
            io::fail(entry.key_place, "", "a measurement has no key " + entry.path, listed);
    io::check_names(
        document, key_list(),
        {.sections = {errors_section}, .is_open = is_nested_in_measurement, .remedy = listed});
}

const io::Entry& required(const io::Document& document, std::string_view path) {
    return io::required(*key_list().find(path), document, key_list());
}

double quantity_of(const io::Document& document, std::string_view path) {
    double value = 0;
    io::read_field(*io::find_key(path), required(document, path), io::Field(&value));
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
                document, "models",
                model + " is a model of a layer, but substrate.thickness is missing",
                "add thickness = \"8 mm\" or the like to [substrate], or leave out " + model);
        if ((model == "bem-layer" || model == "atlas") &&
            input.measurement != Measurement::static_shift)
            io::refuse(
                document, "models",
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
        io::refuse(document, "data",
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
    std::erase_if(rig.entries, [](const io::Entry& entry) {
        return io::section_of(entry.path).empty() || is_nested_in_measurement(entry.path);
    });
    std::erase_if(rig.sections, [](const io::Document::Section& section) {
        return section.name == errors_section || is_nested_in_measurement(section.name);
    });
    const bool sheared = input.measurement == Measurement::static_shift;
    check_round(document);
    const double radius = quantity_of(document, "indenter.radius");
    check_lengths(input, radius, document);
    std::vector<io::Entry> guesses{
        io::overriding("models", case_models(input), document.find("models")->place)};
    const auto guess = [&](const char* path, io::Value value) {
        guesses.push_back(io::overriding(path, std::move(value), input.data_file));
    };
    guess("load.tangential_ratio", 0.);
    double normal_force = 0;
    if (sheared) {
        normal_force = quantity_of(document, "load.normal_force");
    } else {
        if (document.find("load.normal_force"))
            io::refuse(document, "load.normal_force", "the normal force is in the table",
                       "omit this key");
        const bool given = input.measurement == Measurement::contact_radius;
        normal_force = std::ranges::max(given ? input.given : input.observed);
        guess("load.normal_force", io::shortest(normal_force) + " N");
    }
    // Frictionless contact knows no coupling, and the half-space's closed forms have none.
    const auto n_half_spaces = std::ranges::count(input.models, "half-space");
    if (!sheared || n_half_spaces == std::ssize(input.models)) guess("contact.coupling", false);
    if (input.young_is_free)
        guess("substrate.young", io::shortest(guessed_young(input, radius, normal_force)) + " Pa");
    if (!document.find("friction.coefficient")) {
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

std::vector<Input::RigError> read_rig_errors(const io::Document& document) {
    std::vector<Input::RigError> errors;
    for (const io::Entry& entry : document.entries) {
        if (!is_nested_in_measurement(entry.path)) continue;
        const std::string path = entry.path.substr(errors_section.size() + 1);
        const io::CaseKey* key = io::find_key(path);
        if (!key || !describes_rig(*key) || key->section() == "bem" || key->section() == "fem" ||
            (key->kind != Kind::quantity && key->kind != Kind::number))
            io::fail(entry.key_place, entry.path, "is no number that describes the rig",
                     "write for example load.normal_force = \"0.1 N\"");
        if (!document.find(path))
            io::fail(entry.key_place, entry.path, "has an error, but no value",
                     "give " + path + ", or omit its error");
        io::Key error_key = *key;
        error_key.range = {0, key->range.high, false, true};
        error_key.reason = {};
        double value = 0;
        io::read_field(error_key, entry, io::Field(&value));
        errors.push_back({key, value});
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
                   "correct it, or omit it to have it identified");
}

}  // namespace

std::string_view name_of(Measurement measurement) {
    const auto& words = key_list().find("measurement")->choices;
    return std::ranges::find(words, static_cast<int>(measurement), &io::Choice::enumerator)->word;
}

Input read_identification(const std::string& path) {
    const io::Document document = io::parse_document(
        io::read_input_file(path, "identification file"), path, is_nested_in_measurement);
    io::require_kind(io::FileKind::measurement, document);
    check_measurement_keys(document);
    Input input;
    input.name = path;
    for (const char* key : {"measurement", "models", "data"}) required(document, key);
    io::read_given(own_keys(), input, document);
    input.data_file = document.path_of(input.data_file);
    check_models(input, document);
    input.young_is_free = !document.find("substrate.young");
    input.friction_is_free =
        input.measurement == Measurement::static_shift && !document.find("friction.coefficient");
    if (!input.young_is_free && !input.friction_is_free)
        io::refuse(document, "substrate.young", "nothing is left to be identified",
                   "omit the key that is to be found");

    io::told_at(document, "data", [&] { read_measured_table(input); });
    input.rig = rig_of(input, document);
    input.rig.title = input.title;
    check_friction(input, document);
    input.rig_errors = read_rig_errors(document);
    return input;
}

}  // namespace tricontact::experiments
