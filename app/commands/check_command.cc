#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/commands/command.h"
#include "comparisons/quantities/left_out.h"
#include "comparisons/quantities/quantity.h"
#include "comparisons/quantities/reference.h"
#include "comparisons/run/input_reading.h"
#include "comparisons/run/path_section.h"
#include "io/case/case_keys.h"
#include "rolling/creep_theory.h"
#include "walking/input/walk_keys.h"
#include "walking/input/walk_reader.h"
#include "walking/report/walk_document.h"

namespace tricontact::app {

namespace {

/// What files were taken for.
std::string input_values(const Case& c) {
    std::string text;
    for (const std::string& sentence : comparisons::input_sentences(c))
        text += "# " + sentence + '\n';
    return text.empty() ? text : "# What was read\n" + text + '\n';
}

std::string derived_values(const Case& c) {
    const contact::HalfSpaceScales hertz = half_space_scales(c);
    const contact::MaterialPair materials = c.materials();
    std::string text = c.is_cylindrical()
                           ? "# What follows from it (Hertz' line contact, a strip of its length)\n"
                           : "# What follows from it on the half-space\n";
    auto line = [&](const char* name, double value, const char* unit, const char* meaning) {
        text += fmt::format("# {:<8} = {:>12.6g} {:<4} {}\n", name, value, unit, meaning);
    };
    line("a", hertz.contact_radius * 1e3, "mm",
         c.is_cylindrical() ? "half width of the contact" : "contact radius");
    line("d", hertz.indentation * 1e3, "mm", "indentation");
    line("F_N", hertz.normal_force, "N", "normal force");
    line(contact::has_conical_tip(c) ? "p_m" : "p0", hertz.peak_pressure * 1e-6, "MPa",
         comparisons::pressure_name(c));
    line("U_max", hertz.unit_shift * 1e3, "mm", "shift at the onset of sliding");
    line("E*", materials.effective_modulus() * 1e-6, "MPa", "effective modulus");
    line("G*", materials.effective_shear_modulus() * 1e-6, "MPa", "effective shear modulus");
    line("beta", materials.dundurs_beta(), "-", "Dundurs' constant");
    if (c.tractive_rolling)
        line("xi_unit", rolling::creepage_unit(c), "-", "unit of creepage, mu a/R");
    if (c.prescribed_path && c.prescribed_path->twists())
        text += "# twist " + comparisons::centre_of_rotation_text(c) + "\n";
    if (c.tractive_rolling && c.tractive_rolling->longitudinal_creepage) return text;
    const comparisons::Reference r = comparisons::reference(c);
    if (std::isfinite(r.tangential_ratio)) {
        line("F_T", r.tangential_ratio * hertz.friction_limit, "N", "tangential force");
        line("f_T", r.tangential_ratio, "-",
             c.friction.is_coulomb() ? "F_T/(mu F_N)" : "over what friction carries");
    }
    if (!c.rolling) return text;
    line("W", r.amplitude_ratio * hertz.contact_radius * 1e3, "mm", "rolling amplitude");
    line("w", r.amplitude_ratio, "-", "W/a");
    if (r.limit_tangential_ratio)
        line("f_T,lim", *r.limit_tangential_ratio, "-", "shakedown limit of uncoupled contact");
    return text;
}

/// What models of the case compute without.
std::string left_out_values(const Case& c) {
    std::string text;
    for (const std::string& model : c.models)
        for (const std::string& one : comparisons::left_out(c, model))
            text += fmt::format("# {} leaves out {}\n", model, one);
    return text;
}

/// The resolved case and what follows from it.
struct Resolved {
    std::string operator()(const Case& c) const {
        return io::write_case(c) + '\n' + input_values(c) + derived_values(c) + left_out_values(c);
    }
    std::string operator()(const walking::WalkCase& c) const {
        return walking::write_walk_case(c) + '\n' + walking::walk_scales_text(c);
    }
};

struct ListOptions {
    std::optional<std::string> folder;
};

/// The models, and the case files below a folder; if none is given those below "examples/cases" or
/// "cases" if there is one.
void list_models_and_cases(const ListOptions& options) {
    const auto& given = options.folder;
    const std::string folder = given.value_or(
        std::filesystem::is_directory("examples/cases") ? "examples/cases" : "cases");
    std::cout << "models\n";
    for (const auto& model : known_models())
        std::cout << fmt::format("  {:<8} {}\n", model.name, model.text);
    if (!std::filesystem::is_directory(folder)) {
        if (!given) return;
        throw contact::InputError(folder + ": is not a folder; name one that holds case files");
    }
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".toml") files.push_back(entry.path().string());
    std::sort(files.begin(), files.end());
    std::cout << "cases\n";
    for (const auto& file : files) {
        const auto title = [](const auto& c) { return c.title; };
        std::cout << fmt::format("  {}: {}\n", file,
                                 std::visit(title, walking::read_any_case(file)));
    }
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
        std::cout << std::visit(Resolved{}, walking::read_any_case(o.file, o.overrides));
    };
    return Declared<CommandOptions>(Group::trust, "check",
                                    "Validate a case; print it resolved, with scales", check)
        .on_case();
}

Command list_command() {
    return Declared<ListOptions>(Group::tools, "list",
                                 "List the models and the case files of a folder",
                                 list_models_and_cases)
        .option("folder", &ListOptions::folder, "Folder to look into (cases)");
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
