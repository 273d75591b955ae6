#include "app/models/module_loader.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <link.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <thread>

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

/// Address space [bytes] that a limit of the process (ulimit -v) leaves; empty without a limit.
std::optional<double> address_space_left() {
    rlimit limit{};
    double pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return {};
    return static_cast<double>(limit.rlim_cur) -
           pages * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

/// OpenBLAS starts its threads while it is loaded, and where one cannot have its stack it ends the
/// process. Where space is short one thread has to do, for which none is started.
void spare_threads(double left) {
    constexpr double libraries = 1e9, thread = 256e6;  // its stack, heap and buffer
    if (left < libraries + thread * std::max(1u, std::thread::hardware_concurrency()))
        ::setenv("OPENBLAS_NUM_THREADS", "1", 1);
}

}  // namespace

void* module_symbol(const std::string& what, const char* file, const char* symbol) {
    const std::optional<double> left = address_space_left();
    if (left) spare_threads(*left);
    // Globally: MPI's own plug-ins look for its symbols there.
    void* const module = dlopen(find_module(what, file).c_str(), RTLD_LAZY | RTLD_GLOBAL);
    if (!module)
        throw std::runtime_error(
            what + ": " + dlerror() +
            (left ? fmt::format("; {:.2g} GB of address space are left to load them, raise the "
                                "limit (ulimit -v)",
                                *left / 1e9)
                  : ""));
    void* const found = dlsym(module, symbol);
    if (!found) throw std::runtime_error(what + ": " + dlerror());
    return found;
}

}  // namespace tricontact::app
