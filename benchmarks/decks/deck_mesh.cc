#include "benchmarks/decks/deck_mesh.h"

#include <cmath>
#include <stdexcept>

namespace tricontact::benchmarks {

namespace {

using Point = DeckMesh::Point;
using Place = std::array<int, 3>;  // in half elements along each direction

// Corners of the unit element, in halves; those of the plane one are the first four.
constexpr std::array<Place, 8> corner_places{
    {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}}};
constexpr std::array<std::array<int, 2>, 12> edges{{{0, 1},
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
// Faces by their corners, from S1 on.
constexpr std::array<std::array<int, 4>, 6> hexahedron_faces{
    {{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}}};

std::vector<Place> element_places(int dimension, bool is_quadratic) {
    const int n_corners = dimension == 2 ? 4 : 8;
    std::vector<Place> places(corner_places.begin(), corner_places.begin() + n_corners);
    if (!is_quadratic) return places;
    for (int e = 0; e < (dimension == 2 ? 4 : 12); ++e) {
        const Place &a = corner_places[edges[e][0]], &b = corner_places[edges[e][1]];
        places.push_back({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2});
    }
    return places;
}

double at_half(const std::vector<double>& line, int i) {
    return i % 2 == 0 ? line[i / 2] : (line[i / 2] + line[i / 2 + 1]) / 2;
}

// Derivatives of the shape functions of serendipity elements at a point of [-1, 1]^d.
std::vector<Point> shape_gradients(const std::vector<Place>& places, int dimension,
                                   const Point& s) {
    const bool is_quadratic = places.size() == (dimension == 2 ? 8u : 20u);
    std::vector<Point> gradients;
    for (const Place& place : places) {
        std::array<double, 3> value{1, 1, 1}, slope{};
        double corner_sum = is_quadratic ? -(dimension - 1) : 1;
        bool is_middle = false;
        for (int k = 0; k < dimension; ++k) {
            const double side = place[k] - 1;
            is_middle = is_middle || side == 0;
            value[k] = side == 0 ? 1 - s[k] * s[k] : (1 + side * s[k]) / 2;
            slope[k] = side == 0 ? -2 * s[k] : side / 2;
            if (is_quadratic) corner_sum += side * s[k];
        }
        const double product = value[0] * value[1] * value[2];
        Point gradient{};
        for (int k = 0; k < dimension; ++k) {
            double others = 1;
            for (int l = 0; l < dimension; ++l)
                if (l != k) others *= value[l];
            gradient[k] = slope[k] * others;
            if (is_quadratic && !is_middle)
                gradient[k] = gradient[k] * corner_sum + product * (place[k] - 1);
        }
        gradients.push_back(gradient);
    }
    return gradients;
}

double determinant(const std::array<Point, 3>& m) {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

}  // namespace

std::vector<int> DeckMesh::face_nodes(const ElementFace& face) const {
    const std::vector<int>& element = elements[face.element];
    const int f = face.face - 1;
    std::vector<int> nodes_of_face;
    if (dimension == 2) {
        nodes_of_face = {element[f], element[(f + 1) % 4]};
        if (is_quadratic) nodes_of_face.push_back(element[4 + f]);
        return nodes_of_face;
    }
    const auto& corners = hexahedron_faces[f];
    for (const int corner : corners) nodes_of_face.push_back(element[corner]);
    for (int k = 0; is_quadratic && k < 4; ++k)
        for (int e = 0; e < 12; ++e) {
            const int a = corners[k], b = corners[(k + 1) % 4];
            if ((edges[e][0] == a && edges[e][1] == b) || (edges[e][0] == b && edges[e][1] == a))
                nodes_of_face.push_back(element[8 + e]);
        }
    return nodes_of_face;
}

void add_block(DeckMesh& mesh, const BlockLines& lines,
               const std::function<Point(const Point&)>& place, const std::vector<BlockSet>& sets) {
    const int dimension = lines.is_spatial() ? 3 : 2;
    const auto count = [](const std::vector<double>& line) {
        return line.empty() ? 0 : static_cast<int>(line.size()) - 1;
    };
    const Place n{count(lines.x), count(lines.y), count(lines.z)};
    const Place halves{2 * n[0] + 1, 2 * n[1] + 1, 2 * n[2] + 1};
    const auto index = [&](const Place& p) {
        return (static_cast<std::size_t>(p[2]) * halves[1] + p[1]) * halves[0] + p[0];
    };
    std::vector<int> node_of(static_cast<std::size_t>(halves[0]) * halves[1] * halves[2], -1);
    for (Place p{}; p[2] < halves[2]; ++p[2])
        for (p[1] = 0; p[1] < halves[1]; ++p[1])
            for (p[0] = 0; p[0] < halves[0]; ++p[0]) {
                const int n_odd = p[0] % 2 + p[1] % 2 + p[2] % 2;
                if (n_odd > (mesh.is_quadratic ? 1 : 0)) continue;
                const Point unmoved{at_half(lines.x, p[0]), at_half(lines.y, p[1]),
                                    dimension == 3 ? at_half(lines.z, p[2]) : 0};
                const int node = node_of[index(p)] = static_cast<int>(mesh.nodes.size());
                mesh.nodes.push_back(place(unmoved));
                for (const BlockSet& set : sets)
                    if (set.holds(unmoved)) mesh.node_sets[set.name].push_back(node);
            }
    const std::vector<Place> places = element_places(dimension, mesh.is_quadratic);
    for (Place e{}; e[2] < std::max(n[2], 1); ++e[2])
        for (e[1] = 0; e[1] < n[1]; ++e[1])
            for (e[0] = 0; e[0] < n[0]; ++e[0]) {
                std::vector<int>& element = mesh.elements.emplace_back();
                for (const Place& p : places)
                    element.push_back(
                        node_of[index({2 * e[0] + p[0], 2 * e[1] + p[1], 2 * e[2] + p[2]})]);
            }
}

double volume_of(const DeckMesh& mesh, int first, int last) {
    const std::vector<Place> places = element_places(mesh.dimension, mesh.is_quadratic);
    // Gauss' rule of three points along each direction.
    const std::array<double, 3> points{-std::sqrt(.6), 0, std::sqrt(.6)},
        weights{5. / 9, 8. / 9, 5. / 9};
    double volume = 0;
    for (int i = 0; i < (mesh.dimension == 2 ? 9 : 27); ++i) {
        const Place q{i % 3, i / 3 % 3, i / 9};
        const Point s{points[q[0]], points[q[1]], mesh.dimension == 3 ? points[q[2]] : 0};
        const double weight =
            weights[q[0]] * weights[q[1]] * (mesh.dimension == 3 ? weights[q[2]] : 1);
        const std::vector<Point> gradients = shape_gradients(places, mesh.dimension, s);
        for (int e = first; e < last; ++e) {
            std::array<Point, 3> jacobian{};
            if (mesh.dimension == 2) jacobian[2][2] = 1;
            for (std::size_t k = 0; k < places.size(); ++k)
                for (int a = 0; a < mesh.dimension; ++a)
                    for (int b = 0; b < mesh.dimension; ++b)
                        jacobian[a][b] += mesh.nodes[mesh.elements[e][k]][a] * gradients[k][b];
            const double det = determinant(jacobian);
            if (!(det > 0)) throw std::logic_error("an element of the deck is turned inside out");
            volume += det * weight;
        }
    }
    return volume;
}

}  // namespace tricontact::benchmarks
