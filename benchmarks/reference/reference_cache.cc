#include "benchmarks/reference/reference_cache.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <system_error>
#include <tuple>
#include <vector>

#include "files/cache_folder.h"
#include "files/digest.h"
#include "files/partial_file.h"
#include "files/regular_file.h"
#include "io/case/case_reader.h"

namespace tricontact::benchmarks {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view file_ending = ".reference";
constexpr std::uint64_t most_bytes_kept = 200'000'000, largest_file = 100'000'000;

std::string key_of(const contact::Case& c, std::string_view identity) {
    files::Digest digest;
    digest << reference_sources_digest() << identity << io::write_case(c);
    return digest.text();
}

/// Those of the folder that were not used for longest go until the others have room.
void make_room(const std::string& folder, const fs::path& kept) {
    std::vector<std::tuple<fs::file_time_type, fs::path, std::uint64_t>> files;
    std::uint64_t sum = 0;
    std::error_code error;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
        std::error_code ignored;
        if (it->path().extension() != file_ending || !it->is_regular_file(ignored)) continue;
        files.emplace_back(it->last_write_time(ignored), it->path(), it->file_size(ignored));
        sum += std::get<2>(files.back());
    }
    std::ranges::sort(files);
    for (const auto& [time, path, bytes] : files) {
        if (sum <= most_bytes_kept) return;
        if (path == kept) continue;
        fs::remove(path, error);
        sum -= bytes;
    }
}

std::optional<Reference> load(const fs::path& path, const contact::Case& c,
                              const contact::Say& say) {
    try {
        files::RegularFile file(path.string());
        auto found = read_reference(file.content(largest_file), c);
        if (!found) say("reference: " + path.string() + " is damaged and computed anew");
        std::error_code ignored;  // used now; in a folder of others it may not say so
        if (found) fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
        return found;
    } catch (const files::Unreadable& why) {
        if (why.error() != ENOENT)
            say("reference: " + path.string() + " " + why.what() + "; computed anew");
        return {};
    }
}

void store(const fs::path& path, const Reference& reference, const contact::Say& say) {
    try {
        fs::create_directories(path.parent_path());
        files::PartialFile file(path.string());
        file.write(written_reference(reference));
        file.move_to_target();
    } catch (const std::system_error& failure) {
        say("reference: not kept: " + path.string() + ": " + failure.code().message());
        return;
    }
    make_room(path.parent_path().string(), path);
}

}  // namespace

Reference kept_reference_in(const std::string& folder, const contact::Case& c,
                            const contact::ModelRunner& runner, std::string_view identity,
                            const contact::Say& say) {
    if (folder.empty()) return reference(c, runner, say);
    const fs::path path = fs::path(folder) / (key_of(c, identity) + std::string(file_ending));
    if (auto kept = load(path, c, say)) return *kept;
    Reference made = reference(c, runner, say);
    store(path, made, say);
    return made;
}

Reference kept_reference(const contact::Case& c, const contact::ModelRunner& runner,
                         std::string_view identity, const contact::Say& say) {
    return kept_reference_in(files::cache_folder(), c, runner, identity, say);
}

}  // namespace tricontact::benchmarks
