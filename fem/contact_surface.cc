#include "fem/contact_surface.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "contact/base/error.h"

// Row sums of the mass of a nine-node face are 1/36, 1/9 and 4/9 of a parallelogram for corners,
// edges and centre: Simpson's rule, all positive. With eight nodes those of the corners would be
// negative, and a contact pressure could not be read from nodal forces.
//
// Nodes on lines of equal distance become a grid (`arrange`), x fastest; others stay points with
// the nine-node quadrilaterals between them.

namespace tricontact::fem {

namespace {

using contact::ContactPoints;
using meshes::Boundary;

// Values of one coordinate, increasing, those closer than `tolerance` merged.
std::vector<double> distinct(std::vector<double> values, double tolerance) {
    std::ranges::sort(values);
    std::vector<double> kept;
    for (const double v : values)
        if (kept.empty() || v - kept.back() > tolerance) kept.push_back(v);
    return kept;
}

std::size_t nearest(const std::vector<double>& sorted, double value) {
    const auto after = std::ranges::lower_bound(sorted, value);
    if (after == sorted.begin()) return 0;
    if (after == sorted.end()) return sorted.size() - 1;
    return after - sorted.begin() - (value - after[-1] < *after - value ? 1 : 0);
}

// Lines of coordinates within `tolerance`: a mesh file has nine digits, and a node a digit beside
// its line would make a patch irregular that is not.
// Lines of nodes along x and y, sorted.
struct Lines {
    std::vector<double> x, y;
    double tolerance;  // below which coordinates are the same

    Lines(const Q2Space& space, const std::vector<int>& nodes) {
        for (const int node : nodes) {
            x.push_back(space.nodes[node][0]);
            y.push_back(space.nodes[node][1]);
        }
        const auto extent = [](const std::vector<double>& v) {
            const auto [low, high] = std::ranges::minmax(v);
            return high - low;
        };
        // Far below any element, far above the rounding of a mesh file with 9 digits.
        tolerance = 1e-7 * std::max(extent(x), extent(y));
        x = distinct(std::move(x), tolerance);
        y = distinct(std::move(y), tolerance);
    }

    static std::optional<double> even_spacing(const std::vector<double>& lines, double tolerance) {
        if (lines.size() < 2) return std::nullopt;
        const double spacing =
            (lines.back() - lines.front()) / static_cast<double>(lines.size() - 1);
        for (std::size_t i = 0; i < lines.size(); ++i)
            if (std::abs(lines[i] - lines[0] - static_cast<double>(i) * spacing) > tolerance)
                return std::nullopt;
        return spacing;
    }
};

std::vector<int> nodes_on(const Q2Space& space, Boundary boundary) {
    std::vector<int> nodes;
    for (const auto& face : space.faces)
        if (face.boundary == boundary)
            nodes.insert(nodes.end(), face.nodes.begin(), face.nodes.end());
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

// Sorts by lines of y, then x; describes the grid if there is one and moves points onto it.
ContactPoints arrange(const Q2Space& space, std::vector<int>& nodes) {
    const Lines lines(space, nodes);
    const auto place = [&](int node) {
        const auto& x = space.nodes[node];
        return std::pair(nearest(lines.y, x[1]), nearest(lines.x, x[0]));
    };
    std::ranges::sort(nodes, {}, place);
    ContactPoints points;
    for (const int node : nodes) {
        points.x.push_back(space.nodes[node][0]);
        points.y.push_back(space.nodes[node][1]);
    }
    const auto dx = Lines::even_spacing(lines.x, lines.tolerance);
    const auto dy = Lines::even_spacing(lines.y, lines.tolerance);
    if (!dx || !dy || nodes.size() != lines.x.size() * lines.y.size()) return points;
    points.n_x = static_cast<int>(lines.x.size());
    points.n_y = static_cast<int>(lines.y.size());
    points.first = {lines.x[0], lines.y[0]};
    points.spacing = {*dx, *dy};
    for (int j = 0; j < points.n_y; ++j)
        for (int i = 0; i < points.n_x; ++i) {
            points.x[j * points.n_x + i] = points.first[0] + i * *dx;
            points.y[j * points.n_x + i] = points.first[1] + j * *dy;
        }
    return points;
}

// Lower triangle of the mass from the faces, and the quadrilaterals.
void add_faces(const Q2Space& space, ContactSurface& surface) {
    std::map<int, int> point_of_node;
    for (std::size_t i = 0; i < surface.nodes.size(); ++i)
        point_of_node[surface.nodes[i]] = static_cast<int>(i);
    std::vector<std::map<int, double>> columns(surface.nodes.size());
    for (std::size_t f = 0; f < space.faces.size(); ++f) {
        const auto& face = space.faces[f];
        if (face.boundary != Boundary::contact) continue;
        auto& quad = surface.points.quads.emplace_back();
        for (int i = 0; i < 9; ++i) quad[i] = point_of_node.at(face.nodes[i]);
        const auto mass = space.face_mass(f);
        for (int j = 0; j < 9; ++j)
            for (int i = 0; i < 9; ++i)
                if (quad[i] >= quad[j]) columns[quad[j]][quad[i]] += mass[i][j];
    }
    auto& [n, start, row, value] = surface.mass;
    n = static_cast<int>(columns.size());
    start.push_back(0);
    for (const auto& column : columns) {
        for (const auto& [r, v] : column) {
            row.push_back(r);
            value.push_back(v);
        }
        start.push_back(static_cast<std::int64_t>(row.size()));
    }
}

std::vector<double> row_sums(const SparseMatrix& lower) {
    std::vector<double> sums(lower.n, 0.0);
    for (int c = 0; c < lower.n; ++c)
        for (auto k = lower.column_start[c]; k < lower.column_start[c + 1]; ++k) {
            sums[lower.row[k]] += lower.value[k];
            if (lower.row[k] != c) sums[c] += lower.value[k];
        }
    return sums;
}

}  // namespace

ContactSurface contact_surface(const Q2Space& space) {
    ContactSurface surface;
    surface.nodes = nodes_on(space, Boundary::contact);
    if (surface.nodes.empty())
        throw contact::InputError(
            "mesh: no face is named \"contact\"; name those on which the indenter presses");
    surface.points = arrange(space, surface.nodes);
    auto& points = surface.points;
    points.mirrored = std::ranges::any_of(
        space.faces, [](const auto& face) { return face.boundary == Boundary::symmetry; });
    add_faces(space, surface);
    points.area = row_sums(surface.mass);
    for (double& area : points.area) {
        if (!(area > 0))
            throw contact::InputError(
                "mesh: a contact face is so distorted that a node's share of its area is not "
                "positive; mesh the contact with parallelograms");
        if (points.mirrored) area *= 2;
    }
    return surface;
}

}  // namespace tricontact::fem
