#include "fem/mortar/pressure_grid.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numeric>

#include "../box_mesh.h"
#include "contact/base/error.h"
#include "contact/solvers/normal_solver.h"
#include "fem/contact_surface.h"
#include "fem/mortar/overlap.h"
#include "fem/pair_compliance.h"

namespace tricontact::pressure_grid_test {
namespace {

using contact::Material;
using contact::TangentialField;
using fem::CondensedPart;
using test::even;

/// A block of 6 mm x 4 mm, all of its top the contact, whose inner nodes are moved about.
meshes::HexMesh block(int n_x, int n_y, double height, double moved) {
    test::BoxSpec spec{.x = even(-3e-3, 3e-3, n_x),
                       .y = even(-2e-3, 2e-3, n_y),
                       .z = even(-height, 0, 2),
                       .patch_x = 1,
                       .patch_y = 1};
    meshes::HexMesh mesh = test::box_mesh(spec);
    test::distort(mesh, moved);
    return mesh;
}

/// nu = 0 on a bonded base: a uniform pressure leaves a uniform state, u_z = p height/E.
CondensedPart condensed_block(meshes::HexMesh mesh, double young) {
    auto problem = std::make_shared<fem::LayerProblem>();
    problem->mesh = std::move(mesh);
    problem->materials = {Material{young, 0}, Material{young, 0}};
    fem::CondensedLayer layer = condense(*problem);
    return {problem, std::move(layer)};
}

struct Blocks {
    CondensedPart below = condensed_block(block(3, 2, 5e-3, .2e-3), 4e6);
    CondensedPart above = condensed_block(block(5, 3, 2e-3, -.2e-3), 1e6);
    contact::ContactPoints grid;
    double compliance = 5e-3 / 4e6 + 2e-3 / 1e6;  ///< u_z/p [m/Pa]

    explicit Blocks(double spacing = 1) {
        const std::vector<const contact::ContactPoints*> both{&below.layer.points,
                                                              &above.layer.points};
        const fem::Rectangle r = *fem::shared_rectangle(both);
        const double coarser = std::max(fem::node_spacing(below.layer.points, r),
                                        fem::node_spacing(above.layer.points, r));
        grid = fem::pressure_grid(r, spacing * coarser, false);
    }
    fem::PairCompliance pair() {
        for (CondensedPart* part : {&below, &above}) {
            part->transfer = fem::transfer_to(part->layer.points, grid);
            part->layer = fem::on_grid(part->layer, grid, *part->transfer);
        }
        return {std::move(below), std::move(above)};
    }
};

// Nodal forces of one mesh that are spread over the other's nodes fail this by tens of per cent.
TEST(FemPressureGrid, AUniformPressureCrossesMeshesThatDoNotMatch) {
    Blocks blocks;
    const fem::PairCompliance pair = blocks.pair();
    const std::size_t n = pair.points().size();
    ASSERT_GT(n, 20u);
    const std::vector<double> p(n, 3e4);
    std::vector<double> u(n);
    pair.normal(p, u);
    for (const double value : u) EXPECT_NEAR(value / (3e4 * blocks.compliance), 1, 1e-10);

    // Across: simple shear would need forces on the sides; what pressure does along is zero.
    TangentialField along(n);
    pair.tangential_from_normal(p, along);
    for (std::size_t i = 0; i < n; ++i)
        EXPECT_LT(std::hypot(along.x[i], along.y[i]), 1e-10 * 3e4 * blocks.compliance);
}

// The other way round: pressed as one by d, both transmit p = d/(u_z/p) everywhere.
TEST(FemPressureGrid, AUniformApproachLeavesAUniformPressure) {
    for (const double spacing : {1., 1.4}) {
        Blocks blocks(spacing);
        const fem::PairCompliance pair = blocks.pair();
        const std::vector<double> gap(pair.points().size(), 0);
        const auto pressed = contact::NormalSolver(pair, 1e-13)
                                 .solve(gap, {contact::NormalControl::Kind::indentation, 1e-5});
        for (const double p : pressed.pressure) EXPECT_NEAR(p * blocks.compliance / 1e-5, 1, 1e-10);
    }
}

// Forces on nodes have the resultant and the moments of the pressure.
TEST(FemPressureGrid, ForcesAndMomentsAreThoseOfThePressure) {
    const Blocks blocks;
    const auto& grid = blocks.grid;
    for (const CondensedPart* part : {&blocks.below, &blocks.above}) {
        const auto& points = part->layer.points;
        const auto transfer = fem::transfer_to(points, grid);
        double force = 0, moment = 0, whole = 0, whole_moment = 0;
        const auto p = [&](std::size_t k) { return 1 + std::sin(3. * static_cast<double>(k)); };
        for (const auto& [node, point, value] : transfer.entries) {
            force += value * p(point);
            moment += value * p(point) * points.x[node];
        }
        // int psi_k x dA over a cell pair is exact with the grid's own bilinear functions: x is
        // one.
        const auto own = [&](std::size_t k) {
            const auto i = k % grid.n_x;
            const double shift = i == 0 ? grid.spacing[0] / 3
                                 : i + 1 == static_cast<std::size_t>(grid.n_x)
                                     ? -grid.spacing[0] / 3
                                     : 0;
            return grid.x[k] + shift;
        };
        for (std::size_t k = 0; k < grid.size(); ++k) {
            whole += grid.area[k] * p(k);
            whole_moment += grid.area[k] * p(k) * own(k);
        }
        EXPECT_NEAR(force / whole, 1, 1e-12);
        EXPECT_NEAR(moment / whole_moment, 1, 1e-10);
    }
}

TEST(FemPressureGrid, TheMatrixIsSymmetricAndPositive) {
    Blocks blocks;
    const fem::PairCompliance pair = blocks.pair();
    const auto n = static_cast<Eigen::Index>(3 * pair.points().size());
    const Eigen::Map<const Eigen::MatrixXd> a(pair.dense(), n, n);
    EXPECT_LT((a - a.transpose()).norm(), 1e-13 * a.norm());
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(a).eigenvalues()[0], 0);
}

// Equilibrium of each body: what holds it carries the pressures and tractions on the grid.
TEST(FemPressureGrid, WhatHoldsTheBodiesCarriesTheTractions) {
    Blocks blocks;
    const fem::PairCompliance pair = blocks.pair();
    const std::size_t n = pair.points().size();
    std::vector<double> p(n);
    TangentialField t(n);
    double force = 0;
    for (std::size_t k = 0; k < n; ++k) {
        p[k] = 2e4 + 1e4 * std::sin(static_cast<double>(k));
        t.x[k] = 1e4 * std::cos(2. * static_cast<double>(k));
        force += pair.points().area[k] * p[k];
    }
    const auto missing = pair.missing_reaction(p, t);
    for (const double m : *missing) EXPECT_LT(std::abs(m), 1e-9 * force);
}

// Stress and displacement inside, of nodal forces M p.
TEST(FemPressureGrid, TheInsideIsThatOfThePressure) {
    Blocks blocks;
    const fem::PairCompliance pair = blocks.pair();
    const std::size_t n = pair.points().size();
    const auto inside = pair.interior(std::vector<double>(n, 3e4), TangentialField(n));
    for (const auto& stress : inside->stress) {
        EXPECT_NEAR(stress[2] / -3e4, 1, 1e-9);
        EXPECT_LT(std::abs(stress[0]), 1e-9 * 3e4);
    }
}

TEST(FemPressureGrid, ARectangleWithinARoundSurface) {
    contact::ContactPoints round;  // four faces of an octagon-like surface about the origin
    const auto add = [&](double x, double y) {
        round.x.push_back(x);
        round.y.push_back(y);
        return static_cast<int>(round.x.size()) - 1;
    };
    for (int q = 0; q < 4; ++q) {
        const auto turned = [&](double x, double y) {
            for (int k = 0; k < q; ++k) std::tie(x, y) = std::pair(-y, x);
            return add(x, y);
        };
        std::array<int, 9> quad{};
        quad[0] = turned(0, 0), quad[1] = turned(1, 0);
        quad[2] = turned(.75, .75), quad[3] = turned(0, 1);
        for (int k = 4; k < 9; ++k) quad[k] = quad[0];
        round.quads.push_back(quad);
    }
    const std::vector<const contact::ContactPoints*> one{&round};
    const auto r = fem::shared_rectangle(one);
    ASSERT_TRUE(r);
    EXPECT_NEAR(r->high[0], .75, 1e-6);  // rounding of areas, 1e-12: its root at a corner
    EXPECT_NEAR(fem::covered_area(round, *r), 2.25, 5e-6);
    EXPECT_NEAR(fem::covered_area(round, {{-2, -2}, {2, 2}}), 3, 1e-14);
    const auto wide = fem::pressure_grid({{-1, -1}, {1, 1}}, .5, false);
    EXPECT_THROW(fem::transfer_to(round, wide), contact::InputError);
}

TEST(FemPressureGrid, AFaceThatIsTurnedAwayIsRefused) {
    contact::ContactPoints surface;
    surface.x = {0, 0, 1, 1, 0, .5, 1, .5, .5};
    surface.y = {0, 1, 1, 0, .5, 1, .5, 0, .5};
    surface.quads = {{0, 1, 2, 3, 4, 5, 6, 7, 8}};
    try {
        fem::seen_faces(surface);
        FAIL();
    } catch (const contact::InputError& error) {
        EXPECT_NE(std::string(error.what()).find("does not face the other body"),
                  std::string::npos);
    }
}

}  // namespace
}  // namespace tricontact::pressure_grid_test
