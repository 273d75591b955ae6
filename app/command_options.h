#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace tricontact::app {

/// The case file and --set.
void add_case_arguments(CLI::App& command, std::string& file, std::vector<std::string>& overrides);

/// One of some words, which stand in the help as the name of the type, not as CLI11 shows a set.
CLI::Validator one_of(std::vector<std::string> words);

/// --no-report. A flag declared as "!--no-report" would stand as "--no-report{false}" in the help.
void add_no_report(CLI::App& command, bool& report, const std::string& text);

}  // namespace tricontact::app
