#include <dlfcn.h>

#include <filesystem>
#include <stdexcept>

#include "app/fem_entries.h"

namespace tricontact::app {

namespace {

FemEntriesFunction* find_entries() {
    const auto path = std::filesystem::read_symlink("/proc/self/exe").parent_path() / FEM_MODULE;
    // Globally: MPI's own plug-ins look for its symbols there.
    void* const module = dlopen(path.c_str(), RTLD_LAZY | RTLD_GLOBAL);
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

}  // namespace tricontact::app
