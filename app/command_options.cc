#include "app/command_options.h"

#include <utility>

namespace tricontact::app {

void add_case_arguments(CLI::App& command, std::string& file, std::vector<std::string>& overrides) {
    command.add_option("case", file, "Case file (TOML)")->required()->type_name("CASE.toml");
    command
        .add_option("--set", overrides,
                    "Override a key of the case: section.key=value (may be repeated)")
        ->type_name("KEY=VALUE")
        ->take_all()
        ->allow_extra_args(false);
}

CLI::Validator one_of(std::vector<std::string> words) {
    return CLI::IsMember(std::move(words)).description("");
}

void add_no_report(CLI::App& command, bool& report, const std::string& text) {
    command.add_flag_callback(
        "--no-report", [&report] { report = false; }, text);
}

}  // namespace tricontact::app
