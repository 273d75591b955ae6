#include "fem/discretisation.h"

#include <gtest/gtest.h>

#include <functional>

#include "contact/base/error.h"
#include "fem/settings.h"
#include "tests/unit/fem/layer_problems.h"

namespace tricontact::discretisation_test {
namespace {

using contact::Case;
using fem::Discretisation;

std::string refusal(const fem::LayerProblem& problem) {
    try {
        const Discretisation discretisation(problem);
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "";
}

TEST(FemDiscretisation, ContactUnknownsComeLastByDirection) {
    const auto problem = test::small_layer();
    const Discretisation layer(problem);
    const int n = static_cast<int>(layer.surface.points.size());
    EXPECT_EQ(layer.surface.points.n_x, 5);
    EXPECT_EQ(layer.surface.points.n_y, 9);
    ASSERT_EQ(layer.unknowns.n - layer.unknowns.n_interior, 3 * n);
    // 4 x 6 x 3 elements: nodes above the base.
    EXPECT_EQ(layer.unknowns.n, 3 * 9 * 13 * 6);
    const auto& unknowns = layer.unknowns.of_contact;
    for (int i = 0; i < 3 * n; ++i) {
        EXPECT_EQ(unknowns[i], i);
        EXPECT_EQ(layer.unknowns.direction_of_unknown[layer.unknowns.n_interior + i], i / n);
        EXPECT_EQ(layer.unknowns.node_of_unknown[layer.unknowns.n_interior + i],
                  layer.unknowns.node_of_unknown[layer.unknowns.n_interior + i % n]);
    }
}

TEST(FemDiscretisation, SymmetryPlaneHoldsYOnly) {
    const Discretisation layer(test::small_layer(true));
    const auto& points = layer.surface.points;
    const int n = static_cast<int>(points.size());
    int n_held = 0;
    for (int i = 0; i < n; ++i) {
        EXPECT_GE(layer.unknowns.of_contact[i], 0);
        EXPECT_GE(layer.unknowns.of_contact[2 * n + i], 0);
        const bool held = layer.unknowns.of_contact[n + i] < 0;
        EXPECT_EQ(held, points.y[i] == 0);
        n_held += held;
    }
    EXPECT_EQ(n_held, 5);  // two elements of 1.5 mm in |x| < 2 mm
    EXPECT_EQ(layer.unknowns.n, 3 * 9 * 7 * 6 - 9 * 6);
}

TEST(FemDiscretisation, BaseAndSidesHoldWhatTheySay) {
    auto problem = test::small_layer();
    problem.sides = fem::Sides::fixed;
    EXPECT_EQ(Discretisation(problem).unknowns.n, 3 * 7 * 11 * 6);
    problem.base = Case::Base::frictionless;  // x and y of the base are free as well
    EXPECT_EQ(Discretisation(problem).unknowns.n, 3 * 7 * 11 * 6 + 2 * 7 * 11);
}

TEST(FemDiscretisation, RigidMotionsAreRefused) {
    auto problem = test::small_layer(true);
    problem.base = Case::Base::frictionless;
    EXPECT_NE(refusal(problem).find("fem.sides = \"fixed\""), std::string::npos);
    for (auto& face : problem.mesh.faces)
        if (face.boundary == meshes::Boundary::base) face.boundary = meshes::Boundary::sides;
    EXPECT_NE(refusal(problem).find("nothing holds the layer"), std::string::npos);
    problem.sides = fem::Sides::fixed;
    EXPECT_EQ(refusal(problem), "");
}

TEST(FemDiscretisation, StiffnessIsPositiveDefiniteForEveryMaterial) {
    for (const double nu : {-.9, -.3, 0., .3, .5}) {
        auto problem = test::small_layer(true);
        problem.materials = {contact::Material{2e6, nu}, contact::Material{2e6, nu}};
        const auto matrix = test::dense(Discretisation(problem).assemble().matrix);
        EXPECT_EQ(matrix.llt().info(), Eigen::Success) << nu;
    }
}

// Held components move with the free ones: no force at all.
TEST(FemDiscretisation, HeldRowsBalanceTranslations) {
    const Discretisation layer(test::small_layer(true));
    const auto [sparse, held_rows] = layer.assemble();
    const auto matrix = test::dense(sparse);
    for (int d = 0; d < 3; ++d) {
        Eigen::VectorXd moved(layer.unknowns.n);
        for (int u = 0; u < moved.size(); ++u)
            moved[u] = layer.unknowns.direction_of_unknown[u] == d;
        const Eigen::VectorXd forces = matrix * moved;
        const Eigen::Map<const Eigen::VectorXd> held(held_rows[d].data(), moved.size());
        EXPECT_GT(held.norm(), 2e6 * 1e-3);  // shear modulus of the lower layer times a length
        EXPECT_LT((forces + held).norm(), 1e-14 * matrix.diagonal().norm()) << d;  // rounding
    }
}

}  // namespace
}  // namespace tricontact::discretisation_test
