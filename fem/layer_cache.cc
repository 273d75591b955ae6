#include "fem/layer_cache.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "fem/layer_file.h"

namespace tricontact::fem {

namespace {

namespace fs = std::filesystem;
constexpr const char* partial_mark = ".partial-";

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

std::string because_of_errno(const char* what) {
    return std::string(what) + " (" + std::generic_category().message(errno) + ")";
}

// An open file; closed at the end.
class File {
  public:
    explicit File(int descriptor) : descriptor_(descriptor) {}
    ~File() { close(); }
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    int get() const { return descriptor_; }
    bool close() {
        const int descriptor = descriptor_;
        descriptor_ = -1;
        return descriptor < 0 || ::close(descriptor) == 0;
    }

  private:
    int descriptor_;
};

// A file under a name of its own, in the folder of `target`; removed unless it got there.
class PartialFile {
  public:
    explicit PartialFile(const std::string& target) : target_(target) {
        static std::atomic<unsigned> counter = 0;
        // Names may be taken, by processes of the same number in other containers.
        for (int attempt = 0; attempt < 100 && file_ < 0; ++attempt) {
            path_ = target + partial_mark + std::to_string(::getpid()) + "-" +
                    std::to_string(counter++);
            file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            if (file_ < 0 && errno != EEXIST) break;
        }
        if (file_ < 0) {
            path_.clear();
            throw LayerFileError(because_of_errno("cannot be written"));
        }
    }
    ~PartialFile() {
        if (file_ >= 0) ::close(file_);
        if (!path_.empty()) ::unlink(path_.c_str());
    }
    PartialFile(const PartialFile&) = delete;
    PartialFile& operator=(const PartialFile&) = delete;

    int descriptor() const { return file_; }
    void move_to_target() {
        const int file = file_;
        file_ = -1;
        if (::close(file) != 0 || std::rename(path_.c_str(), target_.c_str()) != 0)
            throw LayerFileError(because_of_errno("cannot be written"));
        path_.clear();
    }

  private:
    std::string target_, path_;
    int file_ = -1;
};

// What killed processes left behind.
void remove_old_partial_files(const std::string& folder) {
    std::error_code ignored;
    const auto old = fs::file_time_type::clock::now() - std::chrono::hours(24);
    for (fs::directory_iterator it(folder, ignored), end; !ignored && it != end;
         it.increment(ignored)) {
        std::error_code error;
        const bool partial = it->path().filename().string().find(partial_mark) != std::string::npos;
        if (partial && it->last_write_time(error) < old && !error) fs::remove(it->path(), error);
    }
}

}  // namespace

LayerCache::LayerCache(const std::string& folder)
    : folder_(folder.empty()     ? user_folder()
              : folder == "none" ? ""
                                 : folder) {}

std::string LayerCache::path_of(const std::string& key) const {
    return (fs::path(folder_) / (key + ".layer")).string();
}

std::optional<CondensedLayer> LayerCache::load(const std::string& key, std::string* why) const {
    if (why) why->clear();
    if (keeps_nothing()) return std::nullopt;
    const std::string path = path_of(key);
    const File file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (file.get() < 0) {
        if (errno != ENOENT) tell(why, path, because_of_errno("cannot be read"));
        return std::nullopt;
    }
    try {
        return read_layer(file.get(), key);
    } catch (const LayerFileError& error) {
        tell(why, path, error.what());
        return std::nullopt;
    }
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
    remove_old_partial_files(folder_);
    const std::string path = path_of(key);
    try {
        PartialFile file(path);
        write_layer(file.descriptor(), key, layer);
        file.move_to_target();
        return true;
    } catch (const LayerFileError& failure) {
        tell(why, path, failure.what());
        return false;
    }
}

}  // namespace tricontact::fem
