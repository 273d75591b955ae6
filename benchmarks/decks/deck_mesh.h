#pragma once

#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace tricontact::benchmarks {

/// A face of an element as decks of Abaqus and CalculiX count it: from 1.
struct ElementFace {
    int element = 0;  ///< from 0
    int face = 0;     ///< S1 is the lower face, S3 (plane) or S2 (spatial) the upper one
};

/// Quadrilaterals with 4 or 8 nodes, hexahedra with 8 or 20, in the order of Abaqus: corners, then
/// the middles of edges; that of VTK is the same. Plane meshes lie in x and y, y upwards; spatial
/// ones have z upwards.
struct DeckMesh {
    using Point = std::array<double, 3>;
    int dimension = 2;
    bool is_quadratic = false;
    std::vector<Point> nodes;                ///< [mm]
    std::vector<std::vector<int>> elements;  ///< nodes from 0
    int n_body_elements = 0;                 ///< those of the elastic body come first
    std::map<std::string, std::vector<int>> node_sets;
    std::map<std::string, std::vector<ElementFace>> surfaces;

    int n_elements() const { return static_cast<int>(elements.size()); }
    /// Corners of a face, in a plane mesh the two ends of an edge, and its middles behind them.
    std::vector<int> face_nodes(const ElementFace& face) const;
};

/// Lines of nodes of a block: x and y, and z where it is spatial.
struct BlockLines {
    std::vector<double> x, y, z;
    bool is_spatial() const { return !z.empty(); }
};

/// Adds the block, each node moved by `place`; middles of edges lie between the unmoved corners.
/// Sets by name and whether a node (unmoved) belongs to it.
struct BlockSet {
    std::string name;
    std::function<bool(const DeckMesh::Point&)> holds;
};
void add_block(DeckMesh& mesh, const BlockLines& lines,
               const std::function<DeckMesh::Point(const DeckMesh::Point&)>& place,
               const std::vector<BlockSet>& sets);

/// Volume of elements [mm^3], of plane ones their area [mm^2], by their corners' and middles' shape
/// functions; throws std::logic_error where a Jacobian is not positive.
double volume_of(const DeckMesh& mesh, int first, int last);

}  // namespace tricontact::benchmarks
