#include <dlfcn.h>
#include <link.h>

#include <array>
#include <filesystem>
#include <stdexcept>

#include "app/commands/command.h"
#include "app/fem_entries.h"

namespace tricontact::app {

namespace {

namespace fs = std::filesystem;

/// Folder of what this code is a part of: the program, or the module of Python.
fs::path own_folder() {
    Dl_info info{};
    link_map* map = nullptr;
    const bool found = ::dladdr1(reinterpret_cast<void*>(&own_folder), &info,
                                 reinterpret_cast<void**>(&map), RTLD_DL_LINKMAP) != 0;
    const bool is_program = !found || !map || map->l_name[0] == '\0';
    return (is_program ? fs::read_symlink("/proc/self/exe") : fs::canonical(map->l_name))
        .parent_path();
}

/// Beside us in a build; installed, below the folder of libraries.
fs::path find_module() {
    const fs::path own = own_folder();
    for (const char* folder : std::array{".", FEM_MODULE_FOLDERS}) {
        const fs::path path = (own / folder / FEM_MODULE).lexically_normal();
        if (fs::exists(path)) return path;
    }
    throw std::runtime_error("finite elements: there is no " FEM_MODULE
                             " where it was installed, seen from " +
                             own.string() + "; install Tricontact as a whole");
}

FemEntriesFunction* find_entries() {
    // Globally: MPI's own plug-ins look for its symbols there.
    void* const module = dlopen(find_module().c_str(), RTLD_LAZY | RTLD_GLOBAL);
    if (!module) throw std::runtime_error(std::string("finite elements: ") + dlerror());
    void* const symbol = dlsym(module, fem_entries_symbol);
    if (!symbol) throw std::runtime_error(std::string("finite elements: ") + dlerror());
    return reinterpret_cast<FemEntriesFunction*>(symbol);
}

}  // namespace

const FemEntries& fem_entries() {
    static FemEntriesFunction* const entries = find_entries();
    return *entries();
}

Command mesh_command() {
    return Declared<CommandOptions>("mesh", "Write the finite element mesh of a case; its quality",
                                    [](const auto& o) { fem_entries().write_mesh(o); })
        .on_case()
        .output("Folder for the mesh (results/<case>)");
}

Command condense_command() {
    return Declared<CondenseOptions>(
               "condense",
               "Condense the finite element layer of a case for later runs (also by mpirun)",
               [](const auto& o) { fem_entries().condense(o); })
        .on_case()
        .flag("--distributed", &CondenseOptions::distributed,
              "Use MPI, even if mpirun did not start this process");
}

Command cache_command() {
    return Declared<CacheOptions>("cache", "List the condensed layers that are kept",
                                  [](const auto& o) { fem_entries().list_or_clear_cache(o); })
        .option("--folder", &CacheOptions::folder, "Folder, as fem.cache (that of the user)", "DIR")
        .flag("--clear", &CacheOptions::clear, "Remove them");
}

}  // namespace tricontact::app
