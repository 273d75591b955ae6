#include <cmath>

#include "app/commands/command.h"

namespace tricontact::app {

CLI::Validator in_range(double low, double high) {
    const CLI::Range range(low, high);
    return {[range](std::string& text) {
                double value = 0;
                if (CLI::detail::lexical_cast(text, value) && std::isnan(value))
                    return "Value " + text + " is no number";
                return range(text);
            },
            range.get_description()};
}

std::vector<Command> all_commands() {
    std::vector<Command> commands{run_command(), check_command()};
#ifdef TRICONTACT_WITH_FEM
    commands.insert(commands.end(), {mesh_command(), condense_command(), cache_command()});
#endif
    commands.insert(
        commands.end(),
        {refine_command(),    influence_command(), export_command(),    import_command(),
         limit_command(),     verify_command(),    walk_command(),      roll_command(),
         sweep_command(),     atlas_command(),     predict_command(),   experiment_command(),
         deviation_command(), fit_command(),       merge_command(),     identify_command(),
         rig_command(),       design_command(),    reproduce_command(), keys_command(),
         list_command(),      manual_command()});
    return commands;
}

}  // namespace tricontact::app
