#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "comparisons/adhesion/adhesion_forms.h"
#include "comparisons/quantities/left_out.h"
#include "comparisons/quantities/quantity.h"
#include "comparisons/quantities/reference.h"
#include "comparisons/run/input_reading.h"
#include "comparisons/run/path_section.h"
#include "comparisons/strength/body_strength.h"
#include "io/case/case_keys.h"
#include "report/derived_value.h"
#include "rolling/creep_theory.h"
#include "walking/input/walk_keys.h"
#include "walking/input/walk_reader.h"
#include "walking/report/walk_document.h"

namespace tricontact::app {

namespace {

using Json = nlohmann::ordered_json;

/// What files were taken for.
std::string input_values(const Case& c) {
    std::string text;
    for (const std::string& sentence : comparisons::input_sentences(c))
        text += "# " + sentence + '\n';
    return text.empty() ? text : "# What was read\n" + text + '\n';
}

/// What a yield or bulk stress makes of the bodies; `tangential_ratio` is F_T/(mu F_N), not finite
/// where a run alone knows it.
void add_strength(const Case& c, double tangential_ratio, std::vector<report::DerivedValue>& all) {
    if (c.has_bulk_stress())
        all.push_back({"eps", c.bulk_state(comparisons::largest_bulk_stress(c)).strain[0], "1",
                       "strain by the bulk stress"});
    if (!c.yield_stress.any() && !c.has_bulk_stress()) return;
    const auto loads = comparisons::prescribed_loads(c, tangential_ratio);
    if (!loads) return;
    const auto strength = comparisons::strength_of(c, *loads);
    if (!strength || !strength->is_known()) return;
    if (strength->weakest())
        all.push_back({"Y/sigma_M", strength->weakest()->factor(), "1",
                       "yield stress over von Mises' largest stress"});
    if (strength->line)
        all.push_back(
            {"sigma_xx", strength->line->trailing_stress(), "Pa", "stress at the trailing edge"});
}

std::vector<report::DerivedValue> derived_values(const Case& c) {
    const contact::HalfSpaceScales hertz = half_space_scales(c);
    const contact::MaterialPair materials = c.materials();
    const std::string pressure = comparisons::pressure_name(c);
    std::vector<report::DerivedValue> all{
        {"a", hertz.contact_radius, "m",
         c.is_cylindrical() ? "half width of the contact" : "contact radius"},
        {"d", hertz.indentation, "m", "indentation"},
        {"F_N", hertz.normal_force, "N", "normal force"},
        {contact::has_conical_tip(c) ? "p_m" : "p0", hertz.peak_pressure, "Pa", pressure},
        {"U_max", hertz.unit_shift, "m", "shift at the onset of sliding"},
        {"E*", materials.effective_modulus(), "Pa", "effective modulus"},
        {"G*", materials.effective_shear_modulus(), "Pa", "effective shear modulus"},
        {"beta", materials.dundurs_beta(), "1", "Dundurs' constant"}};
    std::ranges::move(comparisons::adhesive_values(c), std::back_inserter(all));
    if (c.tractive_rolling)
        all.push_back({"xi_unit", rolling::creepage_unit(c), "1", "unit of creepage, mu a/R"});
    if (c.tractive_rolling && c.tractive_rolling->longitudinal_creepage) return all;
    const comparisons::Reference r = comparisons::reference(c);
    if (std::isfinite(r.tangential_ratio)) {
        all.push_back(
            {"F_T", r.tangential_ratio * r.hertz.friction_limit, "N", "tangential force"});
        all.push_back({"f_T", r.tangential_ratio, "1",
                       c.friction.is_coulomb() ? "F_T/(mu F_N)" : "over what friction carries"});
    }
    add_strength(c, r.tangential_ratio, all);
    if (!c.rolling) return all;
    all.push_back({"W", r.amplitude_ratio * r.hertz.contact_radius, "m", "rolling amplitude"});
    all.push_back({"w", r.amplitude_ratio, "1", "W/a"});
    if (r.limit_tangential_ratio)
        all.push_back(
            {"f_T,lim", *r.limit_tangential_ratio, "1", "shakedown limit of uncoupled contact"});
    return all;
}

/// "twist by 1 deg about ..."; empty of other cases.
std::string twist_of(const Case& c) {
    if (!c.prescribed_path || !c.prescribed_path->twists()) return {};
    return "twist " + comparisons::centre_of_rotation_text(c);
}

/// What models of the case compute without.
std::vector<std::string> left_out_values(const Case& c) {
    std::vector<std::string> lines;
    for (const std::string& model : c.models)
        for (const std::string& one : comparisons::left_out(c, model))
            lines.push_back(fmt::format("{} leaves out {}", model, one));
    return lines;
}

Json checked(const char* kind, const std::string& title, const std::string& resolved,
             const std::vector<report::DerivedValue>& values) {
    return {{"version", files::version},
            {"kind", kind},
            {"title", title},
            {"case", io::case_json(resolved)},
            {"derived", report::derived_json(values)}};
}

/// The resolved case and what follows from it.
struct Resolved {
    Answer operator()(const Case& c) const {
        const std::string resolved = io::write_case(c);
        const std::vector<report::DerivedValue> values = derived_values(c);
        const char* const kind = c.tractive_rolling ? "rolling on" : "contact";
        const std::vector<std::string> left_out = left_out_values(c);
        const std::string twist = twist_of(c);
        std::string text = resolved + '\n' + input_values(c) +
                           (c.is_cylindrical() ? "# What follows from it (Hertz' line contact, a "
                                                 "strip of its length)\n"
                                               : "# What follows from it on the half-space\n") +
                           report::derived_lines(values);
        if (!twist.empty()) text += "# " + twist + '\n';
        for (const std::string& line : left_out) text += "# " + line + '\n';
        const std::vector<std::string> adhesion = comparisons::adhesion_sentences(c);
        for (const std::string& line : adhesion) text += "# " + line + '\n';
        return Answer(
            [=] {
                Json json = checked(kind, c.title, resolved, values);
                json["input"] = comparisons::input_sentences(c);
                if (!twist.empty()) json["input"].push_back(twist);
                json["left_out"] = left_out;
                for (const std::string& line : adhesion) json["input"].push_back(line);
                return json.dump(2);
            },
            text);
    }
    Answer operator()(const walking::WalkCase& c) const {
        const std::string resolved = walking::write_walk_case(c);
        const std::vector<report::DerivedValue> values = walking::walk_scales(c);
        return Answer([=] { return checked("walking", c.title, resolved, values).dump(2); },
                      resolved + "\n# What follows from it (Wetter (2016), chapter 4)\n" +
                          report::derived_lines(values));
    }
};

struct ListOptions : CommandOptions {
    std::optional<std::string> folder;
};

/// The case files below a folder, sorted, with their titles.
std::vector<std::pair<std::string, std::string>> titled_cases(const std::string& folder) {
    std::vector<std::pair<std::string, std::string>> cases;
    const auto title = [](const auto& c) { return c.title; };
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".toml") cases.emplace_back(entry.path().string(), "");
    std::ranges::sort(cases);
    for (auto& [file, text] : cases) text = std::visit(title, walking::read_any_case(file));
    return cases;
}

/// The models, and the case files below a folder; if none is given those below "examples/cases" or
/// "cases" if there is one.
void list_models_and_cases(const ListOptions& options) {
    const auto& given = options.folder;
    const std::string folder = given.value_or(
        std::filesystem::is_directory("examples/cases") ? "examples/cases" : "cases");
    const bool has_cases = std::filesystem::is_directory(folder);
    if (!has_cases && given)
        throw contact::InputError(folder + ": is not a folder; name one that holds case files");
    const auto cases = has_cases ? titled_cases(folder) : decltype(titled_cases(folder)){};
    std::size_t width = 0;
    for (const auto& model : known_models())
        width = std::max(width, std::string(model.name).size());
    std::string text = "models\n";
    for (const auto& model : known_models())
        text += fmt::format("  {:<{}} {}\n", model.name, width, model.text);
    if (has_cases) text += "cases\n";
    for (const auto& [file, title] : cases) text += fmt::format("  {}: {}\n", file, title);
    options.answer(Answer(
        [&] {
            Json json{{"models", Json::array()}, {"cases", Json::array()}};
            for (const auto& model : known_models())
                json["models"].push_back({{"name", model.name}, {"text", model.text}});
            for (const auto& [file, title] : cases)
                json["cases"].push_back({{"file", file}, {"title", title}});
            return json.dump(2);
        },
        text));
}

struct KeysOptions {
    std::string kind = "case";
};

void print_keys(const KeysOptions& options) {
    const std::string& kind = options.kind;
    if (kind == "results")
        std::cout << comparisons::glossary();
    else if (kind == "summary")
        std::cout << comparisons::summary_keys();
    else
        std::cout << io::key_reference(kind == "walking" ? walking::walk_file_keys()
                                                         : io::case_file_keys());
}

}  // namespace

Command check_command() {
    const auto check = [](const CommandOptions& o) {
        o.answer(std::visit(Resolved{}, walking::read_any_case(o.file, o.overrides)));
    };
    return Declared<CommandOptions>(Group::trust, "check",
                                    "Validate a case; print it resolved, with scales", check)
        .on_case()
        .json();
}

Command list_command() {
    return Declared<ListOptions>(Group::tools, "list",
                                 "List the models and the case files of a folder",
                                 list_models_and_cases)
        .option("folder", &ListOptions::folder, "Folder to look into (cases)")
        .json("As JSON");
}

Command keys_command() {
    return Declared<KeysOptions>(
               Group::tools, "keys",
               "Print the reference of all keys of an input file, or of all results", print_keys)
        .word("kind", &KeysOptions::kind,
              "case, walking for the micro-walking machine, results, or summary",
              {"case", "walking", "results", "summary"});
}

}  // namespace tricontact::app
