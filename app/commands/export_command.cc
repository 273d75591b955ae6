#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <optional>

#include "app/boundary_element_model.h"
#include "app/commands/commands.h"
#include "bem/case_compliance.h"
#include "bem/contact_program_influence.h"
#include "contact/error.h"
#include "io/contact_program/sequence.h"
#include "io/contact_program/sequence_text.h"
#include "io/results/atomic_file.h"
#include "io/results/output_folder.h"

namespace tricontact::app {

namespace {

/// The files of an export, and what is told about them.
struct ExportedSequence {
    std::string input;                     ///< of CONTACT
    std::optional<std::string> influence;  ///< its numerical coefficients
    std::size_t n_steps = 0;
    int n_x = 0, n_y = 0;
};

ExportedSequence export_case(const BoundaryElementCase& read, int threads,
                             const std::string& influence_name) {
    const contact::Case& c = read.c;
    const auto body = read.is_layer() ? bem::Body::layer : bem::Body::half_space;
    io::sequence_of(c, false);  // what cannot be said at all, before anything is computed
    const auto compliance = bem::case_compliance(c, threads, body);
    const contact::ContactPoints& grid = compliance->points();
    ExportedSequence out;
    out.n_x = grid.n_x;
    out.n_y = grid.n_y;
    out.n_steps = io::sequence_of(c, compliance->is_coupled()).size();
    std::optional<std::string> name;
    if (read.is_layer() || c.bem.influence) {
        name = influence_name;
        out.influence = bem::contact_program_influence(bem::case_influence(c, threads, body),
                                                       io::shear_moduli(c).combined(),
                                                       compliance->is_coupled());
    }
    out.input = io::sequence_text(c, grid, compliance->is_coupled(), name);
    return out;
}

// The case with the place of the file in what is wrong with it.
ExportedSequence export_case(const BoundaryElementCase& read, const ExportOptions& options,
                             const std::string& influence_name) {
    try {
        return export_case(read, options.threads, influence_name);
    } catch (const contact::InputError& error) {
        throw contact::InputError(options.case_file + ": " + error.what());
    }
}

}  // namespace

void export_command(const ExportOptions& options) {
    const auto read = read_boundary_elements(options.case_file, options.overrides, options.model);
    refuse_rolling_on(read.c, options.case_file);
    const std::string name = std::filesystem::path(options.case_file).stem().string();
    const std::string influence_name = name + ".influence";
    const std::string folder = io::output_folder(options.output, options.case_file, "_contact");
    io::OutputFolder output(folder, {{influence_name, name + ".inp"}});
    ExportedSequence sequence;
    output.fill([&] {
        sequence = export_case(read, options, influence_name);
        if (sequence.influence) io::write_file(folder + "/" + influence_name, *sequence.influence);
        io::write_file(folder + "/" + name + ".inp", sequence.input);
    });
    std::cout << fmt::format(
        "model                {}\n"
        "cases of CONTACT     {}\n"
        "cells                {} x {}\n"
        "written              {}/{}.inp{}\n",
        read.model, sequence.n_steps, sequence.n_x, sequence.n_y, folder, name,
        sequence.influence ? ", " + influence_name : "");
}

}  // namespace tricontact::app
