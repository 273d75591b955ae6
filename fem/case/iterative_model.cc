#include "fem/case/iterative_model.h"

#include <fmt/format.h>

#include "contact/models/model_kind.h"
#include "fem/block/block_model.h"
#include "fem/case/layer_condenser.h"
#include "fem/memory.h"
#include "fem/settings.h"

// docs/explanation/models/fem.md, "Without a factor".

namespace tricontact::fem {

namespace {

using contact::Case;

/// Of solutions, over the contact's tolerance.
constexpr double of_contact_tolerance = .03;
constexpr double mesh_bytes = 4000;  // of an element: what deal.II keeps while nodes are numbered

/// Below this many nodes threads wait longer than they work.
constexpr std::size_t worth_threads = 60000;

double bytes_of(const BlockGrid& grid, const meshes::LayerMeshSpec& spec) {
    contact::ContactPoints patch;
    patch.n_x = static_cast<int>(4 * spec.patch_x / spec.size + 1.5);
    patch.n_y = static_cast<int>((spec.half_model ? 2 : 4) * spec.patch_y / spec.size + 1.5);
    patch.mirrored = spec.half_model;
    patch.spacing = {spec.size / 2, spec.size / 2};
    return BlockCompliance::bytes(grid) + LatticeCompliance::bytes(grid, patch) +
           mesh_bytes * static_cast<double>(grid.n_elements());
}

/// The dense compliance alone, without an analysis of the factor.
bool patch_fits(const meshes::LayerMeshSpec& spec) {
    const double n = 3 * (4 * spec.patch_x / spec.size + 1) *
                     ((spec.half_model ? 2 : 4) * spec.patch_y / spec.size + 1);
    return 8 * n * n < available_bytes();
}

}  // namespace

std::unique_ptr<contact::Model> make_iterative(const Case& c, const meshes::LayerMeshSpec& spec,
                                               int n_threads, const Say& say) {
    auto problem = std::make_shared<const LayerProblem>(problem_of(c, make_layer_mesh(spec)));
    std::string why;
    const auto grid = block_grid(*problem, why);
    if (!grid)
        throw contact::InputError(
            "fem.solver: the mesh does not suit the iterative "
            "solver: " +
            why);
    const double needed = bytes_of(*grid, spec), available = available_bytes();
    if (needed > available)
        throw contact::InputError(
            fmt::format("fem: the layer's displacements need {:.1f} GB of memory even by the "
                        "iterative solver, {:.1f} GB are there; choose a larger fem.size",
                        needed / 1e9, available / 1e9));
    if (grid->n_nodes() < worth_threads) n_threads = 1;
    const double tolerance = c.of<Settings>().tolerance;
    BlockElasticity elasticity;
    elasticity.block = std::make_shared<BlockCompliance>(
        std::move(problem), *grid, of_contact_tolerance * tolerance, n_threads);
    elasticity.lattice =
        std::make_shared<const LatticeCompliance>(*grid, elasticity.block->points(), n_threads);
    if (say)
        say(
            fmt::format("fem: layer of {} elements, {} unknowns, solved for by iteration: {:.2f} "
                        "GB",
                        grid->n_elements(), 3 * grid->n_nodes(), needed / 1e9));
    return std::make_unique<BlockModel>(contact::models::fem, std::move(elasticity),
                                        c.make_indenter(), c.friction.law(), tolerance, c.contact);
}

std::unique_ptr<contact::Model> by_solver(
    const Case& c, const meshes::LayerMeshSpec& spec, int n_threads, const Say& say,
    const std::function<std::unique_ptr<contact::Model>()>& direct) {
    const Solver solver = c.of<Settings>().solver;
    if (solver == Solver::direct || !not_iterative(c).empty()) return direct();
    const auto iterative = [&] { return make_iterative(c, spec, n_threads, say); };
    if (solver == Solver::iterative || !patch_fits(spec)) return iterative();
    try {
        return direct();
    } catch (const MemoryShort& shortage) {
        if (say)
            say(fmt::format(
                "fem: a factor needs {} of memory, {:.1f} GB are there: solved for by "
                "iteration",
                shortage.needed_bytes > 0 ? fmt::format("{:.1f} GB", shortage.needed_bytes / 1e9)
                                          : "more",
                shortage.available_bytes / 1e9));
    }
    return iterative();
}

}  // namespace tricontact::fem
