#include "meshes/mesh_format.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

#include "meshes/messages.h"

namespace tricontact::meshes {

namespace {

namespace fs = std::filesystem;

constexpr const char* another_version =
    "save it as version 4.1 (gmsh old.msh -save -format msh41 -o new.msh)";

[[noreturn]] void refuse(const std::string& path, int error) {
    fail(path, "the mesh file cannot be read (" + std::generic_category().message(error) + ")",
         error == ENOENT   ? "check the path"
         : error == EACCES ? "give yourself the permission to read it"
                           : "name a readable gmsh mesh file");
}

void check_kind(const std::string& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (error) refuse(path, error.value());
    if (fs::is_directory(status)) fail(path, "is a directory", "name a mesh file inside it");
    if (!fs::is_regular_file(status)) fail(path, "is not a regular file", "name a mesh file");
    if (::access(path.c_str(), R_OK) != 0) refuse(path, errno);
    if (fs::path(path).extension() != ".msh")
        fail(path, "does not end in .msh", "name a gmsh mesh file (.msh, version 4.1 or 2.2)");
    if (fs::file_size(path, error) == 0) fail(path, "is empty", "save the mesh again");
}

void check_version(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string marker(std::string_view("$MeshFormat").size(), '\0'), version;
    file.read(marker.data(), static_cast<std::streamsize>(marker.size()));
    if (!file || marker != "$MeshFormat")
        fail(path, "is no gmsh mesh: it does not begin with $MeshFormat",
             "name a gmsh mesh file (.msh, version 4.1 or 2.2)");
    version.resize(16);
    file >> std::ws;
    file.get(version.data(), static_cast<std::streamsize>(version.size()), ' ');
    version.resize(static_cast<std::size_t>(file.gcount()));
    if (version != "2.2" && version != "4.1")
        fail(path, "is a gmsh mesh of version " + in_quotes(version), another_version);
}

// Looks for the markers one after the other, piece by piece: meshes may be large.
class MarkerSearch {
  public:
    bool done() const { return next_ == markers_.size(); }
    void take(std::string_view piece) {
        window_.append(piece);
        while (!done()) {
            const std::size_t at = window_.find(markers_[next_]);
            if (at == std::string::npos) break;
            window_.erase(0, at + markers_[next_++].size());
        }
        // A marker may be cut by the end of this piece.
        constexpr std::size_t longest = 16;
        if (window_.size() > longest) window_.erase(0, window_.size() - longest);
    }

  private:
    static constexpr std::array<std::string_view, 4> markers_{"$Nodes", "$EndNodes", "$Elements",
                                                              "$EndElements"};
    std::size_t next_ = 0;
    std::string window_;
};

}  // namespace

bool is_complete_mesh(const std::string& path) {
    std::ifstream file;
    file.exceptions(std::ios::badbit);
    file.open(path, std::ios::binary);
    MarkerSearch search;
    std::string piece(1 << 20, '\0');
    while (file && !search.done()) {
        file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
        search.take({piece.data(), static_cast<std::size_t>(file.gcount())});
    }
    return search.done();
}

void check_mesh_file(const std::string& path) {
    check_kind(path);
    check_version(path);
    if (!is_complete_mesh(path))
        fail(path, "is cut off: its nodes or elements have no end",
             "save or copy the mesh again, with the volume meshed");
}

}  // namespace tricontact::meshes
