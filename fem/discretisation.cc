#include "fem/discretisation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "contact/base/error.h"
#include "fem/memory.h"
#include "fem/settings.h"

// Numbering of unknowns, docs/explanation/models/fem.md. Held components have no number, so that no
// row of the matrix is a condition. Boundary conditions by the face a node lies on; a node on two
// faces is held in what either of them holds:
//
//   base       bonded: x, y, z      frictionless: z
//   sides      free: none           held: x, y, z
//   symmetry   y
//
// The base of a body that is pressed evenly is free, but for one node along z.
//
// z points out of the substrate in this room, into it in contact/ (condensed_compliance.cc changes
// the signs of the cross blocks).

namespace tricontact::fem {

namespace {

using contact::Case;
using meshes::Boundary;
constexpr Directions none = 0, x_only = 1, y_only = 2, z_only = 4, all = 7;

}  // namespace

Directions held_on(Boundary boundary, Case::Base base, Sides sides) {
    switch (boundary) {
        case Boundary::base:
            return base == Case::Base::bonded ? all : z_only;
        case Boundary::sides:
            return sides == Sides::fixed ? all : none;
        case Boundary::symmetry:
            return y_only;
        case Boundary::contact:
        case Boundary::free_top:
            return none;
    }
    return none;
}

void refuse_rigid_motions(bool has_base, bool has_sides, Case::Base base, Sides sides) {
    if (sides == Sides::fixed && has_sides) return;
    if (!has_base)
        throw contact::InputError(
            "mesh: nothing holds the layer; name the faces on the ground \"base\"");
    if (base == Case::Base::frictionless)
        throw contact::InputError(
            "substrate.base: nothing holds a layer with free sides on a frictionless base against "
            "sliding; choose fem.sides = \"fixed\"");
}

namespace {

/// The node of the base that is the nearest to the axis z; the first of several.
int middle_of_base(const Q2Space& space) {
    int nearest = -1;
    const auto distance = [&](int node) {
        return std::hypot(space.nodes[node][0], space.nodes[node][1]);
    };
    for (const auto& face : space.faces)
        if (face.boundary == Boundary::base)
            for (const int node : face.nodes)
                if (nearest < 0 || distance(node) < distance(nearest)) nearest = node;
    if (nearest < 0)
        throw contact::InputError("mesh: nothing presses the body; name its loaded faces \"base\"");
    return nearest;
}

// Contact unknowns come by direction, x of all nodes, then y, then z: the blocks of the compliance
// are then contiguous. Those of the interior come node by node, in which order does not matter:
// dissection_order() finds a better one.
Unknowns number_unknowns(const Q2Space& space, const std::vector<int>& contact_nodes,
                         const LayerProblem& problem) {
    const auto [base, sides] = std::pair(problem.base, problem.sides);
    const auto has = [&](Boundary boundary) {
        return std::ranges::any_of(space.faces,
                                   [&](const auto& face) { return face.boundary == boundary; });
    };
    if (!problem.needs_symmetry())
        refuse_rigid_motions(has(Boundary::base), has(Boundary::sides), base, sides);
    std::vector<Directions> held(space.nodes.size(), none);
    for (const auto& face : space.faces)
        for (const int node : face.nodes)
            if (face.boundary != Boundary::base || !problem.pressed_evenly)
                held[node] |= held_on(face.boundary, base, sides);
    if (problem.pressed_evenly) held[middle_of_base(space)] |= z_only;
    std::vector<bool> in_contact(held.size(), false);
    for (const int node : contact_nodes) in_contact[node] = true;

    Unknowns unknowns;
    unknowns.of_node.assign(held.size(), {-1, -1, -1});
    const auto add = [&](int node, int c) {
        if (held[node] >> c & 1) return -1;
        unknowns.node_of_unknown.push_back(node);
        unknowns.direction_of_unknown.push_back(c);
        return unknowns.of_node[node][c] = unknowns.n++;
    };
    for (int node = 0; node < static_cast<int>(held.size()); ++node)
        if (!in_contact[node])
            for (int c = 0; c < 3; ++c) add(node, c);
    unknowns.n_interior = unknowns.n;
    for (int c = 0; c < 3; ++c)
        for (const int node : contact_nodes) {
            const int unknown = add(node, c);
            unknowns.of_contact.push_back(unknown < 0 ? -1 : unknown - unknowns.n_interior);
        }
    return unknowns;
}

std::vector<Directions> on_base(const Q2Space& space, Directions directions) {
    std::vector<Directions> held(space.nodes.size(), none);
    for (const auto& face : space.faces)
        if (face.boundary == Boundary::base)
            for (const int node : face.nodes) held[node] = directions;
    return held;
}

std::vector<double> even_load_on_base(const Q2Space& space, const Unknowns& unknowns) {
    std::vector<double> load(unknowns.n, 0);
    double whole = 0;
    for (std::size_t f = 0; f < space.faces.size(); ++f) {
        if (space.faces[f].boundary != Boundary::base) continue;
        const auto mass = space.face_mass(f);
        for (std::size_t i = 0; i < mass.size(); ++i) {
            const double area = std::accumulate(mass[i].begin(), mass[i].end(), 0.);
            whole += area;
            if (const int u = unknowns.of_node[space.faces[f].nodes[i]][2]; u >= 0) load[u] += area;
        }
    }
    for (double& force : load) force /= whole;
    return load;
}

}  // namespace

Discretisation::Discretisation(const LayerProblem& problem, Elements elements)
    : space(problem.mesh, elements),
      surface(contact_surface(space)),
      unknowns(number_unknowns(space, surface.nodes, problem)) {
    if (problem.needs_symmetry())
        held_if_odd = on_base(space, problem.pressed_evenly ? x_only | z_only : x_only);
    if (problem.pressed_evenly) even_load = even_load_on_base(space, unknowns);
    for (std::size_t r = 0; r < moduli.size(); ++r)
        moduli[r] = moduli_of(problem.materials[r], problem.largest_bulk_ratio);
    return_freed_memory();
}

}  // namespace tricontact::fem
