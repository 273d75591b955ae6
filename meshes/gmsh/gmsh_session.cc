#include "meshes/gmsh/gmsh_session.h"

#include <gmsh.h>

#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <vector>

namespace tricontact::meshes {

namespace {

namespace fs = std::filesystem;

std::mutex& library_mutex() {
    static std::mutex mutex;
    return mutex;
}

std::string current_locale() {
    const char* name = std::setlocale(LC_ALL, nullptr);
    return name != nullptr ? name : "C";
}

// gmsh asks its window library FLTK 1.3 for an option as it starts, upon which FLTK writes empty
// preferences below the user's home and /etc. What was not there before is removed again.
class ToolkitPreferences {
  public:
    ToolkitPreferences() {
        const char* home = std::getenv("HOME");
        if (home != nullptr && *home != '\0') note_missing(fs::path(home) / ".fltk");
        note_missing("/etc/fltk");
    }
    ~ToolkitPreferences() {
        std::error_code ignored;  // a folder that others filled meanwhile stays
        for (const fs::path& path : missing_) fs::remove(path, ignored);
    }
    ToolkitPreferences(const ToolkitPreferences&) = delete;
    ToolkitPreferences& operator=(const ToolkitPreferences&) = delete;

  private:
    void note_missing(const fs::path& root) {
        const fs::path folder = root / "fltk.org";
        std::error_code ignored;
        for (const fs::path& path : {folder / "fltk.prefs", folder, root})
            if (!fs::exists(fs::symlink_status(path, ignored))) missing_.push_back(path);
    }
    std::vector<fs::path> missing_;
};

void start() {
    const ToolkitPreferences preferences;
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.NumThreads", 1);
    gmsh::model::add("tricontact");
}

}  // namespace

void GmshSession::call(const std::function<void()>& function) {
    // gmsh 4.8 throws strings; older ones threw numbers, exceptions may come from below it.
    try {
        function();
    } catch (const std::string& message) {
        throw std::runtime_error("gmsh: " + message);
    } catch (const int code) {
        throw std::runtime_error("gmsh: error " + std::to_string(code));
    }
}

GmshSession::GmshSession() : lock_(library_mutex()), locale_(current_locale()) {
    call(start);
}

GmshSession::~GmshSession() {
    try {
        gmsh::finalize();
    } catch (...) {  // nothing can be done about it here, and the model is gone anyway
    }
    std::setlocale(LC_ALL, locale_.c_str());
}

}  // namespace tricontact::meshes
