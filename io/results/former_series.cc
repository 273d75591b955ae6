#include "io/results/former_series.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

namespace tricontact::io {

namespace {

namespace fs = std::filesystem;

bool is_state_of(const std::string& series, std::string_view file) {
    constexpr std::array<std::string_view, 4> endings{".vti", ".vtp", ".vtr", ".vtu"};
    constexpr std::size_t n_digits = 6, n_ending = 4;
    if (!file.starts_with(series + '_') || file.size() < series.size() + 1 + n_digits + n_ending)
        return false;
    const std::string_view number =
        file.substr(series.size() + 1, file.size() - series.size() - 1 - n_ending);
    return std::ranges::find(endings, file.substr(file.size() - n_ending)) != endings.end() &&
           number.size() >= n_digits &&
           std::ranges::all_of(number, [](unsigned char c) { return std::isdigit(c) != 0; });
}

}  // namespace

void remove_former_series(const std::string& folder, const std::string& name) {
    std::error_code ignored;
    std::vector<fs::path> former;
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
        const std::string file = entry.path().filename().string();
        if (entry.symlink_status(ignored).type() == fs::file_type::regular &&
            (file == name + ".pvd" || is_state_of(name, file)))
            former.push_back(entry.path());
    }
    for (const fs::path& file : former) fs::remove(file, ignored);
}

}  // namespace tricontact::io
