#include "meshes/mesh_file.h"

#include <fmt/format.h>
#include <gmsh.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <numeric>

#include "contact/error.h"
#include "files/partial_file.h"
#include "meshes/gmsh_model.h"
#include "meshes/mesh_format.h"
#include "meshes/messages.h"

namespace tricontact::meshes {

namespace {

files::RegularFile open_mesh(const std::string& path) {
    try {
        return files::RegularFile(path);
    } catch (const files::Unreadable& why) {
        refuse_mesh_file(path, why);
    }
}

// The file under a name without a past. By its own name gmsh would take a .geo for a script, and
// run a script `path`.opt beside it; and it might be another file by now.
std::string nameless(const files::RegularFile& file) {
    return "/dev/fd/" + std::to_string(file.descriptor());
}

namespace fs = std::filesystem;
using Tag = std::size_t;

// gmsh asks for an owner of the nodes, and any volume will do.
void add_nodes(const HexMesh& mesh) {
    std::vector<Tag> tags(mesh.nodes.size());
    std::iota(tags.begin(), tags.end(), Tag{1});
    std::vector<double> coordinates;
    for (const auto& node : mesh.nodes)
        coordinates.insert(coordinates.end(), node.begin(), node.end());
    const int owner = physical_tag(mesh.regions.front());
    gmsh::model::mesh::addNodes(3, owner, tags, coordinates);
}

// Elements of one name, with their tags and nodes as gmsh counts them: from 1.
struct Group {
    std::vector<Tag> tags, nodes;
    template <std::size_t n>
    void add(Tag tag, const std::array<int, n>& element) {
        tags.push_back(tag);
        for (const int node : element) nodes.push_back(static_cast<Tag>(node) + 1);
    }
};

// Faces are counted first, then hexahedra.
void build_model(const HexMesh& mesh) {
    std::map<Boundary, Group> boundaries;
    std::map<Region, Group> regions;
    Tag tag = 0;
    for (const HexMesh::Face& face : mesh.faces) boundaries[face.boundary].add(++tag, face.nodes);
    for (std::size_t e = 0; e < mesh.hexes.size(); ++e)
        regions[mesh.regions[e]].add(++tag, mesh.hexes[e]);

    for (const auto& [boundary, group] : boundaries) add_entity(boundary);
    for (const auto& [region, group] : regions) add_entity(region);
    add_nodes(mesh);
    for (const auto& [boundary, group] : boundaries)
        gmsh::model::mesh::addElementsByType(physical_tag(boundary), quadrilateral, group.tags,
                                             group.nodes);
    for (const auto& [region, group] : regions)
        gmsh::model::mesh::addElementsByType(physical_tag(region), hexahedron, group.tags,
                                             group.nodes);
}

}  // namespace

HexMesh read_mesh(const std::string& path, double unit) {
    if (!(unit > 0) || !std::isfinite(unit))
        fail(path, fmt::format("the unit of length is {:g} m", unit), "make it a positive length");
    files::RegularFile file = open_mesh(path);
    check_mesh_file(file, path);
    HexMesh mesh;
    try {
        const GmshSession session;
        GmshSession::call([&] {
            gmsh::merge(nameless(file));
            mesh = collect_model(unit, path);
        });
    } catch (const contact::InputError&) {
        throw;
    } catch (const std::exception& error) {
        fail(path, fmt::format("the mesh is damaged ({})", error.what()), "save it again");
    }
    verify(mesh, path);
    return mesh;
}

void write_mesh(const HexMesh& mesh, const std::string& path) {
    if (fs::path(path).extension() != ".msh")
        fail(path, "the name of a mesh file must end in .msh", "add the ending");
    if (mesh.hexes.empty()) fail(path, "there are no hexahedra to write", "make a mesh first");
    try {
        files::PartialFile partial(path, ".msh");  // gmsh knows the format by the ending
        const GmshSession session;
        GmshSession::call([&] {
            gmsh::option::setNumber("Mesh.MshFileVersion", 4.1);
            build_model(mesh);
            gmsh::write(partial.path());
        });
        // gmsh overlooks a full disk.
        if (is_complete_mesh(partial.path())) {
            partial.move_to_target();
            return;
        }
    } catch (const std::exception& error) {
        fail(path, std::string("the mesh cannot be written (") + error.what() + ')',
             "choose a folder in which you may write");
    }
    fail(path, "the mesh cannot be written to its end",
         "free space on the disk, or choose a folder in which you may write");
}

}  // namespace tricontact::meshes
