#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "meshes/hex_mesh.h"
#include "meshes/msh_file.h"

namespace tricontact::meshes {

/// What a gmsh file says, in its own numbers; every count in it was compared with what is there.
struct MshModel {
    struct Node {
        std::size_t tag;
        Point position;  ///< in the file's unit; finite
    };
    /// Elements of one entity and type, one after the other.
    struct Elements {
        std::vector<std::size_t> tags, nodes;
    };
    /// Dimension and number of an entity or of a physical group.
    using Key = std::pair<int, long>;
    /// Dimension, entity, gmsh's number of the type.
    struct ElementKey {
        int dimension, entity, type;
        auto operator<=>(const ElementKey&) const = default;
    };

    std::vector<Node> nodes;  ///< ascending by tag, each once
    std::map<ElementKey, Elements> elements;
    std::map<Key, std::set<long>> groups;  ///< physical ones, of each entity
    std::map<Key, std::string> names;      ///< of physical groups
};

/// gmsh's numbers of types of elements.
inline constexpr int hexahedron = 5, quadrilateral = 3;

/// A type of element of first or second order.
struct MshType {
    int dimension, n_nodes;
    const char* name;  ///< gmsh's, "Triangle 3"
};
/// Null for a number that is none of these.
const MshType* msh_type(int number);

/// Reads all that is in the sections. Throws contact::InputError naming line or byte: a number that
/// is none or out of its range, a count that is not that of what follows, nodes twice or nowhere.
/// Tetrahedra of 10 nodes are divided into hexahedra.
MshModel read_msh_model(const MshFile& file);

/// Nodes and elements of version 2.2, with the groups that elements name; of 4.1, entities too.
void read_old_sections(const MshFile& file, MshModel& model);
void read_new_sections(const MshFile& file, MshModel& model);

/// Hexahedra and named faces of the model; nodes, hexahedra and faces in the order of their tags,
/// nodes without a hexahedron left out. `unit` [m] is the length of 1 in the model, `name` what
/// messages call it. Throws contact::InputError: unknown names, hexahedra without one, entities
/// with two, other elements than straight hexahedra.
HexMesh mesh_of(const MshModel& model, double unit, const std::string& name);

}  // namespace tricontact::meshes
