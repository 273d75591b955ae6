#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "files/folder_lock.h"

namespace tricontact::io {

/// What a command writes into its folder, as names relative to it; folders end in '/'.
struct OutputNames {
    std::vector<std::string> results;    ///< removed at the start: never those of another call;
                                         ///< of a folder, the files of figures
    std::vector<std::string> kept = {};  ///< what later calls take over or write over
};

/// The folder that a command fills. Nothing is replaced there but what this program wrote itself:
/// names of its files and folders stand in the list `.tricontact` of the folder; a store of results
/// tells by its content whose it is.
class OutputFolder {
  public:
    /// Refuses, and touches nothing, where one of the names is taken by something else: a file or a
    /// folder that is not in the list, an input of this process, a link, a device, a named pipe,
    /// also inside the folders among the names; and a folder that cannot be made or written to.
    OutputFolder(std::string path, OutputNames names);

    /// Looks once more, makes the folder, removes results of earlier calls and does the work.
    /// Refuses a folder that another process, or another object, fills meanwhile.
    /// Where the work refuses its input (contact::InputError) before a folder of its own holds a
    /// file or one of the names to be kept stands, what was made is removed again.
    void fill(const std::function<void()>& work);

    const std::string& path() const { return path_; }

  private:
    void check() const;
    void check_file(const std::string& name) const;
    void check_folder(const std::string& name) const;
    void begin(files::FolderLock& lock);
    void withdraw() const;
    std::string at(const std::string& name) const;

    std::string path_;
    OutputNames names_;
    std::set<std::string> claims_;         // first parts of the names
    std::set<std::string> fresh_;          // those that nothing stood at
    std::vector<std::string> made_;        // folders above and including this one, innermost first
    std::set<std::string> listed_before_;  // of the list at the start
    bool has_begun_ = false;
};

}  // namespace tricontact::io
