#pragma once

#include <string>
#include <vector>

#include "io/keys/input_file.h"
#include "io/results/zip_file.h"

namespace tricontact::papers {

/// Where inputs of a command stand in an archive: as they stand to each other, below inputs/.
class InputPlaces {
  public:
    /// `folders`: those that the command was given, and read files from.
    explicit InputPlaces(std::vector<io::InputLog::File> files,
                         const std::vector<std::string>& folders = {});

    /// The files, absolute paths in texts of TOML replaced by relative ones. Throws
    /// contact::InputError where a text names something else by an absolute path.
    io::ZipFiles files() const;
    /// An argument of the command, a file in it, or the folder that it is, as its place below
    /// "{archive}".
    std::string argument(const std::string& text) const;
    /// Absolute paths of inputs replaced by their places; of folders what stands in JSON as
    /// "folder".
    std::string in_places(std::string text) const;

  private:
    struct Folder {
        std::string given, path;  // as the command has it; canonical
    };

    std::string place_of(const std::string& path) const;
    const io::InputLog::File* find(const std::string& path) const;
    std::string with_relative_paths(const io::InputLog::File& file) const;

    std::vector<io::InputLog::File> files_;
    std::vector<Folder> folders_;
    std::string root_;  // folder of all, with '/' at its end
};

/// Throws contact::InputError, naming `archive`, where a text of TOML among the inputs leads out of
/// the archive.
void check_inside(const std::string& archive, const io::ZipFiles& files);
/// The same for an argument, also where it is KEY=VALUE with a text, or texts, in the value; and
/// where it names a place for what is computed, but none.
void check_inside(const std::string& archive, const io::ZipFiles& files,
                  const std::string& argument);

}  // namespace tricontact::papers
