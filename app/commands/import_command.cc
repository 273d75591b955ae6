#include <fmt/format.h>

#include <iostream>

#include "app/commands/command.h"
#include "bem/grid_compliance.h"
#include "io/contact_program/case_text.h"
#include "io/keys/file_kind.h"
#include "io/keys/input_file.h"
#include "io/results/atomic_file.h"
#include "io/results/output_target.h"

namespace tricontact::app {

namespace {

constexpr std::size_t largest_input_mb = 100;

/// Writes the case whose steps an input file of CONTACT has.
void import_case(const CommandOptions& options) {
    io::refuse_toml(options.file);
    const io::ImportedCase imported = io::case_of_sequence(
        io::read_input_file(options.file, "input file of CONTACT", largest_input_mb), options.file,
        bem::is_coupled);
    io::check_output_file(options.output, io::imported_case_beginning);
    io::write_file(options.output, imported.text);
    std::cout << fmt::format("steps                {}\n", imported.n_steps);
    if (imported.left_out > 0)
        std::cout << fmt::format("left out             {} normal problems ahead of them\n",
                                 imported.left_out);
    std::cout << fmt::format("written              {}\n", options.output);
}

}  // namespace

Command import_command() {
    return Declared<CommandOptions>("import", "Write the case of an input file of CONTACT",
                                    import_case)
        .on_file("input", "Input file of CONTACT, module 3", "FILE.inp")
        .required("--output", &CommandOptions::output, "The case file", "CASE.toml");
}

}  // namespace tricontact::app
