// Solutions without a factor beside those by CHOLMOD's, of the same elements.

#include "fem/block/block_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "contact/base/error.h"
#include "meshes/layer_mesh.h"
#include "tests/unit/fem/layer_problems.h"

namespace tricontact::block_solver_test {
namespace {

using fem::BlockGrid;
using fem::BlockSolver;
using fem::LayerProblem;

/// Bricks of `size` in a patch of 8 mm x 4 mm (or 8 mm), graded beside and below it, on a layer of
/// another material.
LayerProblem graded_layer(double size, bool half_model = true) {
    LayerProblem problem;
    problem.mesh = meshes::make_layer_mesh({.size = size,
                                            .patch_x = 4e-3,
                                            .patch_y = 4e-3,
                                            .half_x = 20e-3,
                                            .half_y = 15e-3,
                                            .thickness = 5e-3,
                                            .lower_thickness = 3e-3,
                                            .half_model = half_model,
                                            .ends = {}});
    problem.materials = {contact::Material{2e6, .5}, contact::Material{5e6, .3}};
    return problem;
}

BlockGrid grid_of(const LayerProblem& problem) {
    std::string why;
    const auto grid = fem::block_grid(problem, why);
    EXPECT_TRUE(grid) << why;
    return *grid;
}

std::size_t node_at(const BlockGrid& grid, double x, double y) {
    return grid.nearest_node({x, y, grid.axes[2].planes.back()});
}

/// Largest difference of the patch's displacements under unit forces on one of its points, over
/// the largest displacement.
double difference_from_factor(const LayerProblem& problem) {
    const fem::CondensedLayer layer = condense(problem);
    const BlockGrid grid = grid_of(problem);
    BlockSolver solver(grid, 2);
    const std::size_t n = layer.points.size(), n_nodes = grid.n_nodes(), point = n / 2 + 3;
    double worst = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        std::vector<double> force(solver.mixed().size()), x;
        force[c * n_nodes + node_at(grid, layer.points.x[point], layer.points.y[point])] = 1;
        solver.solve(force, 1e-11, x);
        const double* const column = &layer.compliance[(c * n + point) * 3 * n];
        double difference = 0, largest = 0;
        for (std::size_t k = 0; k < 3 * n; ++k) {
            const std::size_t node = node_at(grid, layer.points.x[k % n], layer.points.y[k % n]);
            difference = std::max(difference, std::abs(x[k / n * n_nodes + node] - column[k]));
            largest = std::max(largest, std::abs(column[k]));
        }
        worst = std::max(worst, difference / largest);
    }
    return worst;
}

// 1e-8: rounding of the factor, K/G = 1e6 times epsilon.
TEST(BlockSolver, AgreesWithTheFactor) {
    EXPECT_LT(difference_from_factor(graded_layer(2e-3)), 1e-8);
}

TEST(BlockSolver, AgreesWithTheFactorOfAWholeBlockThatSlidesOnItsBase) {
    LayerProblem problem = graded_layer(2e-3, false);
    problem.base = contact::Case::Base::frictionless;
    problem.sides = fem::Sides::fixed;
    EXPECT_LT(difference_from_factor(problem), 1e-8);
}

int iterations(double size, double bulk_ratio) {
    LayerProblem problem = graded_layer(size);
    problem.materials[1] = problem.materials[0];
    problem.largest_bulk_ratio = bulk_ratio;
    const BlockGrid grid = grid_of(problem);
    BlockSolver solver(grid, 1);
    std::vector<double> force(solver.mixed().size()), x;
    // A pressure on the patch, the same on all meshes.
    const double radius = 3e-3, top = grid.axes[2].n_nodes() - 1;
    for (int j = 0; j < grid.axes[1].n_nodes(); ++j)
        for (int i = 0; i < grid.axes[0].n_nodes(); ++i) {
            const double r = std::hypot(grid.axes[0].node(i), grid.axes[1].node(j)) / radius;
            constexpr double simpson[2] = {1. / 3, 2. / 3};
            force[2 * grid.n_nodes() + grid.node(i, j, static_cast<int>(top))] =
                std::max(0., 1 - r * r) * size * size * simpson[i % 2] * simpson[j % 2];
        }
    return solver.solve(force, 1e-8, x);
}

// Neither incompressible material nor half and a quarter of the edge in the patch, with steeper
// grading beside it, is felt.
TEST(BlockSolverSlow, IterationsDependNeitherOnSizeNorOnBulkModulus) {
    std::vector<int> counts;
    for (const double size : {1e-3, .5e-3, .25e-3})
        for (const double ratio : {1e2, 1e15}) counts.push_back(iterations(size, ratio));
    counts.push_back(iterations(.5e-3, 1e6));
    const auto [least, most] = std::ranges::minmax(counts);
    EXPECT_LE(most - least, 4);  // 2 about their middle
    EXPECT_LE(most, 36);
}

TEST(BlockSolver, ThreadsChangeNoBit) {
    const BlockGrid grid = grid_of(graded_layer(2e-3));
    std::vector<double> one, two;
    for (auto* x : {&one, &two}) {
        BlockSolver solver(grid, x == &one ? 1 : 2);
        std::vector<double> force(solver.mixed().size());
        force[node_at(grid, 0, 0)] = 1;
        solver.solve(force, 1e-6, *x);
    }
    EXPECT_EQ(one, two);
}

TEST(BlockSolver, AnUnreachableToleranceIsNotConverged) {
    const BlockGrid grid = grid_of(graded_layer(4e-3));
    BlockSolver solver(grid, 1);
    std::vector<double> force(solver.mixed().size()), x;
    x.assign(force.size(), 1);
    EXPECT_EQ(solver.solve(force, 1e-8, x), 0);
    EXPECT_EQ(x, force);  // no forces, no displacements
    force[node_at(grid, 0, 0)] = 1;
    EXPECT_THROW(solver.solve(force, 1e-300, x), contact::NotConverged);
}

TEST(BlockGrid, OtherMeshesAreToldFromBricks) {
    std::string why;
    LayerProblem problem = graded_layer(4e-3);
    problem.mesh.nodes.back()[0] *= .9;
    EXPECT_FALSE(fem::block_grid(problem, why));
    EXPECT_NE(why.find("not bricks"), std::string::npos) << why;

    problem = graded_layer(4e-3);
    problem.sides = fem::Sides::fixed;
    for (auto& face : problem.mesh.faces)
        if (face.boundary == meshes::Boundary::sides) {
            face.boundary = meshes::Boundary::free_top;
            break;
        }
    EXPECT_FALSE(fem::block_grid(problem, why));
    EXPECT_NE(why.find("held in two ways"), std::string::npos) << why;
}

}  // namespace
}  // namespace tricontact::block_solver_test
