#pragma once

#include <map>
#include <string>
#include <vector>

#include "io/keys/input_file.h"
#include "io/results/zip_file.h"

namespace tricontact::papers {

/// A command as a shell has it. Of files the archive holds, "{archive}" stands for its folder.
struct Call {
    std::string command;
    std::vector<std::string> arguments;
};
inline constexpr const char* archive_place = "{archive}";

/// All that a command needs to run again, and the numbers that it came to.
struct Archive {
    std::string version, numerics;                 ///< of the program: number, digest of sources
    std::map<std::string, std::string> libraries;  ///< that it was built with: versions
    std::vector<Call> calls;                       ///< in their order, in one folder
    io::ZipFiles files;  ///< inputs/, results/, and the data of figures/ and tables/

    /// Files whose numbers are compared.
    std::map<std::string, std::string> numbers() const;
};

/// With the versions of this program.
Archive new_archive();

/// A zip archive; same archive, same bytes.
std::string archive_text(const Archive& archive);
/// Throws contact::InputError, naming file, rule and remedy, if it is no such archive or one of its
/// files is missing, is not as it was written, or stands in no list.
Archive read_archive(const std::string& path);

}  // namespace tricontact::papers
