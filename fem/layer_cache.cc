#include "fem/layer_cache.h"

#include <sys/stat.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "fem/layer_file.h"
#include "fem/layer_folder.h"
#include "files/partial_file.h"
#include "files/regular_file.h"

namespace tricontact::fem {

namespace {

namespace fs = std::filesystem;

std::string user_folder() {
    const char* cache = std::getenv("XDG_CACHE_HOME");
    // The XDG specification: relative paths are invalid and to be ignored.
    if (cache && *cache == '/') return (fs::path(cache) / "tricontact").string();
    const char* home = std::getenv("HOME");
    if (home && *home) return (fs::path(home) / ".cache" / "tricontact").string();
    return "";
}

void tell(std::string* why, const std::string& path, const std::string& what) {
    if (why) *why = path + " " + what;
}

}  // namespace

LayerCache::LayerCache(const std::string& folder)
    : folder_(folder.empty()     ? user_folder()
              : folder == "none" ? ""
                                 : folder),
      limit_(cache_limit()) {}

std::string LayerCache::path_of(const std::string& key) const {
    return (fs::path(folder_) / (key + layer_file_ending)).string();
}

std::optional<CondensedLayer> LayerCache::load(const std::string& key, std::string* why) const {
    if (why) why->clear();
    if (keeps_nothing()) return std::nullopt;
    const std::string path = path_of(key);
    files::remove_left_partial_files(folder_);
    try {
        const files::RegularFile file(path);
        std::optional<CondensedLayer> layer = read_layer(file.descriptor(), key);
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
        write_layer(file.descriptor(), key, layer);
        file.move_to_target();
    } catch (const std::system_error& failure) {
        tell(why, path, "cannot be written (" + failure.code().message() + ")");
        return false;
    } catch (const LayerFileError& failure) {
        tell(why, path, failure.what());
        return false;
    }
    remove_oldest_layers(folder_, limit_, path);
    return true;
}

}  // namespace tricontact::fem
