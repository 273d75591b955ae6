#include "io/tables/height_map_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "io/keys/input_file.h"
#include "io/keys/messages.h"

namespace tricontact::io {

namespace {

constexpr std::size_t most_mb = 512;  // 4096 x 4096 numbers as text

std::string extension(const std::string& path) {
    std::string end = std::filesystem::path(path).extension().string();
    std::ranges::transform(end, end.begin(), [](unsigned char c) { return std::tolower(c); });
    return end;
}

}  // namespace

bool says_its_scale(const std::string& path) {
    return extension(path) == ".sdf";
}

contact::HeightMap read_height_map(const std::string& path,
                                   const std::optional<HeightMapScale>& scale) {
    const std::string end = extension(path);
    const bool known = std::ranges::count(std::array{".npy", ".sdf", ".csv", ".txt"}, end) > 0;
    if (!known)
        fail(path, "", "is no height map by its name",
             "name one that ends in .npy, .sdf, .csv or .txt");
    const std::string text = read_input_file(path, "height map", most_mb);
    const std::string name = std::filesystem::path(path).filename().string();
    if (end == ".sdf") return parse_sdf(text, name);
    return end == ".npy" ? parse_npy(text, name, *scale) : parse_height_matrix(text, name, *scale);
}

}  // namespace tricontact::io
