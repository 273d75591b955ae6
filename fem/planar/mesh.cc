#include "fem/planar/mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace tricontact::fem::planar {

namespace {

/// Nodes by position: what lies within a small part of the smallest element of another is the same.
class NodeSet {
  public:
    explicit NodeSet(std::vector<Point>& nodes) : nodes_(nodes) {}

    int number_of(const Point& x, double tolerance) {
        const auto [i, k] = std::pair(cell(x[0]), cell(x[1]));
        for (const std::int64_t di : {-1, 0, 1})
            for (const std::int64_t dk : {-1, 0, 1})
                if (const auto at = found_.find({i + di, k + dk}); at != found_.end())
                    for (const int node : at->second)
                        if (std::hypot(nodes_[node][0] - x[0], nodes_[node][1] - x[1]) < tolerance)
                            return node;
        nodes_.push_back(x);
        const int node = static_cast<int>(nodes_.size()) - 1;
        found_[{i, k}].push_back(node);
        return node;
    }
    void set_cell(double size) { size_ = size; }

  private:
    std::int64_t cell(double x) const { return std::llround(std::floor(x / size_)); }

    std::vector<Point>& nodes_;
    double size_ = 1;
    std::map<std::pair<std::int64_t, std::int64_t>, std::vector<int>> found_;
};

using Grid = std::vector<std::vector<Point>>;  // by u, then v

Grid grid_of(const Block& b) {
    const Point sw = b.south(0), se = b.south(1), nw = b.north(0), ne = b.north(1);
    Grid grid(b.u.size(), std::vector<Point>(b.v.size()));
    for (std::size_t i = 0; i < b.u.size(); ++i)
        for (std::size_t k = 0; k < b.v.size(); ++k) {
            const double u = b.u[i], v = b.v[k];
            const Point s = b.south(u), n = b.north(u), w = b.west(v), e = b.east(v);
            for (int d = 0; d < 2; ++d)
                grid[i][k][d] = (1 - v) * s[d] + v * n[d] + (1 - u) * w[d] + u * e[d] -
                                ((1 - u) * (1 - v) * sw[d] + u * (1 - v) * se[d] +
                                 (1 - u) * v * nw[d] + u * v * ne[d]);
        }
    return grid;
}

/// Least distance of neighbours [m].
double least_spacing(const Grid& grid) {
    double least = INFINITY;
    for (std::size_t i = 0; i < grid.size(); ++i)
        for (std::size_t k = 0; k < grid[i].size(); ++k) {
            const auto to = [&](const Point& x) {
                least = std::min(least, std::hypot(x[0] - grid[i][k][0], x[1] - grid[i][k][1]));
            };
            if (i + 1 < grid.size()) to(grid[i + 1][k]);
            if (k + 1 < grid[i].size()) to(grid[i][k + 1]);
        }
    return least;
}

void add_edges(const Block& b, const std::vector<std::vector<int>>& number, Mesh& mesh) {
    const int m = static_cast<int>(b.u.size()) / 2, n = static_cast<int>(b.v.size()) / 2;
    for (int side = 0; side < 4; ++side) {
        const bool along_u = side % 2 == 0, last = side == 1 || side == 2;
        for (int e = 0; e < (along_u ? m : n); ++e) {
            const bool is_free = b.boundaries[side] == Boundary::free ||
                                 (b.boundaries[side] == Boundary::contact && e >= b.n_contact);
            if (is_free) continue;
            const auto node = [&](int k) {
                return along_u ? number[2 * e + k][last ? 2 * n : 0]
                               : number[last ? 2 * m : 0][2 * e + k];
            };
            mesh.edges.push_back({{node(0), node(2), node(1)}, b.boundaries[side]});
        }
    }
}

/// Nodes of an element whose image is one: anticlockwise again.
constexpr std::array<int, 9> reflected{1, 0, 3, 2, 4, 7, 6, 5, 8};

}  // namespace

Block::Curve line_between(const Point& from, const Point& to) {
    return [=](double s) -> Point {
        return {(1 - s) * from[0] + s * to[0], (1 - s) * from[1] + s * to[1]};
    };
}

Block::Curve arc(const Point& centre, double radius, double from, double to) {
    return [=](double s) -> Point {
        const double angle = (1 - s) * from + s * to;
        return {centre[0] + radius * std::sin(angle), centre[1] - radius * std::cos(angle)};
    };
}

Mesh join(const std::vector<Block>& blocks) {
    Mesh mesh;
    std::vector<Grid> grids;
    double spacing = INFINITY;
    for (const Block& block : blocks)
        spacing = std::min(spacing, least_spacing(grids.emplace_back(grid_of(block))));
    NodeSet set(mesh.nodes);
    set.set_cell(spacing);
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        const Grid& grid = grids[b];
        std::vector<std::vector<int>> number(grid.size(), std::vector<int>(grid[0].size()));
        for (std::size_t i = 0; i < grid.size(); ++i)
            for (std::size_t k = 0; k < grid[i].size(); ++k)
                number[i][k] = set.number_of(grid[i][k], spacing / 8);
        for (std::size_t i = 0; i + 2 < grid.size(); i += 2)
            for (std::size_t k = 0; k + 2 < grid[i].size(); k += 2)
                mesh.cells.push_back({number[i][k], number[i + 2][k], number[i + 2][k + 2],
                                      number[i][k + 2], number[i + 1][k], number[i + 2][k + 1],
                                      number[i + 1][k + 2], number[i][k + 1],
                                      number[i + 1][k + 1]});
        add_edges(blocks[b], number, mesh);
    }
    // Rounding must not tell the plane of symmetry from x = 0.
    for (Point& x : mesh.nodes)
        if (std::abs(x[0]) < 1e-3 * spacing) x[0] = 0;
    return mesh;
}

Mesh with_mirror_image(const Mesh& half) {
    Mesh whole;
    whole.nodes = half.nodes;
    whole.cells = half.cells;
    std::vector<int> image(half.nodes.size());
    for (std::size_t i = 0; i < image.size(); ++i) {
        const auto [x, z] = half.nodes[i];
        image[i] = x == 0 ? static_cast<int>(i) : static_cast<int>(whole.nodes.size());
        if (x != 0) whole.nodes.push_back({-x, z});
    }
    for (const auto& cell : half.cells) {
        auto& other = whole.cells.emplace_back();
        for (int i = 0; i < 9; ++i) other[i] = image[cell[reflected[i]]];
    }
    for (const auto& [nodes, boundary] : half.edges) {
        if (boundary == Boundary::symmetry) continue;
        whole.edges.push_back({nodes, boundary});
        whole.edges.push_back({{image[nodes[1]], image[nodes[0]], image[nodes[2]]}, boundary});
    }
    return whole;
}

Mesh upside_down(const Mesh& section) {
    Mesh mesh = section;
    for (Point& x : mesh.nodes) x[1] = -x[1];
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        for (int i = 0; i < 9; ++i) mesh.cells[c][i] = section.cells[c][reflected[i]];
    for (auto& edge : mesh.edges) std::swap(edge.nodes[0], edge.nodes[1]);
    return mesh;
}

}  // namespace tricontact::fem::planar
