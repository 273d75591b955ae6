#include "app/module_loader.h"

#include <dlfcn.h>
#include <link.h>

#include <array>
#include <filesystem>
#include <stdexcept>

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
fs::path find_module(const std::string& what, const char* file) {
    const fs::path own = own_folder();
    for (const char* folder : std::array{".", MODULE_FOLDERS}) {
        const fs::path path = (own / folder / file).lexically_normal();
        if (fs::exists(path)) return path;
    }
    throw std::runtime_error(what + ": there is no " + file +
                             " where it was installed, seen from " + own.string() +
                             "; install Tricontact as a whole");
}

}  // namespace

void* module_symbol(const std::string& what, const char* file, const char* symbol) {
    // Globally: MPI's own plug-ins look for its symbols there.
    void* const module = dlopen(find_module(what, file).c_str(), RTLD_LAZY | RTLD_GLOBAL);
    if (!module) throw std::runtime_error(what + ": " + dlerror());
    void* const found = dlsym(module, symbol);
    if (!found) throw std::runtime_error(what + ": " + dlerror());
    return found;
}

}  // namespace tricontact::app
