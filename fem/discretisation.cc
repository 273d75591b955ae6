#include "fem/discretisation.h"

#include "fem/assembly.h"
#include "fem/contact_surface.h"
#include "fem/interior_fields.h"
#include "fem/memory.h"
#include "fem/unknowns.h"

namespace tricontact::fem {

struct Discretisation::Parts {
    Q2Space space;
    std::array<Moduli, meshes::n_regions> moduli{};
    ContactSurface surface;
    Unknowns unknowns;

    explicit Parts(const LayerProblem& problem)
        : space(problem.mesh),
          surface(contact_surface(space)),
          unknowns(number_unknowns(space, surface.nodes, problem.base, problem.sides)) {
        for (std::size_t r = 0; r < moduli.size(); ++r)
            moduli[r] = moduli_of(problem.materials[r], problem.largest_bulk_ratio);
    }
};

Discretisation::Discretisation(const LayerProblem& problem)
    : parts_(std::make_unique<Parts>(problem)) {
    return_freed_memory();
}
Discretisation::~Discretisation() = default;

AssembledStiffness Discretisation::assemble() const {
    return fem::assemble(parts_->space, parts_->unknowns, parts_->moduli);
}
const std::vector<int>& Discretisation::node_of_unknown() const {
    return parts_->unknowns.node_of_unknown;
}
const std::vector<int>& Discretisation::direction_of_unknown() const {
    return parts_->unknowns.direction_of_unknown;
}
int Discretisation::n_unknowns() const {
    return parts_->unknowns.n;
}
int Discretisation::n_interior() const {
    return parts_->unknowns.n_interior;
}
const contact::ContactPoints& Discretisation::contact_points() const {
    return parts_->surface.points;
}
const std::vector<int>& Discretisation::contact_unknowns() const {
    return parts_->unknowns.of_contact;
}
const SparseMatrix& Discretisation::contact_mass() const {
    return parts_->surface.mass;
}

contact::Interior Discretisation::interior(std::span<const double> displacement,
                                           std::span<const double> force) const {
    const auto& [space, moduli, surface, unknowns] = *parts_;
    NodalDisplacement nodal(space.nodes().size(), {0, 0, 0});
    for (int u = 0; u < unknowns.n; ++u)
        nodal[unknowns.node_of_unknown[u]][unknowns.direction_of_unknown[u]] = displacement[u];
    auto interior = interior_fields(space, moduli, nodal);
    for (int u = 0; u < unknowns.n; ++u)
        interior.applied[unknowns.direction_of_unknown[u]] += force[u];
    interior.base_reaction = held_forces(space, unknowns, moduli, nodal);
    if (surface.points.mirrored) {
        interior.strain_energy *= 2;
        for (auto* total : {&interior.applied, &*interior.base_reaction})
            *total = {2 * (*total)[0], 0, 2 * (*total)[2]};  // y cancels
    }
    return interior;
}

}  // namespace tricontact::fem
