#include "meshes/mesh_format.h"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>

#include "meshes/mesh_numbers.h"
#include "meshes/messages.h"

namespace tricontact::meshes {

namespace {

namespace fs = std::filesystem;

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
}

std::string bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

bool has_all_sections(std::string_view bytes) {
    std::size_t at = 0;
    for (const std::string_view marker : {"$Nodes", "$EndNodes", "$Elements", "$EndElements"}) {
        at = bytes.find(marker, at);
        if (at == std::string_view::npos) return false;
    }
    return true;
}

void check_bytes(const std::string& path, std::string_view bytes) {
    if (bytes.empty()) fail(path, "is empty", "save the mesh again");
    if (!bytes.starts_with("$MeshFormat"))
        fail(path, "is no gmsh mesh: it does not begin with $MeshFormat",
             "name a gmsh mesh file (.msh, version 4.1 or 2.2)");
    const MeshFormat format = mesh_format(bytes);
    if (format.version != "2.2" && format.version != "4.1")
        fail(path, "is a gmsh mesh of version " + in_quotes(format.version),
             "save it as version 4.1 (gmsh old.msh -save -format msh41 -o new.msh)");
    if (!has_all_sections(bytes))
        fail(path, "is cut off: its nodes or elements have no end",
             "save or copy the mesh again, with the volume meshed");
    if (!has_sound_numbers(bytes, format))
        fail(path, "holds a dimension, element type or number that no mesh of hexahedra has",
             "save or copy the mesh again, not partitioned, Mesh.ElementOrder = 1");
}

}  // namespace

bool is_complete_mesh(const std::string& path) {
    return has_all_sections(bytes_of(path));
}

void check_mesh_file(const std::string& path) {
    check_kind(path);
    check_bytes(path, bytes_of(path));
}

}  // namespace tricontact::meshes
