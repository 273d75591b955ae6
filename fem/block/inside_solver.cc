#include "fem/block/inside_solver.h"

#include <memory>

#include "fem/block/block_solver.h"

namespace tricontact::fem {

namespace {

constexpr double inside_tolerance = 1e-11;  // of the forces

}  // namespace

BodyState state_in_block(const MixedOperator& mixed, std::span<const double> x,
                         std::span<const std::size_t> places,
                         std::span<const std::size_t> elements) {
    BodyState state;
    state.displacement.reserve(places.size());
    for (const std::size_t at : places) state.displacement.push_back(x[at]);
    state.pressure.reserve(elements.size());
    for (const std::size_t e : elements) state.pressure.push_back(mixed.pressure(x, e));
    state.held_forces = mixed.held_forces(x);
    return state;
}

InsideSolver block_inside_solver(const LayerProblem& problem, const Discretisation& body) {
    if (problem.needs_symmetry() || problem.line_length > 0) return {};
    std::string why;
    const auto grid = block_grid(problem, why);
    if (!grid) return {};
    const auto solver = std::make_shared<BlockSolver>(*grid, 1);
    return [solver, places = places_in_block(body, *grid),
            elements = elements_in_block(body, *grid)](std::span<const double> forces) {
        std::vector<double> on_block(solver->mixed().size()), x;
        for (std::size_t u = 0; u < places.size(); ++u) on_block[places[u]] = forces[u];
        solver->solve(on_block, inside_tolerance, x);
        return state_in_block(solver->mixed(), x, places, elements);
    };
}

}  // namespace tricontact::fem
