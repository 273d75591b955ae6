#include "app/commands/command.h"
#include "experiments/conversion/old_formats.h"
#include "io/keys/input_file.h"

namespace tricontact::app {

namespace {

void convert(const CommandOptions& options) {
    const std::string text = experiments::converted(io::read_input_file(options.file, "old file"),
                                                    options.file, options.output);
    io::check_output_file(options.output, experiments::converted_beginning);
    io::write_file(options.output, text);
    std::cout << fmt::format("written              {}\n", options.output);
}

}  // namespace

Command convert_command() {
    return Declared<CommandOptions>(
               "convert", "Write a case of a rig, experiment or measurement of the old formats",
               convert)
        .on_file("file", "File of an old format (TOML)", "OLD.toml")
        .required("--output", &CommandOptions::output, "The case file", "CASE.toml");
}

}  // namespace tricontact::app
