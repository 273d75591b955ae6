#include "app/commands/unknown_command.h"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <string_view>
#include <vector>

#include "io/keys/messages.h"

namespace tricontact::app {

std::string unknown_command(const CLI::App& app, int argc, const char* const* argv) {
    if (argc < 2) return "no command is given; tricontact --help lists them";
    const std::string_view word = argv[1];
    const std::string shown = io::one_line(io::shortened(word, 60));
    if (word.starts_with('-') && app.get_option_no_throw(std::string(word))) return {};
    if (word.starts_with('-'))
        return fmt::format(
            "unknown option {} where a command is due; tricontact --help lists both, a "
            "command's options stand behind it",
            shown);
    std::vector<std::string> commands;
    for (const CLI::App* one : app.get_subcommands({})) commands.push_back(one->get_name());
    const std::vector<std::string_view> known(commands.begin(), commands.end());
    for (const std::string_view one : known)
        if (one == word) return {};
    if (word.ends_with(".toml"))
        return fmt::format("{} is no command; write one before the file, as in tricontact check {}",
                           shown, shown);
    constexpr std::size_t tellable = 4;  // letters: of fewer, most words are near
    const std::string_view near = word.size() < tellable ? "" : io::nearest(word, known);
    return near.empty()
               ? fmt::format("unknown command {}; tricontact --help lists them", shown)
               : fmt::format("unknown command {}; did you mean tricontact {}?", shown, near);
}

}  // namespace tricontact::app
