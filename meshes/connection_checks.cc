#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "meshes/hex_geometry.h"
#include "meshes/mesh_checks.h"
#include "meshes/messages.h"

namespace tricontact::meshes {

namespace {

std::vector<int> boundary_nodes(const HexMesh& mesh, const FaceTable& table) {
    std::vector<char> is_boundary(mesh.nodes.size(), 0);
    for (std::size_t f = 0; f < table.n_faces(); ++f)
        if (table.sides(f).size() == 1)
            for (const int node : table.sides(f)[0].key) is_boundary[node] = 1;
    std::vector<int> nodes;
    for (std::size_t i = 0; i < is_boundary.size(); ++i)
        if (is_boundary[i] != 0) nodes.push_back(static_cast<int>(i));
    return nodes;
}

double shortest_edge(const HexMesh& mesh) {
    double shortest = std::numeric_limits<double>::infinity();
    for (const auto& hex : mesh.hexes)
        for (const auto& [from, to] : hex_edges)
            shortest = std::min(shortest, distance(mesh.nodes[hex[from]], mesh.nodes[hex[to]]));
    return shortest;
}

using Cell = std::array<std::int64_t, 3>;

struct CellHash {
    std::size_t operator()(const Cell& cell) const {
        std::size_t hash = 0;  // large odd numbers: Teschner et al. (2003)
        for (int d = 0; d < 3; ++d)
            hash ^= static_cast<std::size_t>(cell[d]) *
                    std::array<std::size_t, 3>{73856093, 19349663, 83492791}[d];
        return hash;
    }
};

// Finds an earlier node within `tolerance` of each new one, in cells much larger than that.
class NodeHash {
  public:
    NodeHash(const HexMesh& mesh, double cell, double tolerance)
        : mesh_(mesh), cell_(cell), tolerance_(tolerance) {}

    /// The node at the same place, or -1.
    int add(int node) {
        const Point& p = mesh_.nodes[node];
        const Cell low = cell_of(p, -tolerance_), high = cell_of(p, tolerance_);
        for (std::int64_t i = low[0]; i <= high[0]; ++i)
            for (std::int64_t j = low[1]; j <= high[1]; ++j)
                for (std::int64_t k = low[2]; k <= high[2]; ++k) {
                    const auto [begin, end] = nodes_.equal_range({i, j, k});
                    for (auto at = begin; at != end; ++at)
                        if (distance(mesh_.nodes[at->second], p) <= tolerance_) return at->second;
                }
        nodes_.emplace(cell_of(p, 0), node);
        return -1;
    }

  private:
    Cell cell_of(const Point& p, double shift) const {
        Cell cell{};
        for (int d = 0; d < 3; ++d)
            cell[d] = static_cast<std::int64_t>(std::floor((p[d] + shift) / cell_));
        return cell;
    }

    const HexMesh& mesh_;
    double cell_, tolerance_;
    std::unordered_multimap<Cell, int, CellHash> nodes_;
};

// Union-find with path halving: Tarjan & van Leeuwen (1984).
class Parts {
  public:
    explicit Parts(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
    int root(int i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(int i, int j) { parent_[root(i)] = root(j); }

  private:
    std::vector<int> parent_;
};

}  // namespace

void check_coincident_nodes(const HexMesh& mesh, const FaceTable& table, const std::string& name) {
    const double edge = shortest_edge(mesh);
    // Nodes of an element are at least an edge apart; a thousandth allows for sloppy positions.
    NodeHash hash(mesh, edge / 2, edge / 1000);
    for (const int node : boundary_nodes(mesh, table)) {
        const int other = hash.add(node);
        if (other >= 0)
            fail(name,
                 fmt::format("two nodes lie at {}: the elements there are not connected",
                             place(mesh.nodes[node])),
                 "let neighbouring blocks share points, curves and surfaces (gmsh: Coherence)");
    }
}

void check_connected(const HexMesh& mesh, const FaceTable& table, const std::string& name) {
    Parts parts(mesh.hexes.size());
    for (std::size_t f = 0; f < table.n_faces(); ++f)
        if (table.sides(f).size() == 2) parts.join(table.sides(f)[0].hex, table.sides(f)[1].hex);
    const int first = parts.root(0);
    for (std::size_t e = 0; e < mesh.hexes.size(); ++e)
        if (parts.root(static_cast<int>(e)) != first)
            fail(name,
                 fmt::format("the body is in pieces: {} and {} are not connected",
                             place(centre_of(mesh, mesh.hexes[0])),
                             place(centre_of(mesh, mesh.hexes[e]))),
                 "remove one piece, or join them by shared faces");
}

}  // namespace tricontact::meshes
