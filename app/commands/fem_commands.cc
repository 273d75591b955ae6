#include "app/commands/command.h"
#include "app/models/fem_entries.h"

namespace tricontact::app {

Command mesh_command() {
    return Declared<CommandOptions>(Group::exchange, "mesh",
                                    "Write the finite element mesh of a case; its quality",
                                    [](const auto& o) { o.answer(fem_entries().write_mesh(o)); })
        .on_case()
        .output("Folder for the mesh (results/<case>)")
        .json();
}

Command cache_condense_command() {
    return Declared<CondenseOptions>(
               Group::tools, "cache condense",
               "Condense the finite element layer of a case for later runs (also by mpirun)",
               [](const auto& o) { fem_entries().condense(o); })
        .on_case()
        .flag("--distributed", &CondenseOptions::distributed,
              "Use MPI, even if mpirun did not start this process");
}

Command cache_command() {
    return Declared<CacheOptions>(
               Group::tools, "cache", "List or remove the condensed layers that are kept",
               [](const auto& o) { o.answer(fem_entries().list_or_clear_cache(o)); })
        .option("--folder", &CacheOptions::folder, "Folder, as fem.cache (that of the user)", "DIR")
        .flag("--clear", &CacheOptions::clear, "Remove them")
        .json();
}

}  // namespace tricontact::app
