#pragma once

#include <string>

namespace CLI {
class App;
}

namespace tricontact::app {

/// What is wrong with the first argument where it is no command of the program; empty if it is one,
/// or an option.
std::string unknown_command(const CLI::App& app, int argc, const char* const* argv);

}  // namespace tricontact::app
