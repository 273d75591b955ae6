#include "app/models/module_loader.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <thread>

#include "files/program_parts.h"

namespace tricontact::app {

namespace {

/// Address space [bytes] that a limit of the process (ulimit -v) leaves; empty without a limit.
std::optional<double> address_space_left() {
    rlimit limit{};
    double pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return {};
    return static_cast<double>(limit.rlim_cur) -
           pages * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

/// Below this libraries are loaded whose own threads then cannot start, which ends the process.
constexpr double least_space = 5e8;  // [bytes]

std::string too_little_space(double left) {
    return fmt::format(
        "{:.2g} GB of address space are left to load them, raise the limit (ulimit -v)",
        left / 1e9);
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
    if (left && *left < least_space)
        throw std::runtime_error(what + ": " + too_little_space(*left));
    if (left) spare_threads(*left);
    const auto path = files::find_part(file);
    if (!path)
        throw std::runtime_error(what + ": there is no " + file +
                                 " where it was installed, seen from " +
                                 files::own_folder().string() + "; install Tricontact as a whole");
    // Globally: MPI's own plug-ins look for its symbols there.
    void* const module = dlopen(path->c_str(), RTLD_LAZY | RTLD_GLOBAL);
    if (!module)
        throw std::runtime_error(what + ": " + dlerror() +
                                 (left ? "; " + too_little_space(*left) : std::string()));
    void* const found = dlsym(module, symbol);
    if (!found) throw std::runtime_error(what + ": " + dlerror());
    return found;
}

}  // namespace tricontact::app
