#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/commands/command.h"
#include "bem/contact_program_influence.h"
#include "bem/grid_compliance.h"
#include "bem/model.h"
#include "bem/settings.h"
#include "comparisons/quantities/left_out.h"
#include "comparisons/run/input_reading.h"
#include "contact/models/model_kind.h"
#include "contact_program/sequence.h"
#include "contact_program/written_case.h"

namespace tricontact::app {

namespace {

using Json = nlohmann::ordered_json;

struct BoundaryElementOptions : CommandOptions {
    std::string model;  ///< bem or bem-layer; empty: the only one of these of the case
};

/// A case and which of its boundary element models is meant.
struct BoundaryElementCase {
    Case c;
    std::string model;

    bem::Body body() const {
        return contact::model_kind(model).is_layer() ? bem::Body::layer : bem::Body::half_space;
    }
};

std::string only_model_of(const Case& c) {
    std::string found;
    for (const auto& model : c.models) {
        if (!contact::model_kind(model).is_on_cells()) continue;
        if (!found.empty())
            throw contact::InputError(
                "the case names both bem and bem-layer; choose one by --modelss");
        found = model;
    }
    if (found.empty())
        throw contact::InputError(
            "models: no boundary elements, which this needs, are among them; choose bem or "
            "bem-layer by --models");
    return found;
}

BoundaryElementCase read_boundary_elements(const BoundaryElementOptions& options) {
    std::vector<std::string> models;
    if (!options.model.empty()) models = {options.model};
    const Case c = io::read_case(options.file, options.overrides, models);
    return {c, models.empty() ? only_model_of(c) : options.model};
}

/// Writes the influence coefficients (docs/reference/influence-format.md).
void write_influence(const BoundaryElementOptions& options) {
    const auto read = read_boundary_elements(options);
    io::check_output_file(options.output, bem::influence_file_title);
    const auto table = bem::case_influence(read.c, options.threads, read.body());
    io::write_file(options.output, bem::influence_text(table));
    options.answer(
        Answer(
            [&] {
                return Json{{"version", files::version},  {"model", read.model},
                            {"spacing_m", table.spacing}, {"n_x", table.n_x},
                            {"n_y", table.n_y},           {"file", options.output}}
                    .dump(2);
            },
            fmt::format("model                {}\n"
                        "spacing              {:.6g} mm\n"
                        "positions            {} x {}\n"
                        "written              {}\n",
                        read.model, 1e3 * table.spacing, table.n_x, table.n_y, options.output))
            .note(comparisons::left_out_lines(read.c, {read.model})));
}

/// The numerical coefficients for CONTACT; empty for its own half-spaces.
std::optional<std::string> influence_of(const BoundaryElementCase& read,
                                        const contact::Compliance& compliance, int threads) {
    if (read.body() != bem::Body::layer && !read.c.of<bem::Settings>().influence) return {};
    return bem::contact_program_influence(bem::case_influence(read.c, threads, read.body()),
                                          contact_program::shear_moduli(read.c).combined(),
                                          compliance.is_coupled());
}

/// Writes the steps of a case as input of the program CONTACT (docs/how-to/contact-program.md).
void export_to_contact_program(BoundaryElementOptions options) {
    const auto read = read_boundary_elements(options);
    const Case& c = read.c;
    c.refuse_extras("inputs of CONTACT", {Case::Extra::elastic_interface});
    const std::string name = std::filesystem::path(options.file).stem().string();
    const std::string influence_name = name + ".influence";
    options.choose_folder("_contact");
    std::optional<std::string> influence;
    std::string input;
    std::size_t n_cases = 0;
    int n_x = 0, n_y = 0;
    const auto compute = [&] {
        contact_program::sequence_of(
            c, false);  // what cannot be said at all, before anything is computed
        const auto compliance = bem::case_compliance(c, options.threads, read.body());
        const contact::ContactPoints& grid = compliance->points();
        const bool coupled = compliance->is_coupled();
        influence = influence_of(read, *compliance, options.threads);
        input = contact_program::with_written_case(
            contact_program::sequence_text(
                c, grid, coupled, influence ? std::optional(influence_name) : std::nullopt),
            io::write_case(c));
        n_cases = contact_program::sequence_of(c, coupled).size();
        n_x = grid.n_x;
        n_y = grid.n_y;
    };
    options.fill({{influence_name, name + ".inp"}}, [&] {
        options.told_of_file(compute);
        if (influence) options.write(influence_name, *influence);
        options.write(name + ".inp", input);
    });
    std::vector<std::string> written{name + ".inp"};
    if (influence) written.push_back(influence_name);
    Answer answer(
        [&] {
            return Json{{"version", files::version},
                        {"model", read.model},
                        {"cases", n_cases},
                        {"n_x", n_x},
                        {"n_y", n_y},
                        {"folder", options.output},
                        {"files", written}}
                .dump(2);
        },
        fmt::format("model                {}\n"
                    "cases of CONTACT     {}\n"
                    "cells                {} x {}\n"
                    "written              {}/{}\n",
                    read.model, n_cases, n_x, n_y, options.output, fmt::join(written, ", ")));
    answer.note(comparisons::left_out_lines(c, {read.model}));
    for (const std::string& sentence : comparisons::input_sentences(c))
        answer.note(sentence + '\n');
    options.answer(answer);
}

}  // namespace

Command influence_command() {
    return Declared<BoundaryElementOptions>(Group::exchange, "influence",
                                            "Write the influence coefficients of a case to a file",
                                            write_influence)
        .on_case()
        .required("-o,--output", &CommandOptions::output, "The file", "FILE")
        .word("-m,--models", &BoundaryElementOptions::model, "Its model, one (that of the case)",
              {contact::models::bem, contact::models::bem_layer})
        .threads()
        .json();
}

Command contact_command() {
    const auto none = [](const CommandOptions&) {
        throw contact::InputError(
            "contact: neither export nor import is given; give export with a case, or import with "
            "a file of "
            "CONTACT (tricontact contact --help)");
    };
    return Declared<CommandOptions>(
        Group::exchange, "contact",
        "Cases as input of the program CONTACT, and back: export, import", none);
}

Command contact_export_command() {
    return Declared<BoundaryElementOptions>(Group::exchange, "contact export",
                                            "Write a case as input of the program CONTACT",
                                            export_to_contact_program)
        .on_case()
        .output("Folder (results/<case>_contact)")
        .word("-m,--models", &BoundaryElementOptions::model, "Its model, one (that of the case)",
              {contact::models::bem, contact::models::bem_layer})
        .threads()
        .json();
}

}  // namespace tricontact::app
