#include <CLI/CLI.hpp>
#include <array>

#include "app/commands/command.h"

namespace tricontact::app {

// The commands, each defined in a file of its own beside what it does, which throws
// contact::InputError and contact::NotConverged; mesh and cache in fem_commands.cc. Called here
// only: a header of theirs would be a second list of them.
Command new_command();
Command run_command();
Command sweep_command();
Command sweep_merge_command();
Command predict_command();
Command check_command();
Command refine_command();
Command verify_command();
Command reproduce_command();
Command benchmark_command();
Command benchmark_list_command();
Command benchmark_show_command();
Command benchmark_deck_command();
Command benchmark_compare_command();
Command compare_command();
Command limit_command();
Command deviation_command();
Command fit_command();
Command rig_command();
Command design_command();
Command identify_command();
Command experiment_command();
Command contact_command();
Command contact_export_command();
Command contact_import_command();
Command influence_command();
Command mesh_command();
Command atlas_command();
Command cache_command();
Command cache_condense_command();
Command list_command();
Command keys_command();
Command manual_command();

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
    std::vector<Command> commands{new_command(),
                                  run_command(),
                                  sweep_command(),
                                  sweep_merge_command(),
                                  predict_command(),
                                  check_command(),
                                  refine_command(),
                                  verify_command(),
                                  reproduce_command(),
                                  benchmark_command(),
                                  benchmark_list_command(),
                                  benchmark_show_command(),
                                  benchmark_deck_command(),
                                  benchmark_compare_command(),
                                  compare_command(),
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
