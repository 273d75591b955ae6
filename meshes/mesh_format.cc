#include "meshes/mesh_format.h"

#include <array>
#include <cerrno>
#include <cstdint>
#include <string_view>

#include "meshes/messages.h"

namespace tricontact::meshes {

namespace {

constexpr std::uint64_t most_bytes = 4'000'000'000;  // some 10^7 hexahedra

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
    try {
        return has_all_sections(files::RegularFile(path).content(most_bytes));
    } catch (const files::Unreadable&) {
        return false;
    }
}

void refuse_mesh_file(const std::string& path, const files::Unreadable& why) {
    const std::string_view what = why.what();
    if (why.error() == 0)
        fail(path, what,
             what == "is a directory" ? "name a mesh file inside it" : "name a mesh file");
    fail(path, std::string("the mesh file ") + why.what(),
         why.error() == ENOENT   ? "check the path"
         : why.error() == EACCES ? "give yourself the permission to read it"
                                 : "name a readable gmsh mesh file");
}

void check_mesh_file(files::RegularFile& file, const std::string& path) {
    std::string bytes;
    try {
        bytes = file.content(most_bytes);
    } catch (const files::Unreadable& why) {
        refuse_mesh_file(path, why);
    }
    check_bytes(path, bytes);
}

}  // namespace tricontact::meshes
