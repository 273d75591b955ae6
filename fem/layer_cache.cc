#include "fem/layer_cache.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <tuple>
#include <type_traits>
#include <utility>

#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "fem/layer_file.h"
#include "files/cache_folder.h"
#include "files/digest.h"

// What a condensed layer depends on, as the name of its file.

// A condensed layer is kept under the digest of all it depends on: mesh, moduli, boundary
// conditions, element, file format and the sources that condense. Nothing has to be invalidated:
// another layer has another name. Files appear by renaming, complete or not at all; who needs a
// layer that another process makes waits for its reservation (docs/explanation/models/fem.md,
// "Condensation").

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
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc()) return contact::undefined;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    for (const auto& [unit, factor] : units)
        if (text == unit) return value * factor;
    return contact::undefined;
}

void tell(std::string* why, const std::string& path, const std::string& what) {
    if (why) *why = path + " " + what;
}

class KeyDigest {
  public:
    template <typename T>
    KeyDigest& operator<<(const T& value) {
        static_assert(std::has_unique_object_representations_v<T> || std::is_same_v<T, double> ||
                          std::is_same_v<T, std::array<double, 3>>,
                      "padding has no meaning");
        digest_.add(&value, sizeof(T));
        return *this;
    }
    // With its length: two lists one after another are not the same as one.
    template <typename T>
    KeyDigest& operator<<(const std::vector<T>& values) {
        *this << static_cast<std::uint64_t>(values.size());
        for (const T& value : values) *this << value;
        return *this;
    }
    KeyDigest& operator<<(std::string_view text) {
        digest_ << text;
        return *this;
    }
    std::string text() const { return digest_.text(); }

  private:
    files::Digest digest_;
};

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

std::string size_text(std::uint64_t bytes) {
    const auto value = static_cast<double>(bytes);
    for (const auto& [unit, factor] : units)
        if (value >= factor) return fmt::format("{:.3g} {}", value / factor, unit);
    return "0 B";
}

namespace {

/// Removes the layers that were not used for longest until the others take `most` bytes at most;
/// the one with the path `kept` stays whatever its size.
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

}  // namespace

LayerCache::LayerCache(const std::string& folder)
    : folder_(folder.empty()     ? files::cache_folder()
              : folder == "none" ? ""
                                 : folder),
      limit_(cache_limit()) {}

std::string LayerCache::path_of(const std::string& key) const {
    return (fs::path(folder_) / (key + layer_file_ending)).string();
}

// A kept layer is never an error: one that is damaged counts as absent, with the reason in a line
// of the run, and one that cannot be written leaves a run that has its layer.
std::optional<CondensedLayer> LayerCache::load(const std::string& key, std::string* why) const {
    if (why) why->clear();
    if (keeps_nothing()) return std::nullopt;
    const std::string path = path_of(key);
    files::remove_left_partial_files(folder_);
    try {
        files::RegularFile file(path);
        std::optional<CondensedLayer> layer = read_layer(file, key);
        ::futimens(file.descriptor(),
                   nullptr);  // used now; in a folder of others it may not say so
        return layer;
    } catch (const files::Unreadable& error) {
        if (error.error() != ENOENT) tell(why, path, error.what());
    } catch (const LayerFileError& error) {
        tell(why, path, error.what());
    }
    return std::nullopt;
}

bool LayerCache::store(const std::string& key, const CondensedLayer& layer,
                       std::string* why) const {
    if (why) why->clear();
    if (keeps_nothing()) return false;
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) {
        tell(why, folder_, "cannot be made (" + error.message() + ")");
        return false;
    }
    const std::string path = path_of(key);
    try {
        files::PartialFile file(path);
        write_layer(file, key, layer);
        file.move_to_target();
    } catch (const std::system_error& failure) {
        tell(why, path, "cannot be written (" + failure.code().message() + ")");
        return false;
    }
    remove_oldest_layers(folder_, limit_, path);
    return true;
}

std::unique_ptr<files::PartialFile> LayerCache::reserve(const std::string& key,
                                                        const std::function<void()>& waits) const {
    if (keeps_nothing()) return nullptr;
    std::error_code ignored;
    fs::create_directories(folder_, ignored);
    const std::string path = path_of(key);
    bool has_waited = false;
    try {
        while (true) {
            auto mark = std::make_unique<files::PartialFile>(path);
            if (mark->is_first()) return mark;
            mark.reset();
            if (!std::exchange(has_waited, true)) waits();
            if (!files::wait_for_first_writer(path)) return nullptr;
        }
    } catch (const std::system_error&) {  // `store` tells why
        return nullptr;
    }
}

// Looked up, reserved, looked up again: between the first look and the reservation another process
// may have finished. Who holds the reservation makes the layer; it is gone with its process, so
// that nobody waits for one that was killed.
LayerCache::Claim LayerCache::claim(const std::string& key,
                                    const std::function<void()>& waits) const {
    Claim claim;
    claim.layer = load(key, &claim.why);
    if (claim.layer) return claim;
    claim.reservation = reserve(key, waits);
    claim.layer = load(key);  // another process may have kept it meanwhile
    return claim;
}

std::string LayerCache::key(const LayerProblem& problem) {
    KeyDigest digest;
    digest << condensing_sources_digest() << layer_file_version << problem.mesh.nodes
           << problem.mesh.hexes << problem.mesh.regions;
    digest << static_cast<std::uint64_t>(problem.mesh.faces.size());
    for (const auto& face : problem.mesh.faces) digest << face.nodes << face.boundary;
    for (const auto& material : problem.materials) digest << material.young << material.poisson;
    digest << static_cast<int>(problem.base) << static_cast<int>(problem.sides)
           << problem.largest_bulk_ratio;
    if (problem.held_by_symmetry) digest << 1;
    if (problem.pressed_evenly) digest << 2;
    return digest.text();
}

}  // namespace tricontact::fem
