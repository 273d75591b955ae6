#include <fmt/format.h>
#include <gmsh.h>

#include <filesystem>
#include <map>
#include <numeric>

#include "files/partial_file.h"
#include "meshes/gmsh/gmsh_session.h"
#include "meshes/mesh_file.h"
#include "meshes/messages.h"
#include "meshes/msh_file.h"
#include "meshes/msh_model.h"

namespace tricontact::meshes {

namespace {

namespace fs = std::filesystem;
using Tag = std::size_t;

// Elements of one name, with their tags and nodes as gmsh counts them: from 1.
struct Group {
    const char* name = "";
    std::vector<Tag> tags, nodes;
};

// Faces are counted first, then hexahedra. Tags of entities and physical groups: 1, 2, ... in the
// order of the enumeration.
void build_model(const HexMesh& mesh) {
    std::map<std::pair<int, int>, Group> groups;  // by dimension and tag
    Tag element_tag = 0;
    const auto add = [&](int dimension, auto what, const auto& element) {
        Group& group = groups[{dimension, static_cast<int>(what) + 1}];
        group.name = name_of(what);
        group.tags.push_back(++element_tag);
        for (const int node : element) group.nodes.push_back(static_cast<Tag>(node) + 1);
    };
    for (const HexMesh::Face& face : mesh.faces) add(2, face.boundary, face.nodes);
    for (std::size_t e = 0; e < mesh.hexes.size(); ++e) add(3, mesh.regions[e], mesh.hexes[e]);
    for (const auto& [key, group] : groups) {
        const auto [dimension, tag] = key;
        gmsh::model::addDiscreteEntity(dimension, tag);
        gmsh::model::addPhysicalGroup(dimension, {tag}, tag);
        gmsh::model::setPhysicalName(dimension, tag, group.name);
    }

    std::vector<Tag> node_tags(mesh.nodes.size());
    std::iota(node_tags.begin(), node_tags.end(), Tag{1});
    std::vector<double> coordinates;
    for (const auto& node : mesh.nodes)
        coordinates.insert(coordinates.end(), node.begin(), node.end());
    // gmsh asks for an owner of the nodes, and any volume will do.
    const int owner = static_cast<int>(mesh.regions.front()) + 1;
    gmsh::model::mesh::addNodes(3, owner, node_tags, coordinates);
    for (const auto& [key, group] : groups)
        gmsh::model::mesh::addElementsByType(
            key.second, key.first == 3 ? hexahedron : quadrilateral, group.tags, group.nodes);
}

}  // namespace

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
