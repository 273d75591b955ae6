#include "fem/planar/body.h"

#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>
#include <map>

#include "contact/base/error.h"
#include "fem/condensation.h"

// Unknowns: interior nodes first, both directions of a node together; then the nodes of the contact
// surface, along x of all, then along z. The condensation itself is that of three dimensions.

namespace tricontact::fem::planar {

namespace {

struct Unknowns {
    std::vector<std::array<int, 2>> of_node;  // -1: held
    std::vector<int> node_of_unknown;
    int n_interior = 0;
};

/// Nodes of the contact surface in the order of their coordinate.
struct Surface {
    std::vector<int> nodes;
    std::vector<double> along;
    std::vector<std::array<int, 3>> edges;
};

double coordinate(const BodyProblem& problem, const Point& x) {
    if (problem.frame == Frame::plane) return x[0];
    return problem.radius * std::atan2(x[0], problem.radius - x[1]);
}

Surface surface_of(const BodyProblem& problem) {
    std::vector<std::pair<double, int>> found;
    for (const auto& [nodes, boundary] : problem.mesh.edges)
        if (boundary == Boundary::contact)
            for (const int node : nodes)
                found.emplace_back(coordinate(problem, problem.mesh.nodes[node]), node);
    if (found.empty())
        throw contact::InputError("mesh: no edge of a body touches; name its contact surface");
    std::ranges::sort(found);
    const auto repeated = std::ranges::unique(found);
    found.erase(repeated.begin(), repeated.end());
    Surface surface;
    std::map<int, int> number;
    for (const auto& [s, node] : found) {
        number[node] = static_cast<int>(surface.nodes.size());
        surface.nodes.push_back(node);
        surface.along.push_back(s);
    }
    for (const auto& [nodes, boundary] : problem.mesh.edges) {
        if (boundary != Boundary::contact) continue;
        std::array<int, 3> edge{number[nodes[0]], number[nodes[2]], number[nodes[1]]};
        if (edge[0] > edge[2]) std::swap(edge[0], edge[2]);
        surface.edges.push_back(edge);
    }
    std::ranges::sort(surface.edges);
    return surface;
}

/// Node of the support that is nearest to x = 0; -1 without a support.
int middle_of_support(const Mesh& mesh) {
    int nearest = -1;
    for (const auto& [nodes, boundary] : mesh.edges) {
        if (boundary != Boundary::support) continue;
        for (const int node : nodes)
            if (nearest < 0 || std::abs(mesh.nodes[node][0]) < std::abs(mesh.nodes[nearest][0]))
                nearest = node;
    }
    return nearest;
}

/// By node and direction, whether it is held. A whole section in plane strain whose support does
/// not hold it along x is held there by one node, in the middle.
std::vector<std::array<bool, 2>> held_of(const BodyProblem& problem) {
    const auto& [nodes, cells, edges] = problem.mesh;
    std::vector<std::array<bool, 2>> held(nodes.size(), {false, false});
    bool has_symmetry = problem.solid == Solid::of_revolution;
    for (const auto& [on_edge, boundary] : edges) {
        has_symmetry = has_symmetry || boundary == Boundary::symmetry;
        for (const int node : on_edge) {
            if (boundary == Boundary::symmetry) held[node][0] = true;
            if (boundary != Boundary::support) continue;
            held[node][0] = held[node][0] || problem.support == Support::bonded;
            held[node][1] = held[node][1] || problem.support != Support::point;
        }
    }
    if (const int middle = middle_of_support(problem.mesh); middle >= 0) {
        held[middle][0] = held[middle][0] || !has_symmetry;
        held[middle][1] = true;
    }
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (problem.solid == Solid::of_revolution && nodes[i][0] == 0) held[i][0] = true;
    return held;
}

Unknowns number_unknowns(const BodyProblem& problem, const Surface& surface) {
    const auto held = held_of(problem);
    std::vector<bool> touches(held.size(), false);
    for (const int node : surface.nodes) touches[node] = true;
    Unknowns unknowns;
    unknowns.of_node.assign(held.size(), {-1, -1});
    const auto add = [&](int node, int direction) {
        if (held[node][direction]) return;
        unknowns.of_node[node][direction] = static_cast<int>(unknowns.node_of_unknown.size());
        unknowns.node_of_unknown.push_back(node);
    };
    for (int node = 0; node < static_cast<int>(held.size()); ++node)
        if (!touches[node])
            for (const int direction : {0, 1}) add(node, direction);
    unknowns.n_interior = static_cast<int>(unknowns.node_of_unknown.size());
    for (const int direction : {0, 1})
        for (const int node : surface.nodes) add(node, direction);
    return unknowns;
}

/// `held_row`: the sum of K u over all components along z that are held is its product with u.
struct Stiffness {
    SparseMatrix matrix;
    std::vector<double> held_row;
};

Stiffness assemble(const BodyProblem& problem, const Unknowns& unknowns) {
    const Moduli moduli = moduli_of(problem.material, problem.largest_bulk_ratio);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(problem.mesh.cells.size() * 171);
    std::vector<double> held_row(unknowns.node_of_unknown.size(), 0);
    ElementStiffness k;
    for (const auto& cell : problem.mesh.cells) {
        ElementNodes nodes;
        std::array<int, n_element_unknowns> unknown{};
        for (int i = 0; i < 9; ++i) {
            nodes[i] = problem.mesh.nodes[cell[i]];
            for (int a = 0; a < 2; ++a) unknown[a * 9 + i] = unknowns.of_node[cell[i]][a];
        }
        element_stiffness(nodes, problem.solid, moduli, k);
        for (int r = 0; r < n_element_unknowns; ++r)
            for (int c = 0; c < n_element_unknowns; ++c) {
                if (unknown[c] < 0) continue;
                if (unknown[r] >= unknown[c]) entries.emplace_back(unknown[r], unknown[c], k[r][c]);
                if (unknown[r] < 0 && r >= n_element_unknowns / 2) held_row[unknown[c]] += k[r][c];
            }
    }
    const auto n = static_cast<int>(unknowns.node_of_unknown.size());
    Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t> lower(n, n);
    lower.setFromTriplets(entries.begin(), entries.end());
    const auto n_entries = lower.nonZeros();
    return {{n,
             {lower.outerIndexPtr(), lower.outerIndexPtr() + n + 1},
             {lower.innerIndexPtr(), lower.innerIndexPtr() + n_entries},
             {lower.valuePtr(), lower.valuePtr() + n_entries}},
            std::move(held_row)};
}

/// Directions of a node: along the surface, and into the substrate.
std::array<Point, 2> frame_at(const BodyProblem& problem, double along) {
    const double angle = problem.frame == Frame::plane ? 0 : along / problem.radius;
    return {{{std::cos(angle), std::sin(angle)}, {std::sin(angle), -std::cos(angle)}}};
}

/// From x, z of the free unknowns to the frames of all nodes.
std::vector<double> in_frames(const BodyProblem& problem, const Unknowns& unknowns,
                              const Surface& surface, const std::vector<double>& compliance) {
    const std::size_t n = surface.nodes.size();
    const std::size_t n_free = unknowns.node_of_unknown.size() - unknowns.n_interior;
    std::vector<double> turned(4 * n * n, 0);
    const auto entry = [&](std::size_t i, int a, std::size_t k, int b) {
        const int r = unknowns.of_node[surface.nodes[i]][a] - unknowns.n_interior;
        const int c = unknowns.of_node[surface.nodes[k]][b] - unknowns.n_interior;
        return r < 0 || c < 0 ? 0 : compliance[c * n_free + r];
    };
    for (std::size_t k = 0; k < n; ++k) {
        const auto of_k = frame_at(problem, surface.along[k]);
        for (std::size_t i = 0; i < n; ++i) {
            const auto of_i = frame_at(problem, surface.along[i]);
            for (int a = 0; a < 2; ++a)
                for (int b = 0; b < 2; ++b) {
                    const double value = entry(i, a, k, b);
                    for (int d = 0; d < 2; ++d)
                        for (int e = 0; e < 2; ++e)
                            turned[(e * n + k) * 2 * n + d * n + i] +=
                                of_i[d][a] * value * of_k[e][b];
                }
        }
    }
    return turned;
}

// The reaction to a unit force on a component is minus the displacement there when all that is held
// along z moves by one (reciprocity), and a body that is held moves with it as a whole.
std::vector<double> missing_reaction(const BodyProblem& problem, const Unknowns& unknowns,
                                     const Surface& surface, const Condensation& condensation,
                                     std::vector<double> held_row) {
    for (double& k : held_row) k = -k;
    const std::vector<double> moved = condensation.solve(held_row);
    const std::size_t n = surface.nodes.size();
    std::vector<double> missing(2 * n, 0);
    for (std::size_t i = 0; i < n; ++i) {
        const auto frame = frame_at(problem, surface.along[i]);
        for (int a = 0; a < 2; ++a) {
            const int unknown = unknowns.of_node[surface.nodes[i]][a];
            if (unknown < 0) continue;
            const double along_z = (a == 1 ? 1 : 0) - moved[unknown];
            for (int d = 0; d < 2; ++d) missing[d * n + i] += frame[d][a] * along_z;
        }
    }
    return missing;
}

}  // namespace

CondensedSection condense(const BodyProblem& problem) {
    const Surface surface = surface_of(problem);
    const Unknowns unknowns = number_unknowns(problem, surface);
    Stiffness stiffness = assemble(problem, unknowns);
    Condensation condensation(stiffness.matrix, unknowns.node_of_unknown, unknowns.n_interior);
    condensation.factorise();
    CondensedSection body;
    body.solid = problem.solid;
    body.along = surface.along;
    for (const int node : surface.nodes) body.x.push_back(problem.mesh.nodes[node][0]);
    body.edges = surface.edges;
    body.compliance = in_frames(problem, unknowns, surface, condensation.compliance());
    body.missing_reaction =
        missing_reaction(problem, unknowns, surface, condensation, std::move(stiffness.held_row));
    return body;
}

}  // namespace tricontact::fem::planar
