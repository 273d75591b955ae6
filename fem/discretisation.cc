#include "fem/discretisation.h"

#include <algorithm>
#include <cmath>

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
// z points out of the substrate in this room, into it in contact/ (condensed_compliance.cc changes
// the signs of the cross blocks).

namespace tricontact::fem {

namespace {

using contact::Case;
using meshes::Boundary;
constexpr Directions none = 0, y_only = 2, z_only = 4, all = 7;

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

int pinned_node(const Q2Space& space) {
    int nearest = -1;
    const auto distance = [&](int node) {
        return std::hypot(space.nodes[node][0], space.nodes[node][1]);
    };
    for (const auto& face : space.faces)
        if (face.boundary == Boundary::base)
            for (const int node : face.nodes)
                if (nearest < 0 || distance(node) < distance(nearest)) nearest = node;
    if (nearest < 0) throw contact::InputError("mesh: a pinned body without a base");
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
    if (!problem.pinned)
        refuse_rigid_motions(has(Boundary::base), has(Boundary::sides), base, sides);
    std::vector<Directions> held(space.nodes.size(), none);
    for (const auto& face : space.faces)
        for (const int node : face.nodes) held[node] |= held_on(face.boundary, base, sides);
    if (problem.pinned) held[pinned_node(space)] = all;
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

}  // namespace

Discretisation::Discretisation(const LayerProblem& problem)
    : space(problem.mesh),
      surface(contact_surface(space)),
      unknowns(number_unknowns(space, surface.nodes, problem)) {
    for (std::size_t r = 0; r < moduli.size(); ++r)
        moduli[r] = moduli_of(problem.materials[r], problem.largest_bulk_ratio);
    return_freed_memory();
}

}  // namespace tricontact::fem
