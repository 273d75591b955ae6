#include "fem/discretisation.h"

#include <algorithm>

#include "contact/error.h"
#include "fem/assembly.h"
#include "fem/contact_surface.h"
#include "fem/memory.h"

namespace tricontact::fem {

namespace {

using contact::Case;
using meshes::Boundary;
constexpr Directions none = 0, y_only = 2, z_only = 4, all = 7;

}  // namespace

Discretisation::Discretisation(const LayerProblem& problem)
    : space_(problem.mesh),
      surface_(contact_surface(space_)),
      unknowns_(number_unknowns(space_, surface_.nodes, problem.base, problem.sides)) {
    for (std::size_t r = 0; r < moduli_.size(); ++r)
        moduli_[r] = moduli_of(problem.materials[r], problem.largest_bulk_ratio);
    return_freed_memory();
}

AssembledStiffness Discretisation::assemble() const {
    return fem::assemble(space_, unknowns_, moduli_);
}

contact::Interior Discretisation::interior(std::span<const double> displacement,
                                           std::span<const double> force) const {
    NodalDisplacement nodal(space_.nodes().size(), {0, 0, 0});
    for (int u = 0; u < unknowns_.n; ++u)
        nodal[unknowns_.node_of_unknown[u]][unknowns_.direction_of_unknown[u]] = displacement[u];
    auto interior = interior_fields(space_, moduli_, nodal);
    for (int u = 0; u < unknowns_.n; ++u)
        interior.applied[unknowns_.direction_of_unknown[u]] += force[u];
    interior.base_reaction = held_forces(space_, unknowns_, moduli_, nodal);
    if (surface_.points.mirrored) {
        interior.strain_energy *= 2;
        for (auto* total : {&interior.applied, &*interior.base_reaction})
            *total = {2 * (*total)[0], 0, 2 * (*total)[2]};  // y cancels
    }
    return interior;
}

Directions held_on(Boundary boundary, Case::Base base, Case::Sides sides) {
    switch (boundary) {
        case Boundary::base:
            return base == Case::Base::bonded ? all : z_only;
        case Boundary::sides:
            return sides == Case::Sides::fixed ? all : none;
        case Boundary::symmetry:
            return y_only;
        case Boundary::contact:
        case Boundary::free_top:
            return none;
    }
    return none;
}

void refuse_rigid_motions(bool has_base, bool has_sides, Case::Base base, Case::Sides sides) {
    if (sides == Case::Sides::fixed && has_sides) return;
    if (!has_base)
        throw contact::InputError(
            "mesh: nothing holds the layer; name the faces on the ground \"base\"");
    if (base == Case::Base::frictionless)
        throw contact::InputError(
            "substrate.base: nothing holds a layer with free sides on a frictionless base against "
            "sliding; choose fem.sides = \"fixed\"");
}

Unknowns number_unknowns(const Q2Space& space, const std::vector<int>& contact_nodes,
                         Case::Base base, Case::Sides sides) {
    const auto has = [&](Boundary boundary) {
        return std::ranges::any_of(space.faces(),
                                   [&](const auto& face) { return face.boundary == boundary; });
    };
    refuse_rigid_motions(has(Boundary::base), has(Boundary::sides), base, sides);
    std::vector<Directions> held(space.nodes().size(), none);
    for (const auto& face : space.faces())
        for (const int node : face.nodes) held[node] |= held_on(face.boundary, base, sides);
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

}  // namespace tricontact::fem
