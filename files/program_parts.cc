#include "files/program_parts.h"

#include <dlfcn.h>
#include <link.h>

#include <array>

namespace tricontact::files {

namespace fs = std::filesystem;

fs::path own_folder() {
    Dl_info info{};
    link_map* map = nullptr;
    const bool found = ::dladdr1(reinterpret_cast<void*>(&own_folder), &info,
                                 reinterpret_cast<void**>(&map), RTLD_DL_LINKMAP) != 0;
    const bool is_program = !found || !map || map->l_name[0] == '\0';
    return (is_program ? fs::read_symlink("/proc/self/exe") : fs::canonical(map->l_name))
        .parent_path();
}

std::optional<fs::path> find_part(const char* file) {
    const fs::path own = own_folder();
    for (const char* folder : std::array{".", MODULE_FOLDERS}) {
        const fs::path path = (own / folder / file).lexically_normal();
        if (fs::exists(path)) return path;
    }
    return {};
}

}  // namespace tricontact::files
