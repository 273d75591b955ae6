#include "fem/planar/section_unknowns.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "contact/base/error.h"

namespace tricontact::fem::planar {

namespace {

double coordinate(const BodyProblem& problem, const Point& x) {
    if (problem.frame == Frame::plane) return x[0];
    return problem.radius * std::atan2(x[0], problem.radius - x[1]);
}

/// Node of this boundary that is nearest to x = 0; -1 without one.
int middle_of(const Mesh& mesh, Boundary wanted) {
    int nearest = -1;
    for (const auto& [nodes, boundary] : mesh.edges) {
        if (boundary != wanted) continue;
        for (const int node : nodes)
            if (nearest < 0 || std::abs(mesh.nodes[node][0]) < std::abs(mesh.nodes[nearest][0]))
                nearest = node;
    }
    return nearest;
}

/// By node and direction, whether it is held. A whole section in plane strain whose support does
/// not hold it along x is held there by one node, in the middle; what is loose could also turn, and
/// is held along x in the middle of the contact. Symmetric loads have no reactions there.
std::vector<std::array<bool, 2>> held_of(const BodyProblem& problem) {
    const auto& [nodes, cells, edges] = problem.mesh;
    std::vector<std::array<bool, 2>> held(nodes.size(), {false, false});
    bool has_symmetry = problem.solid == Solid::of_revolution;
    for (const auto& [on_edge, boundary] : edges) {
        has_symmetry = has_symmetry || boundary == Boundary::symmetry;
        for (const int node : on_edge) {
            if (boundary == Boundary::symmetry) held[node][0] = true;
            if (boundary != Boundary::support) continue;
            held[node][0] = held[node][0] || problem.support == Support::bonded ||
                            problem.support == Support::opposite;
            held[node][1] = held[node][1] || !is_loose(problem.support);
        }
    }
    if (const int middle = middle_of(problem.mesh, Boundary::support); middle >= 0) {
        held[middle][0] = held[middle][0] || !has_symmetry;
        held[middle][1] = true;
    }
    const int touching = middle_of(problem.mesh, Boundary::contact);
    if (is_loose(problem.support) && !has_symmetry) held[touching][0] = true;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (problem.solid == Solid::of_revolution && nodes[i][0] == 0) held[i][0] = true;
    return held;
}

}  // namespace

SectionSurface surface_of(const BodyProblem& problem) {
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
    SectionSurface surface;
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

SectionUnknowns number_unknowns(const BodyProblem& problem, const SectionSurface& surface) {
    const auto held = held_of(problem);
    std::vector<bool> touches(held.size(), false);
    for (const int node : surface.nodes) touches[node] = true;
    SectionUnknowns unknowns;
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

std::array<Point, 2> frame_at(const BodyProblem& problem, double along) {
    const double angle = problem.frame == Frame::plane ? 0 : along / problem.radius;
    return {{{std::cos(angle), std::sin(angle)}, {std::sin(angle), -std::cos(angle)}}};
}

}  // namespace tricontact::fem::planar
