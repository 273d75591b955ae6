#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/commands/command.h"
#include "app/commands/option_texts.h"
#include "io/case/case_keys.h"
#include "walking/input/walk_keys.h"

namespace tricontact::app {

namespace {

struct ManualOptions {
    std::string kind;
};

void print_manual(const ManualOptions& options) {
    const auto commands = command_texts();
    if (options.kind == "man") std::cout << manual_page(commands);
    if (options.kind == "bash") std::cout << bash_completion(commands);
    if (options.kind == "zsh") std::cout << zsh_completion(commands);
    if (options.kind == "fish") std::cout << fish_completion(commands);
}

std::vector<std::string> split_at(const std::string& text, char mark) {
    std::vector<std::string> parts{""};
    for (const char c : text) {
        if (c == mark)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

/// Keys of all case files, with the sign behind which the value stands.
std::vector<std::string> settable_keys() {
    std::vector<std::string> keys;
    for (const io::KeyList* list : {&io::case_file_keys(), &walking::walk_file_keys()})
        for (const auto path : list->paths()) keys.push_back(std::string(path) + '=');
    std::ranges::sort(keys);
    const auto twice = std::ranges::unique(keys);
    keys.erase(twice.begin(), twice.end());
    return keys;
}

OptionText text_of(const CLI::Option& option) {
    OptionText text{.letter = {},
                    .name = option.get_name(),
                    .type = option.get_items_expected_max() == 0 ? "" : option.get_type_name(),
                    .text = option.get_description(),
                    .choices = {},
                    .is_argument = option.get_positional()};
    if (!option.get_snames().empty()) text.letter = "-" + option.get_snames().front();
    text.type = split_at(text.type, ':').front();  // the rest is the range
    if (text.type.find('|') != std::string::npos) text.choices = split_at(text.type, '|');
    if (text.name == "--set") text.choices = settable_keys();
    if (text.name == "--models")
        for (const auto& model : known_models()) text.choices.emplace_back(model.name);
    return text;
}

}  // namespace

std::vector<CommandText> command_texts() {
    std::vector<CommandText> texts;
    for (const Command& command : all_commands()) {
        const CLI::App& parser = *command.parser;
        CommandText text{command.name, title_of(command.group), parser.get_description(), {}};
        for (const CLI::Option* option : parser.get_options())
            if (option != parser.get_help_ptr()) text.options.push_back(text_of(*option));
        texts.push_back(std::move(text));
    }
    return texts;
}

Command manual_command() {
    return Declared<ManualOptions>(Group::tools, "manual",
                                   "Print the manual page, or a shell's completion", print_manual)
        .required("kind", &ManualOptions::kind, "man, or the name of a shell", "")
        .one_of({"man", "bash", "zsh", "fish"});
}

}  // namespace tricontact::app
