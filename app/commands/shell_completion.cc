#include <map>

#include "app/commands/option_texts.h"

namespace tricontact::app {

namespace {

/// Between single quotes of a shell.
std::string quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + '\'';
}

std::string names_of(const std::vector<CommandText>& commands) {
    std::string names;
    for (const CommandText& command : commands)
        if (!command.is_part()) names += (names.empty() ? "" : " ") + command.name;
    return names;
}

/// A line of a case for each command with parts: `before`, its name, `middle`, the parts, `after`.
std::string cases_of_parts(const std::vector<CommandText>& commands, const char* before,
                           const char* middle, const char* after) {
    std::map<std::string, std::string> parts;
    for (const CommandText& command : commands)
        if (command.is_part()) parts[command.whole()] += ' ' + command.last_word();
    std::string lines;
    for (const auto& [whole, words] : parts) lines += before + whole + middle + words + after;
    return lines;
}

/// What case takes for the parts: 'sweep merge'|'cache condense'.
std::string pattern_of_parts(const std::vector<CommandText>& commands) {
    std::string pattern;
    for (const CommandText& command : commands)
        if (command.is_part()) pattern += (pattern.empty() ? "" : "|") + quoted(command.name);
    return pattern;
}

std::string joined_choices(const OptionText& option) {
    return fmt::format("{}", fmt::join(option.choices, " "));
}

/// What completes the value of an option in bash, or an argument.
std::string bash_values(const OptionText& option) {
    if (option.name == "--models")  // behind the last comma
        return fmt::format(
            "local before=; [[ $word == *,* ]] && before=${{word%,*}},; "
            "COMPREPLY=($(compgen -P \"$before\" -W {} -- \"${{word##*,}}\")); "
            "compopt -o nospace",
            quoted(joined_choices(option)));
    if (!option.choices.empty())
        return fmt::format("COMPREPLY=($(compgen -W {} -- \"$word\")){}",
                           quoted(joined_choices(option)),
                           option.name == "--set" ? "; compopt -o nospace" : "");
    if (option.is_folder()) return "compopt -o filenames; COMPREPLY=($(compgen -d -- \"$word\"))";
    if (option.is_file()) return "compopt -o filenames; COMPREPLY=($(compgen -f -- \"$word\"))";
    return "COMPREPLY=()";
}

std::string bash_command(const CommandText& command) {
    std::string flags, values, arguments;
    for (const OptionText& option : command.options) {
        if (option.is_argument) {
            arguments = bash_values(option);
            continue;
        }
        flags += option.name + ' ';
        if (!option.letter.empty()) flags += option.letter + ' ';
        if (!option.is_flag())
            values +=
                fmt::format("            {}) {}; return ;;\n",
                            option.letter.empty() ? option.name : option.letter + '|' + option.name,
                            bash_values(option));
    }
    return fmt::format(
        "    {})\n        case $before in\n{}        esac\n"
        "        if [[ $word == -* ]]; then COMPREPLY=($(compgen -W '{}--help' -- \"$word\"))\n"
        "        else {}; fi ;;\n",
        quoted(command.name), values, flags, arguments.empty() ? ":" : arguments);
}

/// Brackets and colons divide the parts of a specification of zsh.
std::string zsh_text(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '[' || c == ']' || c == ':') out += '\\';
        out += c;
    }
    return out;
}

std::string zsh_values(const OptionText& option) {
    if (option.name == "--models") return "_values -s , model " + joined_choices(option);
    if (option.name == "--set") return "compadd -S \"\" -- " + joined_choices(option);
    if (!option.choices.empty()) return '(' + joined_choices(option) + ')';
    if (option.is_folder()) return "_files -/";
    if (option.is_file()) return "_files";
    return "";
}

/// Under one of its names.
std::string zsh_option(const OptionText& option, const std::string& name) {
    const std::string values = zsh_values(option);
    if (option.is_argument) return fmt::format("*:{}:{}", option.name, values);
    const std::string many = option.name == "--set" ? "*" : "";
    const std::string text = fmt::format("{}{}[{}]", many, name, zsh_text(option.text));
    return option.is_flag() ? text : fmt::format("{}:{}:{}", text, zsh_text(option.type), values);
}

std::string fish_values(const OptionText& option) {
    if (option.is_flag()) return "";
    if (!option.choices.empty()) return " -x -a " + quoted(joined_choices(option));
    if (option.is_folder()) return " -x -a '(__fish_complete_directories)'";
    return option.is_file() ? " -r -F" : " -x";
}

}  // namespace

std::string bash_completion(const std::vector<CommandText>& commands) {
    std::string cases;
    for (const CommandText& command : commands) cases += bash_command(command);
    return fmt::format(
        "# Completion of tricontact for bash: tricontact manual bash\n"
        "_tricontact() {{\n"
        "    local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}}\n"
        "    if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
        "        COMPREPLY=($(compgen -W '{} help --help --version' -- \"$word\"))\n"
        "        return\n"
        "    fi\n"
        "    local command=${{COMP_WORDS[1]}}\n"
        "    if [ \"$COMP_CWORD\" -gt 2 ]; then\n"
        "        case \"$command ${{COMP_WORDS[2]}}\" in {}) command+=\" ${{COMP_WORDS[2]}}\" ;; "
        "esac\n"
        "    fi\n"
        "    case $command in\n        help) COMPREPLY=($(compgen -W '{}' -- \"$word\")) ;;\n{}    "
        "esac\n"
        "    [ \"$COMP_CWORD\" -eq 2 ] || return 0\n"
        "    case $command in\n{}    esac\n"
        "}}\n"
        "complete -F _tricontact tricontact\n",
        names_of(commands), pattern_of_parts(commands), names_of(commands), cases,
        cases_of_parts(commands, "        ", ") COMPREPLY+=($(compgen -W '",
                       "' -- \"$word\")) ;;\n"));
}

std::string zsh_completion(const std::vector<CommandText>& commands) {
    std::string descriptions, cases;
    for (const CommandText& command : commands) {
        if (!command.is_part())
            descriptions += "        " + quoted(command.name + ':' + zsh_text(command.text)) + '\n';
        cases += fmt::format("        {})\n            _arguments '--help[Print the help]'",
                             quoted(command.name));
        for (const OptionText& option : command.options)
            for (const std::string& name : {option.letter, option.name})
                if (!name.empty())
                    cases += " \\\n                " + quoted(zsh_option(option, name));
        cases += " ;;\n";
    }
    return fmt::format(
        "#compdef tricontact\n"
        "# Completion of tricontact for zsh: tricontact manual zsh\n"
        "_tricontact() {{\n"
        "    local -a commands=(\n{}    )\n"
        "    if (( CURRENT == 2 )); then\n"
        "        commands+=('help:Groups of commands, or the options of one')\n"
        "        _describe command commands\n"
        "        return\n"
        "    fi\n"
        "    local command=$words[2]\n"
        "    if (( CURRENT == 3 )); then\n"
        "        case $command in\n{}        esac\n"
        "    else\n"
        "        case \"$words[2] $words[3]\" in\n"
        "            {})\n"
        "                command+=\" $words[3]\"\n"
        "                words=(\"${{(@)words[2,-1]}}\")\n"
        "                (( CURRENT-- )) ;;\n"
        "        esac\n"
        "    fi\n"
        "    words=(\"${{(@)words[2,-1]}}\")\n"
        "    (( CURRENT-- ))\n"
        "    case $command in\n{}    esac\n"
        "}}\n"
        "_tricontact \"$@\"\n",
        descriptions, cases_of_parts(commands, "            ", ") compadd --", " ;;\n"),
        pattern_of_parts(commands), cases);
}

std::string fish_completion(const std::vector<CommandText>& commands) {
    std::string out =
        "# Completion of tricontact for fish: tricontact manual fish\n"
        "complete -c tricontact -n __fish_use_subcommand -f\n"
        "complete -c tricontact -n __fish_use_subcommand -a help -d 'Groups of commands'\n";
    for (const CommandText& command : commands) {
        const std::string seen = "'__fish_seen_subcommand_from " + command.whole();
        out += fmt::format("complete -c tricontact -n {} -a {} -d {}\n",
                           command.is_part() ? seen + '\'' : "__fish_use_subcommand",
                           command.last_word(), quoted(command.text));
        const std::string words =
            command.is_part() ? "; and __fish_seen_subcommand_from " + command.last_word() : "";
        for (const OptionText& option : command.options) {
            const std::string when = fmt::format("complete -c tricontact -n {}{}'", seen, words);
            if (!option.is_argument)
                out += fmt::format("{} -l {}{} -d {}{}\n", when, option.name.substr(2),
                                   option.letter.empty() ? "" : " -s " + option.letter.substr(1),
                                   quoted(option.text), fish_values(option));
            else if (!option.choices.empty())
                out += fmt::format("{} -f -a {}\n", when, quoted(joined_choices(option)));
        }
    }
    return out;
}

}  // namespace tricontact::app
