#pragma once

#include <string>
#include <vector>

#include "app/commands/command.h"

namespace tricontact::app {

/// What manual pages and completions say of an option or an argument.
struct OptionText {
    std::string letter;                ///< "-o" of "--output"; empty: none
    std::string name;                  ///< "--vary", or of an argument "case"
    std::string type;                  ///< "DIR", "INT"; empty: a flag
    std::string text;                  ///< what it does, one line
    std::vector<std::string> choices;  ///< all that it may be; empty: anything of its type
    bool is_argument = false;
    bool is_file() const {
        return type.ends_with(".toml") || type.ends_with(".inp") || type.ends_with(".zip") ||
               type == "FILE";
    }
    bool is_folder() const { return type == "DIR" || type == "IN" || type == "OUT"; }
    bool is_flag() const { return type.empty(); }
};

/// The same of a command.
struct CommandText {
    std::string name;  ///< of a part of another command two words
    std::string group, text;
    std::vector<OptionText> options;

    bool is_part() const { return name.find(' ') != std::string::npos; }
    std::string whole() const { return name.substr(0, name.find(' ')); }  ///< of a part
    std::string last_word() const { return name.substr(name.rfind(' ') + 1); }
};

/// Of all commands of the program, as they are declared, in the order of the help.
std::vector<CommandText> command_texts();

/// The manual page, for man.
std::string manual_page(const std::vector<CommandText>& commands);
/// Completions of shells. Values of --set are completed to the keys of case files, --models to
/// names.
std::string bash_completion(const std::vector<CommandText>& commands);
std::string zsh_completion(const std::vector<CommandText>& commands);
std::string fish_completion(const std::vector<CommandText>& commands);

}  // namespace tricontact::app
