// Bodies that a pressure presses on their base, with no hold but the contact.

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "fem/condensed_body.h"
#include "tests/unit/fem/box_mesh.h"

namespace tricontact::fem::loose_body_test {
namespace {

constexpr double young = 2e6, half_side = 4e-3, height = 5e-3;

LayerProblem block(double patch, double poisson) {
    LayerProblem problem;
    problem.mesh = test::box_mesh({.x = test::mirrored(test::even(0, half_side, 3)),
                                   .y = test::even(0, half_side, 2),
                                   .z = test::even(-height, 0, 3),
                                   .patch_x = patch,
                                   .patch_y = patch,
                                   .half_model = true});
    problem.materials.fill({young, poisson});
    problem.pressed_evenly = true;
    return problem;
}

// Under the same pressure on both faces stresses are uniform: the faces approach by p h/E, counted
// from the base, and the energy is p^2/(2 E) of the volume. 1e-8: rounding, times K/G.
TEST(FemLooseBody, EvenPressureCompressesEvenly) {
    for (const double poisson : {.3, .495}) {
        const auto problem = std::make_shared<const LayerProblem>(block(half_side, poisson));
        const CondensedLayer layer = condense(*problem);
        const std::size_t n = layer.points.size();
        constexpr double p = 3e4;
        std::vector<double> u(3 * n, 0);
        for (std::size_t c = 0; c < n; ++c)  // areas count both halves
            for (std::size_t r = 0; r < 3 * n; ++r)
                u[r] -= layer.compliance[(2 * n + c) * 3 * n + r] * p * layer.points.area[c] / 2;
        for (std::size_t i = 0; i < n; ++i) {
            EXPECT_NEAR(u[2 * n + i] * young / (p * height), -1, 1e-8);
            EXPECT_NEAR(u[i] * young / p, poisson * layer.points.x[i], 1e-8 * half_side);
        }
        const CondensedBody body(problem, layer.missing_reaction);
        const auto inside =
            body.interior(layer.points, std::vector<double>(n, p), contact::TangentialField(n));
        for (const auto& s : inside.stress) {
            EXPECT_NEAR(s[2] / p, -1, 1e-7);
            EXPECT_NEAR(s[0] / p, 0, 1e-7);
        }
        const double area = 4 * half_side * half_side;
        EXPECT_NEAR(inside.strain_energy / (p * p * area * height / (2 * young)), 1, 1e-8);
        EXPECT_NEAR(inside.applied[2] / (p * area), -1, 1e-9);
        EXPECT_NEAR((*inside.base_reaction)[2] / (p * area), 1, 1e-7);
        // What the node that is held carries is its part of the pressure.
        EXPECT_LT(std::abs(body.missing_reaction(layer.points, std::vector<double>(n, p),
                                                 contact::TangentialField(n))[2]),
                  body.allowed_missing_reaction(layer.points) * p * area);
    }
}

// Betti: the mean displacement of the base under any load of the contact is zero, and a uniform
// pressure on the contact alone displaces it by the mean of what the load does; so the compliance
// is symmetric, and a rigid motion costs nothing.
TEST(FemLooseBody, ComplianceIsSymmetric) {
    const CondensedLayer layer = condense(block(half_side / 2, .3));
    const std::size_t n = 3 * layer.points.size();
    double most = 0;
    for (const double c : layer.compliance) most = std::max(most, std::abs(c));
    for (std::size_t c = 0; c < n; ++c) {
        EXPECT_GE(layer.compliance[c * n + c], 0);
        for (std::size_t r = 0; r < c; ++r)
            EXPECT_NEAR(layer.compliance[c * n + r], layer.compliance[r * n + c], 1e-10 * most);
    }
}

}  // namespace
}  // namespace tricontact::fem::loose_body_test
