#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tricontact::io {

/// Name of the journal in the folder of a model's results.
inline constexpr const char* journal_name = "steps.journal";

/// A file of entries that are only ever appended, each with a checksum over everything before it:
/// of a file whose writer was killed, or whose end is damaged, the whole entries at the beginning
/// are left. One process at a time. All members but the destructor throw std::system_error where
/// the system refuses.
class JournalFile {
  public:
    /// Opens the file, or makes it. A journal with another key, or damaged from its first bytes on,
    /// is begun again; what follows the last whole entry is cut off. Throws std::system_error also
    /// when another process has the file open, contact::InputError as refuse_other_file.
    JournalFile(const std::string& path, std::string_view key);
    ~JournalFile();
    JournalFile(const JournalFile&) = delete;
    JournalFile& operator=(const JournalFile&) = delete;

    /// Refuses a path at which something other than a journal stands (contact::InputError).
    static void refuse_other_file(const std::string& path);

    std::size_t size() const { return entries_.size(); }  ///< entries
    std::uint64_t bytes() const { return end_; }          ///< of the file
    /// Throws std::system_error also when the entry has been damaged since the file was opened.
    std::string read(std::size_t i) const;
    /// Its first n bytes, as found when the file was opened.
    std::string read_front(std::size_t i, std::uint64_t n) const;
    /// Keeps the first n entries.
    void cut(std::size_t n);
    /// After a failure the file is as before, as far as the system lets it be.
    void append(std::string_view entry);
    /// Removes the file; no other member may be called afterwards.
    void remove();

  private:
    struct Entry {
        std::uint64_t start, size;  // of the content [bytes]
        std::string checksum;       // of everything up to the content's end
    };

    void find_entries();
    const std::string& checksum_before(std::size_t i) const;
    void truncate(std::uint64_t size);

    std::string path_;
    int fd_ = -1;
    std::uint64_t end_ = 0;        // of the last whole entry
    std::string header_checksum_;  // what the first entry's goes on from
    std::vector<Entry> entries_;
};

}  // namespace tricontact::io
