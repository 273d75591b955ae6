#include "contact/base/memory.h"

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>

#include "contact/base/error.h"
#include "contact/base/special_values.h"

namespace tricontact::contact {

namespace {

namespace fs = std::filesystem;
constexpr double unlimited = infinity;

// Number after `name` in a file of lines "name number".
std::optional<double> entry(const fs::path& file, const std::string& name) {
    std::ifstream in(file);
    std::string line;
    while (std::getline(in, line))
        if (line.starts_with(name)) try {
                return std::stod(line.substr(name.size()));
            } catch (const std::logic_error&) {
                return std::nullopt;
            }
    return std::nullopt;
}

double left_in_system() {
    const auto kilobytes = entry("/proc/meminfo", "MemAvailable:");
    return kilobytes ? *kilobytes * 1024 : unlimited;
}

double left_of_limit(int resource, double pages_used) {
    rlimit limit{};
    if (getrlimit(static_cast<__rlimit_resource>(resource), &limit) != 0 ||
        limit.rlim_cur == RLIM_INFINITY)
        return unlimited;
    return static_cast<double>(limit.rlim_cur) -
           pages_used * static_cast<double>(sysconf(_SC_PAGESIZE));
}

double left_in_process() {
    std::ifstream in("/proc/self/statm");  // pages: total resident shared text lib data dirty
    double total = 0, resident = 0, shared = 0, text = 0, library = 0, data = 0;
    in >> total >> resident >> shared >> text >> library >> data;
    return std::min(left_of_limit(RLIMIT_AS, total), left_of_limit(RLIMIT_DATA, data));
}

double left_in_group(const fs::path& folder, const char* limit_file, const char* usage_file) {
    // Pages of files count as usage but give way.
    const auto limit = entry(folder / limit_file, ""), usage = entry(folder / usage_file, "");
    if (!limit || !usage) return unlimited;
    return *limit - *usage + entry(folder / "memory.stat", "inactive_file ").value_or(0);
}

// The group and all that contain it; groups outside of a container are not seen, its root is.
double left_in_groups(const fs::path& root, fs::path group, const char* limit_file,
                      const char* usage_file) {
    double left = left_in_group(root, limit_file, usage_file);
    for (; group.has_relative_path(); group = group.parent_path())
        left = std::min(left, left_in_group(root / group.relative_path(), limit_file, usage_file));
    return left;
}

double left_in_control_groups() {
    double left = unlimited;
    std::ifstream in("/proc/self/cgroup");  // lines number:controllers:path, version 2: 0::path
    std::string line;
    while (std::getline(in, line)) {
        const auto first = line.find(':'), second = line.find(':', first + 1);
        if (second == std::string::npos) continue;
        const std::string controllers = line.substr(first, second + 1 - first);  // ":a,b:"
        const fs::path group = line.substr(second + 1);
        if (controllers == "::")
            left = std::min(
                left, left_in_groups("/sys/fs/cgroup", group, "memory.max", "memory.current"));
        else if (controllers.find("memory") != std::string::npos)
            left = std::min(left, left_in_groups("/sys/fs/cgroup/memory", group,
                                                 "memory.limit_in_bytes", "memory.usage_in_bytes"));
    }
    return left;
}

}  // namespace

double available_bytes() {
    return std::max(0., std::min({left_in_system(), left_in_process(), left_in_control_groups()}));
}

void use_large_pages(void* memory, std::size_t bytes) {
    constexpr std::uintptr_t large_page = std::uintptr_t{1} << 21;
    const auto begin = reinterpret_cast<std::uintptr_t>(memory);
    const std::uintptr_t first = (begin + large_page - 1) / large_page * large_page;
    const std::uintptr_t end = (begin + bytes) / large_page * large_page;
    // A hint: where it is not taken all is as before.
    if (first < end) madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
}

void touch(void* memory, std::size_t bytes, int n_threads) {
#ifdef MADV_POPULATE_WRITE
    constexpr std::ptrdiff_t piece = std::ptrdiff_t{1} << 21;
    const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    const auto begin = reinterpret_cast<std::uintptr_t>(memory);
    const std::uintptr_t first = (begin + page - 1) / page * page;
    const auto whole = static_cast<std::ptrdiff_t>((begin + bytes) / page * page) -
                       static_cast<std::ptrdiff_t>(first);
    if (whole < piece) return;
#pragma omp parallel for num_threads(n_threads) schedule(static)
    for (std::ptrdiff_t at = 0; at < whole; at += piece)
        madvise(reinterpret_cast<void*>(first + at),
                static_cast<std::size_t>(std::min(piece, whole - at)), MADV_POPULATE_WRITE);
#else
    static_cast<void>(memory), static_cast<void>(bytes), static_cast<void>(n_threads);
#endif
}

void require_memory(const std::string& what, double bytes, const std::string& remedy) {
    constexpr double little = 4e6;  // less worth than to ask the system, which takes .2 ms
    if (bytes < little) return;
    const double available = available_bytes();
    if (bytes > available)
        throw InputError(fmt::format("{} needs {:.1f} GB of memory, {:.1f} GB are there; {}", what,
                                     bytes / 1e9, available / 1e9, remedy));
}

}  // namespace tricontact::contact
