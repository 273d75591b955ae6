#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/commands/command.h"

namespace tricontact::app {

/// What `tricontact help` prints, and tricontact alone: each group of commands with one line, its
/// commands and one example.
std::string overview(const std::vector<Command>& commands);

/// "; did you mean --models?" of an option that the command does not have; empty where none of
/// its own is near.
std::string near_option(const CLI::App& parser, const std::vector<std::string>& arguments);

}  // namespace tricontact::app
