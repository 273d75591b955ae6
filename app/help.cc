#include "app/help.h"

#include <CLI/CLI.hpp>
#include <array>

#include "io/keys/messages.h"

namespace tricontact::app {

namespace {

struct GroupText {
    Group group;
    const char *text, *example;
};
constexpr std::array<GroupText, 6> group_texts{
    {{Group::compute, "what a case comes to: its models, many points, maps", "run case.toml"},
     {Group::trust, "whether input and numbers are right: bars, references", "check case.toml"},
     {Group::ask, "questions to models: limits, half-space or layer", "limit case.toml"},
     {Group::rigs, "measurements: assumptions, material, records", "rig case.toml"},
     {Group::exchange, "files for other programs", "contact export case.toml"},
     {Group::tools, "models, keys, completions, maps", "keys case"}}};

std::string names_in(Group group, const std::vector<Command>& commands) {
    std::string names;
    for (const Command& command : commands)
        if (command.group == group && !command.is_part())
            names += (names.empty() ? "" : ", ") + command.name;
    return names;
}

}  // namespace

std::string overview(const std::vector<Command>& commands) {
    std::string text = std::string(program_text) + '\n';
    for (const GroupText& one : group_texts)
        text += fmt::format("\n{:<10}{}\n{:<10}{}\n{:<10}tricontact {}\n", title_of(one.group),
                            one.text, "", names_in(one.group, commands), "", one.example);
    return text +
           "\ntricontact help COMMAND prints the options of a command, tricontact --help a line "
           "for "
           "each command\n";
}

std::string near_option(const CLI::App& parser, const std::vector<std::string>& arguments) {
    std::vector<std::string> names;
    for (const CLI::Option* option : parser.get_options())
        if (!option->get_positional()) names.push_back(option->get_name());
    const std::vector<std::string_view> known(names.begin(), names.end());
    for (const std::string& argument : arguments) {
        const std::string name = argument.substr(0, argument.find('='));
        if (!name.starts_with("--") || parser.get_option_no_throw(name)) continue;
        const std::string_view near = io::nearest(name, known);
        return near.empty() ? "" : fmt::format("; did you mean {}?", near);
    }
    return "";
}

}  // namespace tricontact::app
