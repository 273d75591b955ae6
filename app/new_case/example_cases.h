#pragma once

#include <span>
#include <string>
#include <string_view>

namespace tricontact::app {

/// A file of examples/ that needs no other one, embedded when the program is built.
struct ExampleCase {
    std::string_view name;     ///< without ending
    std::string_view command;  ///< what reads it: "run", "rig", "design"
    std::string_view text;

    std::string title() const;
};

/// Cases, then rigs; each by name.
std::span<const ExampleCase> example_cases();

/// Throws contact::InputError that names the nearest one if there is none of this name.
const ExampleCase& required_example(std::string_view name);

}  // namespace tricontact::app
