#include "meshes/grid_order.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace tricontact::meshes {

namespace {

using Index = std::array<int, 3>;

[[noreturn]] void refuse() {
    throw std::runtime_error("gmsh made another mesh than the tensor grid it was asked for");
}

// Numbers of the grid's nodes, x fastest.
class Numbering {
  public:
    explicit Numbering(const LayerGrid& grid) : axes_(grid.axes) {}

    int n(int d) const { return axes_[d].n_elements() + 1; }
    int stride(int d) const { return d == 0 ? 1 : d == 1 ? n(0) : n(0) * n(1); }
    Index index(int node) const { return {node % n(0), node / n(0) % n(1), node / stride(2)}; }

    std::vector<std::array<double, 3>> nodes() const {
        std::vector<std::array<double, 3>> all;
        for (const double z : axes_[2].nodes)
            for (const double y : axes_[1].nodes)
                for (const double x : axes_[0].nodes) all.push_back({x, y, z});
        return all;
    }

    // gmsh's error is below 1e-6 of an edge; anything near an edge is another mesh.
    int nearest_node(const std::array<double, 3>& position) const {
        int number = 0;
        for (int d = 0; d < 3; ++d) {
            const std::vector<double>& axis = axes_[d].nodes;
            const auto above = std::lower_bound(axis.begin() + 1, axis.end() - 1, position[d]);
            const auto below = above - 1;
            const auto at = position[d] - *below < *above - position[d] ? below : above;
            if (!(std::abs(position[d] - *at) < 1e-3 * (*above - *below))) refuse();
            number += stride(d) * static_cast<int>(at - axis.begin());
        }
        return number;
    }

    // All cells by their corners, in gmsh's and VTK's order from the lowest one on.
    std::vector<std::array<int, 8>> cells() const {
        std::vector<std::array<int, 8>> all;
        const int y = stride(1), z = stride(2);
        for (int k = 0; k + 1 < n(2); ++k)
            for (int j = 0; j + 1 < n(1); ++j)
                for (int i = 0; i + 1 < n(0); ++i) {
                    const int c = i + y * j + z * k, t = c + z;
                    all.push_back({c, c + 1, c + 1 + y, c + y, t, t + 1, t + 1 + y, t + y});
                }
        return all;
    }

    // Cyclic nodes of a boundary face, counter-clockwise from outside, from ascending ones.
    std::array<int, 4> outward(const std::array<int, 4>& ascending) const {
        const Index low = index(ascending[0]), high = index(ascending[3]);
        int normal = 0;
        while (normal < 3 && low[normal] != high[normal]) ++normal;
        if (normal == 3) refuse();
        const int e = stride((normal + 1) % 3), f = stride((normal + 2) % 3), c = ascending[0];
        return low[normal] == 0 ? std::array<int, 4>{c, c + f, c + e + f, c + e}
                                : std::array<int, 4>{c, c + e, c + e + f, c + f};
    }

  private:
    const std::array<GridAxis, 3>& axes_;
};

template <std::size_t size>
std::array<int, size> sorted(std::array<int, size> nodes) {
    std::ranges::sort(nodes);
    return nodes;
}

template <std::size_t size>
std::array<int, size> renumbered(std::array<int, size> nodes, const std::vector<int>& numbers) {
    for (int& node : nodes) node = numbers[node];
    return sorted(nodes);
}

// What gmsh has made, in grid numbers, nodes ascending: must be the cells, one by one.
void order_hexes(const HexMesh& mesh, const std::vector<int>& numbers, const Numbering& numbering,
                 HexMesh& ordered) {
    std::vector<std::pair<std::array<int, 8>, Region>> hexes;
    for (std::size_t e = 0; e < mesh.hexes.size(); ++e)
        hexes.emplace_back(renumbered(mesh.hexes[e], numbers), mesh.regions[e]);
    std::ranges::sort(hexes);
    ordered.hexes = numbering.cells();
    if (hexes.size() != ordered.hexes.size()) refuse();
    for (std::size_t e = 0; e < hexes.size(); ++e) {
        if (sorted(ordered.hexes[e]) != hexes[e].first) refuse();
        ordered.regions.push_back(hexes[e].second);
    }
}

void order_faces(const HexMesh& mesh, const std::vector<int>& numbers, const Numbering& numbering,
                 HexMesh& ordered) {
    std::vector<std::pair<Boundary, std::array<int, 4>>> faces;
    for (const HexMesh::Face& face : mesh.faces)
        faces.emplace_back(face.boundary, renumbered(face.nodes, numbers));
    std::ranges::sort(faces);
    for (const auto& [boundary, nodes] : faces) {
        ordered.faces.push_back({numbering.outward(nodes), boundary});
        if (sorted(ordered.faces.back().nodes) != nodes) refuse();
    }
}

}  // namespace

HexMesh in_grid_order(const HexMesh& mesh, const LayerGrid& grid) {
    const Numbering numbering(grid);
    std::vector<int> numbers;
    for (const auto& node : mesh.nodes) numbers.push_back(numbering.nearest_node(node));
    HexMesh ordered;
    ordered.nodes = numbering.nodes();
    std::vector<char> found(ordered.nodes.size(), 0);
    for (const int number : numbers)
        if (std::exchange(found[number], 1) != 0) refuse();
    if (numbers.size() != found.size()) refuse();
    order_hexes(mesh, numbers, numbering, ordered);
    order_faces(mesh, numbers, numbering, ordered);
    return ordered;
}

}  // namespace tricontact::meshes
