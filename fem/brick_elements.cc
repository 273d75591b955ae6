#include "fem/brick_elements.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>

#include "contact/base/gauss_legendre.h"
#include "fem/quadratic_line.h"

namespace tricontact::fem {

namespace {

/// Hexahedron along the axes [m].
struct Brick {
    meshes::Point low, high;

    double size(int axis) const { return high[axis] - low[axis]; }
    double at(int axis, int position) const {  // of node_positions
        if (position == 1) return (low[axis] + high[axis]) / 2;
        return position == 0 ? low[axis] : high[axis];
    }
};

/// Empty unless the mesh has bricks alone.
std::vector<Brick> bricks_of(const meshes::HexMesh& mesh) {
    std::vector<Brick> bricks;
    bricks.reserve(mesh.hexes.size());
    for (const auto& hex : mesh.hexes) {
        const Brick& brick = bricks.emplace_back(Brick{mesh.nodes[hex[0]], mesh.nodes[hex[6]]});
        for (int axis = 0; axis < 3; ++axis) {
            if (!(brick.size(axis) > 0)) return {};
            for (int v = 0; v < 8; ++v)
                if (mesh.nodes[hex[v]][axis] != brick.at(axis, node_positions[v][axis])) return {};
        }
    }
    return bricks;
}

// Nodes in the order in which deal.II 9.4 numbers what a cell finds without a number: corners,
// edges, faces, centre.
constexpr std::array<int, 27> order_of_numbers{0,  1,  3,  2,  4,  5,  7,  6,  11,
                                               9,  8,  10, 15, 13, 12, 14, 16, 17,
                                               19, 18, 20, 21, 22, 23, 24, 25, 26};
constexpr int first_edge = 8, first_face = 20;
/// Corners at the ends of the edges.
constexpr std::array<std::array<int, 2>, 12> edge_ends{{{0, 1},
                                                        {1, 2},
                                                        {2, 3},
                                                        {3, 0},
                                                        {4, 5},
                                                        {5, 6},
                                                        {6, 7},
                                                        {7, 4},
                                                        {0, 4},
                                                        {1, 5},
                                                        {2, 6},
                                                        {3, 7}}};
/// Nodes in the middle of meshes::hex_faces.
constexpr std::array<int, 6> middle_of_face{24, 25, 22, 21, 23, 20};

/// Faces of the hexahedra and what lies on the boundary.
struct Faces {
    std::vector<std::array<std::size_t, 6>> of_hex;  ///< x, y, z, the lower one first
    std::size_t n = 0;
    std::vector<std::optional<meshes::Boundary>> boundary;  ///< per face; empty: inside
};

/// Empty unless all faces on the boundary, and no others, have names.
std::optional<Faces> faces_of(const meshes::HexMesh& mesh) {
    const meshes::FaceTable table(mesh);
    Faces faces;
    faces.n = table.n_faces();
    faces.of_hex.resize(mesh.hexes.size());
    faces.boundary.resize(faces.n);
    for (const auto& [nodes, boundary] : mesh.faces) {
        const std::size_t face = table.find(nodes);
        if (face == faces.n || faces.boundary[face]) return {};
        faces.boundary[face] = boundary;
    }
    for (std::size_t face = 0; face < faces.n; ++face) {
        const auto sides = table.sides(face);
        if (sides.size() > 2 || faces.boundary[face].has_value() != (sides.size() == 1)) return {};
        for (const auto& side : sides)
            faces.of_hex[side.hex][middle_of_face[side.face] - first_face] = face;
    }
    return faces;
}

/// Gives numbers to what is met for the first time.
class Numbers {
  public:
    Numbers(std::size_t n_corners, std::size_t n_faces)
        : corner_(n_corners, -1), face_(n_faces, -1) {}

    /// Whether `number` is a new one.
    struct Met {
        int number;
        bool is_new;
    };
    Met of(const std::array<int, 8>& hex, const std::array<std::size_t, 6>& faces, int node) {
        if (node == centre_of_cell) return {n_++, true};
        if (node >= first_face) return met(face_[faces[node - first_face]]);
        if (node < first_edge) return met(corner_[hex[node]]);
        const auto [a, b] = edge_ends[node - first_edge];
        const auto [low, high] = std::minmax(hex[a], hex[b]);
        const std::uint64_t key =
            static_cast<std::uint64_t>(low) << 32 | static_cast<unsigned>(high);
        return met(edge_.try_emplace(key, -1).first->second);
    }

  private:
    Met met(int& number) {
        if (number >= 0) return {number, false};
        return {number = n_++, true};
    }

    int n_ = 0;
    std::vector<int> corner_, face_;
    std::unordered_map<std::uint64_t, int> edge_;
};

class BrickRule : public ElementRule {
  public:
    BrickRule(int n, const std::vector<Brick>& bricks) : bricks_(bricks) {
        const auto& [points, weights] = contact::gauss_legendre(n);
        for (int k = 0; k < n; ++k)
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i) {
                    add({points[i], points[j], points[k]}, weights[i] * weights[j] * weights[k]);
                }
    }

    void reinit(std::size_t cell, ElementValues& to) override {
        const Brick& brick = bricks_[cell];
        const std::array size{brick.size(0), brick.size(1), brick.size(2)};
        const double volume = size[0] * size[1] * size[2];
        to.weights.resize(at_.size());
        for (std::size_t q = 0; q < at_.size(); ++q) {
            to.weights[q] = at_[q].weight * volume;
            for (int d = 0; d < 3; ++d) to.points[q][d] = brick.low[d] + at_[q].place[d] * size[d];
            for (int i = 0; i < 27; ++i)
                for (int d = 0; d < 3; ++d) to.gradients[q][i][d] = at_[q].slopes[i][d] / size[d];
        }
    }

  private:
    /// A point of the unit cube.
    struct GaussPoint {
        double weight;
        std::array<double, 3> place;
        ElementValues::Gradients slopes;
    };

    void add(const std::array<double, 3>& place, double weight) {
        GaussPoint& point = at_.emplace_back(GaussPoint{weight, place, {}});
        std::array<QuadraticLine::Values, 3> value, slope;
        for (int d = 0; d < 3; ++d) {
            value[d] = QuadraticLine::values_at(2 * place[d] - 1);
            slope[d] = QuadraticLine::slopes_at(2 * place[d] - 1);
        }
        for (int i = 0; i < 27; ++i)
            for (int d = 0; d < 3; ++d) {
                point.slopes[i][d] = 1;
                for (int e = 0; e < 3; ++e)
                    point.slopes[i][d] *= (e == d ? slope : value)[e][node_positions[i][e]];
            }
    }

    const std::vector<Brick>& bricks_;
    std::vector<GaussPoint> at_;
};

class BrickElements : public Q2Elements {
  public:
    BrickElements(const meshes::HexMesh& mesh, std::vector<Brick> bricks, const Faces& faces,
                  Q2Space& space)
        : bricks_(std::move(bricks)) {
        space.regions = mesh.regions;
        Numbers numbers(mesh.nodes.size(), faces.n);
        for (std::size_t c = 0; c < bricks_.size(); ++c) {
            auto& cell = space.cells.emplace_back();
            for (const int i : order_of_numbers) {
                const auto [number, is_new] = numbers.of(mesh.hexes[c], faces.of_hex[c], i);
                cell[i] = number;
                if (!is_new) continue;
                auto& node = space.nodes.emplace_back();
                for (int d = 0; d < 3; ++d) node[d] = bricks_[c].at(d, node_positions[i][d]);
            }
        }
        for (std::size_t c = 0; c < bricks_.size(); ++c)
            for (int f = 0; f < 6; ++f)
                if (const auto boundary = faces.boundary[faces.of_hex[c][f]]) {
                    auto& face = space.faces.emplace_back(Q2Space::Face{{}, *boundary});
                    const auto local = nodes_on_face(f / 2, f % 2 == 1);
                    for (int i = 0; i < 9; ++i) face.nodes[i] = space.cells[c][local[i]];
                    cell_of_face_.emplace_back(c, f);
                }
    }

    std::array<std::array<double, 9>, 9> face_mass(std::size_t face) const override {
        static const QuadraticLine line;
        const auto [c, f] = cell_of_face_[face];
        const auto local = nodes_on_face(f / 2, f % 2 == 1);
        std::array<std::array<double, 9>, 9> mass{};
        for (int i = 0; i < 9; ++i)
            for (int j = 0; j < 9; ++j) {
                mass[i][j] = 1;
                for (int d = 0; d < 3; ++d)
                    if (d != f / 2)
                        mass[i][j] *=
                            bricks_[c].size(d) *
                            line.mass[node_positions[local[i]][d]][node_positions[local[j]][d]];
            }
        return mass;
    }

    std::unique_ptr<ElementRule> rule(int n) const override {
        return std::make_unique<BrickRule>(n, bricks_);
    }

  private:
    std::vector<Brick> bricks_;
    std::vector<std::pair<std::size_t, int>> cell_of_face_;  // and the face's number there
};

}  // namespace

std::unique_ptr<const Q2Elements> brick_elements(const meshes::HexMesh& mesh, Q2Space& space) {
    std::vector<Brick> bricks = bricks_of(mesh);
    if (bricks.empty()) return nullptr;
    const auto faces = faces_of(mesh);
    if (!faces) return nullptr;
    return std::make_unique<BrickElements>(mesh, std::move(bricks), *faces, space);
}

}  // namespace tricontact::fem
