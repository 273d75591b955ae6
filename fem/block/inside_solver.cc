#include "fem/block/inside_solver.h"

#include <memory>

#include "fem/block/block_solver.h"

namespace tricontact::fem {

namespace {

/// Of the forces. Stresses are K times dilatations of which K/G = 1e6 leaves six digits fewer: they
/// have a factor's digits, those of files in single precision.
constexpr double inside_tolerance = 1e-13;

}  // namespace

InsideSolver block_inside_solver(const LayerProblem& problem, const Discretisation& body) {
    if (problem.needs_symmetry() || problem.line_length > 0) return {};
    std::string why;
    const auto grid = block_grid(problem, why);
    if (!grid) return {};
    const auto solver = std::make_shared<BlockSolver>(*grid, 1);
    return [solver, places = places_in_block(body, *grid)](std::span<const double> forces) {
        std::vector<double> on_block(solver->mixed().size()), moved, displacement;
        for (std::size_t u = 0; u < places.size(); ++u) on_block[places[u]] = forces[u];
        solver->solve(on_block, inside_tolerance, moved);
        displacement.reserve(places.size());
        for (const std::size_t at : places) displacement.push_back(moved[at]);
        return displacement;
    };
}

}  // namespace tricontact::fem
