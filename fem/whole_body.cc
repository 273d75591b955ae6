#include "fem/whole_body.h"

#include "contact/base/error.h"
#include "fem/memory.h"
#include "fem/one_blas_thread.h"

namespace tricontact::fem {

namespace {

/// Of the forces. Pressures are K times a dilatation that K/G = 1e6 leaves 6 digits of: stresses
/// have the digits of a factor's, displacements more than are written.
constexpr double inside_tolerance = 1e-13;

}  // namespace

WholeBody::Block::Block(const Discretisation& body, const BlockGrid& grid)
    : solver(grid, 1), places(places_in_block(body, grid)) {}

std::vector<double> WholeBody::Block::displacement(std::span<const double> forces) {
    std::vector<double> on_block(solver.mixed().size()), moved, displacement;
    for (std::size_t u = 0; u < places.size(); ++u) on_block[places[u]] = forces[u];
    solver.solve(on_block, inside_tolerance, moved);
    displacement.reserve(places.size());
    for (const std::size_t at : places) displacement.push_back(moved[at]);
    return displacement;
}

std::optional<WholeBody::Block> WholeBody::block_of(const LayerProblem& problem,
                                                    const Discretisation& body) {
    if (problem.needs_symmetry() || problem.line_length > 0) return std::nullopt;
    std::string why;
    const auto grid = block_grid(problem, why);
    if (!grid) return std::nullopt;
    return Block(body, *grid);
}

WholeBody::WholeBody(const LayerProblem& problem, Solution solution)
    : discretisation(problem),
      block_(solution == Solution::block ? block_of(problem, discretisation) : std::nullopt) {
    if (!block_) parts_ = parts_of(discretisation, Elimination::cheapest);
}

std::vector<double> WholeBody::displacement(std::span<const double> applied) {
    if (block_) try {
            return block_->displacement(applied);
        } catch (const contact::NotConverged&) {
            block_.reset();  // the factor has the answer
            parts_ = parts_of(discretisation, Elimination::cheapest);
        }
    return by_factor(applied);
}

/// With the pressure on the base of a body that is pressed evenly.
std::vector<double> WholeBody::balanced(std::span<const double> applied) const {
    std::vector<double> forces(applied.begin(), applied.end());
    if (discretisation.even_load.empty()) return forces;
    double along_z = 0;
    for (std::size_t u = 0; u < forces.size(); ++u)
        if (discretisation.unknowns.direction_of_unknown[u] == 2) along_z += forces[u];
    for (std::size_t u = 0; u < forces.size(); ++u)
        forces[u] -= along_z * discretisation.even_load[u];
    return forces;
}

std::vector<double> WholeBody::by_factor(std::span<const double> applied) {
    const FreedMemoryStays stays;
    const OneBlasThread one_thread;
    const std::vector<double> forces = balanced(applied);
    std::vector<double> sum(forces.size(), 0.);
    for (BodyPart& part : parts_) {
        if (!part.condensation.is_factorised()) part.condensation.factorise();
        part.add_displacement(forces, sum);
        if (!was_asked_) part.condensation.forget_factor();
    }
    was_asked_ = true;
    return sum;
}

}  // namespace tricontact::fem
