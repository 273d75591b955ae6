#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "io/keys/toml_document.h"

namespace tricontact::io {

/// Text of a regular file of at most `most_mb` megabytes. Throws contact::InputError naming path,
/// reason, remedy; `kind` is what the file should be.
std::string read_input_file(const std::string& path, std::string_view kind = "case file",
                            std::size_t most_mb = 1);

/// Remembers a file that something else reads as an input of this process (read_input_file does so
/// by itself): no output replaces it.
void note_input_file(const std::string& path);

/// Whether the process has read it as an input, by whatever path.
bool is_input_file(const std::string& path);

/// Knows what the process reads as inputs while it lives.
class InputLog {
  public:
    struct File {
        std::string path;             ///< canonical
        std::set<std::string> names;  ///< paths by which it was read, also as absolute ones
        std::string content;
    };

    InputLog();
    ~InputLog();
    InputLog(const InputLog&) = delete;
    InputLog& operator=(const InputLog&) = delete;

    void add(const std::string& given, const std::string& real);
    /// Canonical.
    std::vector<std::string> paths() const;
    /// By their paths. Throws contact::InputError if one has been changed since it was read.
    std::vector<File> files() const;

  private:
    struct Entry {
        std::string state;  // when it was read first
        std::set<std::string> names;
    };
    std::map<std::string, Entry> entries_;  // by canonical paths
};

/// What an input file is about; each is read by commands of its own.
enum class FileKind { contact, walking, study };

/// Whether the file is about the micro-walking machine: it has a section [machine].
bool is_walk_case(const Document& document);

/// What the document shows itself to be by its keys and sections; a contact case where nothing
/// tells.
FileKind kind_of(const Document& document);

/// Throws contact::InputError "this is a study, not a case; tricontact sweep computes it" if the
/// document shows by its keys and sections that it is of another kind than the one expected.
void require_kind(FileKind expected, const Document& document);

/// Throws contact::InputError, naming the command that reads it, if a file is input of the program
/// CONTACT by its name.
void refuse_contact_program_input(const std::string& path);
/// Throws contact::InputError if a file that should be such input is one of TOML by its name.
void refuse_toml(const std::string& path);

}  // namespace tricontact::io
