#include "app/commands/option_texts.h"

namespace tricontact::app {

namespace {

/// As roff takes it: a minus is no hyphen, a backslash begins nothing, nor does a dot.
std::string roff(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '-' || c == '\\') out += '\\';
        out += c == '\\' ? 'e' : c;
    }
    return out.starts_with('.') || out.starts_with('\'') ? "\\&" + out : out;
}

std::string entry(const OptionText& option) {
    std::string head = option.is_argument ? "" : "\\fB" + roff(option.name) + "\\fR";
    if (!option.letter.empty()) head = "\\fB" + roff(option.letter) + "\\fR, " + head;
    if (!option.is_flag() && !option.is_argument) head += ' ';
    if (!option.is_flag()) head += "\\fI" + roff(option.type) + "\\fR";
    return ".TP\n" + head + '\n' + roff(option.text) + '\n';
}

}  // namespace

std::string manual_page(const std::vector<CommandText>& commands) {
    std::string out = fmt::format(
        ".TH TRICONTACT 1 \"\" \"tricontact {}\" \"User Commands\"\n"
        ".SH NAME\ntricontact \\- models of frictional contact side by side\n"
        ".SH SYNOPSIS\n.B tricontact\n\\fICOMMAND\\fR [\\fIARGUMENT\\fR|\\fIOPTION\\fR]...\n"
        ".SH DESCRIPTION\n{}\n.PP\n\\fBtricontact \\fICOMMAND\\fB \\-\\-help\\fR prints the same "
        "as the following sections,\n.B tricontact help\nwhat each group of commands is for.\n",
        files::version, roff(program_text));
    std::string group;
    for (const CommandText& command : commands) {
        if (command.group != group) out += ".SH COMMANDS: " + (group = command.group) + '\n';
        out += ".SS " + roff(command.name) + '\n' + roff(command.text) + ".\n";
        for (const OptionText& option : command.options) out += entry(option);
    }
    return out +
           ".SH EXIT STATUS\n.TP\n.B 0\nDone.\n.TP\n.B 1\nSomething did not converge, or failed.\n"
           ".TP\n.B 2\nBad input: the message names place, value, rule and remedy.\n"
           ".TP\n.B 3\nWhat was kept is not reproduced, or a comparison fails.\n"
           ".TP\n.B 4\nA comparison is not resolved.\n";
}

}  // namespace tricontact::app
