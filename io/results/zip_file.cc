#include "io/results/zip_file.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <zip.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "contact/base/error.h"
#include "files/regular_file.h"
#include "io/keys/input_file.h"
#include "io/keys/messages.h"

namespace tricontact::io {

namespace {

constexpr std::size_t most_mb = 500, most_files = 10'000;
constexpr std::uint64_t most_bytes = most_mb * 1'000'000;
constexpr const char* new_one = "take the archive as --export wrote it";

struct Discard {
    void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct Close {
    void operator()(zip_file_t* file) const { zip_fclose(file); }
};
using Archive = std::unique_ptr<zip_t, Discard>;

struct ZipError {
    zip_error_t error{};

    ZipError() { zip_error_init(&error); }
    ZipError(const ZipError&) = delete;
    ZipError& operator=(const ZipError&) = delete;
    ~ZipError() { zip_error_fini(&error); }
};

void add_entry(zip_t* archive, const std::string& name, const std::string& content) {
    constexpr zip_uint16_t first_date = (1 << 5) | 1;  // 1980-01-01
    constexpr zip_uint32_t attributes = static_cast<zip_uint32_t>(S_IFREG | 0644) << 16;
    zip_source_t* source = zip_source_buffer(archive, content.data(), content.size(), 0);
    const zip_int64_t index =
        source ? zip_file_add(archive, name.c_str(), source, ZIP_FL_ENC_UTF_8) : -1;
    if (index < 0) {
        zip_source_free(source);
        throw std::runtime_error("zip archive: " + std::string(zip_strerror(archive)));
    }
    const auto at = static_cast<zip_uint64_t>(index);
    zip_set_file_compression(archive, at, ZIP_CM_DEFLATE, 9);
    zip_file_set_dostime(archive, at, 0, first_date, 0);
    zip_file_set_external_attributes(archive, at, 0, ZIP_OPSYS_UNIX, attributes);
}

std::string content_of(zip_source_t* source) {
    zip_stat_t status;
    if (zip_source_open(source) != 0 || zip_source_stat(source, &status) != 0)
        throw std::runtime_error("zip archive: cannot be made");
    std::string bytes(status.size, '\0');
    const zip_int64_t n = zip_source_read(source, bytes.data(), bytes.size());
    zip_source_close(source);
    if (n != static_cast<zip_int64_t>(bytes.size()))
        throw std::runtime_error("zip archive: cannot be made");
    return bytes;
}

/// Reads what somebody says to be an archive.
class ZipReader {
  public:
    explicit ZipReader(const std::string& path)
        : path_(path), bytes_(read_input_file(path, "archive", most_mb)) {
        ZipError error;
        zip_source_t* source =
            zip_source_buffer_create(bytes_.data(), bytes_.size(), 0, &error.error);
        if (source)
            archive_.reset(zip_open_from_source(source, ZIP_RDONLY | ZIP_CHECKCONS, &error.error));
        if (source && !archive_) zip_source_free(source);
        if (!archive_)
            refuse(fmt::format("is no zip archive, or only a part of one ({})",
                               zip_error_strerror(&error.error)));
    }

    ZipFiles files() {
        const auto n = static_cast<zip_uint64_t>(zip_get_num_entries(archive_.get(), 0));
        if (n > most_files) refuse(fmt::format("holds more than {} files", most_files));
        ZipFiles files;
        for (zip_uint64_t i = 0; i < n; ++i) {
            const std::string name = name_of(i);
            if (name.ends_with('/')) continue;  // a folder
            if (!files.emplace(name, read(i, name)).second) refuse(shown(name) + " stands twice");
        }
        return files;
    }

  private:
    [[noreturn]] void refuse(const std::string& what) const { fail(path_, "", what, new_one); }

    static std::string shown(const std::string& name) { return one_line(shortened(name, 80)); }

    std::string name_of(zip_uint64_t index) const {
        const char* found = zip_get_name(archive_.get(), index, ZIP_FL_ENC_STRICT);
        const std::string name = found ? found : "";
        const std::filesystem::path path(name);
        const bool leads_out =
            name.empty() || path.is_absolute() || name.find('\\') != name.npos ||
            first_non_utf8(name) != name.npos || one_line(name) != name ||
            std::ranges::any_of(path, [](const auto& part) { return part == ".." || part == "."; });
        if (leads_out) refuse("holds " + shown(name) + ", which is no name within an archive");
        return name;
    }

    void check_kind(zip_uint64_t index, const std::string& name) const {
        zip_uint8_t system = 0;
        zip_uint32_t attributes = 0;
        zip_file_get_external_attributes(archive_.get(), index, 0, &system, &attributes);
        const mode_t kind = (attributes >> 16) & S_IFMT;
        if (system == ZIP_OPSYS_UNIX && kind != 0 && kind != S_IFREG)
            refuse("holds " + shown(name) + ", which is a link or no regular file");
        zip_stat_t status;
        zip_stat_init(&status);
        if (zip_stat_index(archive_.get(), index, 0, &status) != 0 ||
            ((status.valid & ZIP_STAT_ENCRYPTION_METHOD) &&
             status.encryption_method != ZIP_EM_NONE))
            refuse("holds " + shown(name) + ", which is encrypted");
    }

    std::string read(zip_uint64_t index, const std::string& name) {
        check_kind(index, name);
        const std::unique_ptr<zip_file_t, Close> file(zip_fopen_index(archive_.get(), index, 0));
        std::string content;
        std::array<char, 65536> buffer{};
        zip_int64_t n = file ? 1 : -1;
        while (n > 0) {
            n = zip_fread(file.get(), buffer.data(), buffer.size());
            if (n > 0) content.append(buffer.data(), static_cast<std::size_t>(n));
            if (n > 0 && (total_ += static_cast<std::uint64_t>(n)) > most_bytes)
                refuse(fmt::format("holds more than {} MB", most_mb));
        }
        if (n < 0) refuse("holds " + shown(name) + ", which is damaged");
        return content;
    }

    std::string path_, bytes_;
    Archive archive_;
    std::uint64_t total_ = 0;
};

}  // namespace

std::string zip_of(const ZipFiles& files) {
    std::uint64_t total = 0;
    for (const auto& [name, content] : files) total += content.size();
    if (total > most_bytes || files.size() > most_files)
        fail("archive", "",
             fmt::format("would hold more than {} files or {} MB", most_files, most_mb),
             "export less");
    ZipError error;
    zip_source_t* source = zip_source_buffer_create(nullptr, 0, 0, &error.error);
    if (!source) throw std::bad_alloc();
    zip_source_keep(source);
    const std::unique_ptr<zip_source_t, void (*)(zip_source_t*)> kept(source, zip_source_free);
    Archive archive(zip_open_from_source(source, ZIP_TRUNCATE, &error.error));
    if (!archive) throw std::runtime_error("zip archive: cannot be made");
    for (const auto& [name, content] : files) add_entry(archive.get(), name, content);
    if (zip_close(archive.get()) != 0)
        throw std::runtime_error("zip archive: " + std::string(zip_strerror(archive.get())));
    archive.release();  // closed
    return content_of(source);
}

ZipFiles read_zip(const std::string& path) {
    return ZipReader(path).files();
}

}  // namespace tricontact::io
