#include "fem/layer_folder.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>

#include "contact/error.h"
#include "fem/layer_file.h"

namespace tricontact::fem {

namespace {

namespace fs = std::filesystem;

constexpr const char* limit_variable = "TRICONTACT_CACHE_LIMIT";
constexpr std::uint64_t default_limit = 10'000'000'000;

constexpr std::array<std::pair<std::string_view, double>, 5> units{
    {{"TB", 1e12}, {"GB", 1e9}, {"MB", 1e6}, {"kB", 1e3}, {"B", 1}}};

bool is_layer_name(std::string_view name) {
    if (!name.ends_with(layer_file_ending)) return false;
    name.remove_suffix(std::string_view(layer_file_ending).size());
    return name.size() == layer_key_length &&
           name.find_first_not_of("0123456789abcdef") == name.npos;
}

// NaN if the text is no size.
double size_of(std::string_view text) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc()) return none;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    for (const auto& [unit, factor] : units)
        if (text == unit) return value * factor;
    return none;
}

}  // namespace

std::vector<KeptLayer> kept_layers(const std::string& folder) {
    std::vector<KeptLayer> layers;
    std::error_code error;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
        struct stat status {};
        const std::string path = it->path().string();
        if (!is_layer_name(it->path().filename().string()) || ::lstat(path.c_str(), &status) != 0 ||
            !S_ISREG(status.st_mode))
            continue;
        layers.push_back({path, static_cast<std::uint64_t>(status.st_size), status.st_mtim});
    }
    std::sort(layers.begin(), layers.end(), [](const KeptLayer& a, const KeptLayer& b) {
        return std::tie(a.used.tv_sec, a.used.tv_nsec, a.path) <
               std::tie(b.used.tv_sec, b.used.tv_nsec, b.path);
    });
    return layers;
}

std::uint64_t bytes_of(const std::vector<KeptLayer>& layers) {
    std::uint64_t sum = 0;
    for (const KeptLayer& layer : layers) sum += layer.bytes;
    return sum;
}

std::uint64_t cache_limit() {
    const char* const text = std::getenv(limit_variable);
    if (!text || !*text) return default_limit;
    constexpr double most = 1e18;
    const double size = size_of(text);
    if (!(size >= 0 && size <= most))
        throw contact::InputError(
            fmt::format("{} = {}: must be a size; write for example \"500 MB\" or \"20 GB\"",
                        limit_variable, text));
    return static_cast<std::uint64_t>(size);
}

void remove_oldest_layers(const std::string& folder, std::uint64_t most, const std::string& kept) {
    const std::vector<KeptLayer> layers = kept_layers(folder);
    std::uint64_t sum = bytes_of(layers);
    std::error_code ignored;
    for (const KeptLayer& layer : layers) {
        if (sum <= most) return;
        if (layer.path == kept) continue;
        fs::remove(layer.path, ignored);
        sum -= layer.bytes;
    }
}

std::string size_text(std::uint64_t bytes) {
    const auto value = static_cast<double>(bytes);
    for (const auto& [unit, factor] : units)
        if (value >= factor) return fmt::format("{:.3g} {}", value / factor, unit);
    return "0 B";
}

}  // namespace tricontact::fem
