#include <CLI/CLI.hpp>
#include <array>

#include "app/commands/command.h"

namespace tricontact::app {

namespace {

struct FormerName {
    std::string_view former, now;
};
constexpr std::array<FormerName, 6> former_names{{{"roll", "run"},
                                                  {"walk", "run"},
                                                  {"merge", "sweep merge"},
                                                  {"condense", "cache condense"},
                                                  {"export", "contact export"},
                                                  {"import", "contact import"}}};

/// The help of a command names its parts.
void tell_parts(const std::vector<Command>& commands) {
    for (const Command& whole : commands) {
        std::string text;
        for (const Command& part : commands)
            if (part.name.starts_with(whole.name + ' '))
                text += fmt::format("  {:<28}{}\n", part.name, part.parser->get_description());
        if (!text.empty()) whole.parser->footer("Subcommands:\n" + text);
    }
}

}  // namespace

const char* title_of(Group group) {
    constexpr std::array titles{"Compute", "Trust", "Ask", "Rigs", "Exchange", "Tools"};
    return titles.at(static_cast<std::size_t>(group));
}

std::vector<Command> all_commands() {
    std::vector<Command> commands{run_command(),
                                  sweep_command(),
                                  sweep_merge_command(),
                                  predict_command(),
                                  check_command(),
                                  refine_command(),
                                  verify_command(),
                                  reproduce_command(),
                                  limit_command(),
                                  deviation_command(),
                                  fit_command(),
                                  rig_command(),
                                  design_command(),
                                  identify_command(),
                                  experiment_command(),
                                  contact_command(),
                                  contact_export_command(),
                                  contact_import_command(),
                                  influence_command(),
                                  atlas_command(),
#ifdef TRICONTACT_WITH_FEM
                                  mesh_command(),
                                  cache_command(),
                                  cache_condense_command(),
#endif
                                  list_command(),
                                  keys_command(),
                                  manual_command()};
    std::ranges::stable_sort(commands, {}, &Command::group);
    tell_parts(commands);
    return commands;
}

std::string_view name_now(std::string_view name) {
    const auto found = std::ranges::find(former_names, name, &FormerName::former);
    return found == former_names.end() ? name : found->now;
}

}  // namespace tricontact::app
