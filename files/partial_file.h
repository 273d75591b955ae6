#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace tricontact::files {

/// Writes all of the bytes to where the descriptor stands. Throws std::system_error.
void write_all(int descriptor, std::string_view bytes);
/// One piece after another from the place `at` of a file on; where they end. Throws
/// std::system_error.
std::uint64_t write_all(int descriptor, std::uint64_t at, std::span<const std::string_view> pieces);

/// A file on its way: under a name of its own beside `target`, locked while it is written, moved
/// onto the target when it is whole, removed when it does not get there. What a killed process
/// leaves has no lock any more: the next one that writes the same target removes it, and so does
/// `remove_left_partial_files`. All members but the destructor throw std::system_error.
class PartialFile {
  public:
    /// `ending` of the temporary name, for programs that go by it: ".msh".
    explicit PartialFile(std::string target, const std::string& ending = {});
    ~PartialFile();
    PartialFile(const PartialFile&) = delete;
    PartialFile& operator=(const PartialFile&) = delete;

    int descriptor() const { return descriptor_; }
    const std::string& path() const { return path_; }  ///< until it is moved
    /// Whether nobody else was writing the target when this began.
    bool is_first() const { return is_first_; }
    void write(std::string_view bytes);
    /// Synced to the disk first, unless that is left to `sync_file_system` for many files at once.
    void move_to_target(bool synced = true);

  private:
    std::string target_, path_;
    int descriptor_ = -1;
    bool is_first_ = true;
};

/// Waits until the first process that writes the target has moved or removed its file, or has
/// ended. False where that cannot be waited for: a file system without locks.
bool wait_for_first_writer(const std::string& target);

/// All that was written to the file system of a folder is on the disk. Throws std::system_error.
void sync_file_system(const std::string& folder);

/// Removes from a folder what killed processes left of partial files, and nothing that is being
/// written. Where the file system has no locks, what is older than a day. A folder that does not
/// exist has none; what cannot be removed stays.
void remove_left_partial_files(const std::string& folder) noexcept;

}  // namespace tricontact::files
