#include "fem/body_parts.h"

#include <gtest/gtest.h>

#include "fem/block/inside_solver.h"
#include "fem/mirror_symmetry.h"
#include "fem/settings.h"
#include "fem/whole_body.h"
#include "tests/unit/fem/layer_problems.h"

namespace tricontact::body_parts_test {
namespace {

using Eigen::MatrixXd;
using fem::Discretisation;
using meshes::Boundary;

// Of two factors of stiffnesses whose entries are K/G = 1e6 times what they resist with.
constexpr double rounding = 1e-9;

// A block over x from 1 mm to 7 mm on a layer of another material, its inside bulging, and an even
// number of elements along x.
fem::LayerProblem mirrored_layer(bool half_model, double patch = 2e-3) {
    fem::LayerProblem problem;
    const auto along_y = test::even(0, 3e-3, 2);
    problem.mesh = test::box_mesh({test::even(-3e-3, 3e-3, 4),
                                   half_model ? along_y : test::mirrored(along_y),
                                   {-2.5e-3, -1.2e-3, -.5e-3, 0},
                                   patch,
                                   2e-3,
                                   half_model,
                                   -1.2e-3});
    for (auto& [x, y, z] : problem.mesh.nodes) {
        const double bulge = (9e-6 - x * x) * y * (z + 2.5e-3) * z;  // [m^5]
        z += 2e9 * bulge;
        x += 1e9 * x * bulge / 1e-3;
        x += 4e-3;
    }
    problem.materials = {contact::Material{2e6, .5}, contact::Material{5e6, .3}};
    return problem;
}

// By one factor of all of the body's stiffness.
fem::Condensation factor_of(const Discretisation& layer) {
    fem::Condensation condensation(layer.assemble().matrix, layer.unknowns.node_of_unknown,
                                   layer.unknowns.n_interior);
    condensation.factorise();
    return condensation;
}

void expect_condensed(const fem::LayerProblem& problem) {
    const Discretisation layer(problem);
    const fem::Condensation reference = factor_of(layer);
    const auto& unknown = layer.unknowns.of_contact;
    const auto n = static_cast<Eigen::Index>(unknown.size());
    const auto n_free = static_cast<Eigen::Index>(reference.contact().size());
    const auto of_unknowns = reference.compliance();
    MatrixXd expected = MatrixXd::Zero(n, n);
    for (Eigen::Index c = 0; c < n; ++c)
        for (Eigen::Index r = 0; r < n; ++r)
            if (unknown[c] >= 0 && unknown[r] >= 0)
                expected(r, c) = of_unknowns[unknown[c] * n_free + unknown[r]];
    const fem::CondensedLayer condensed = fem::condense(problem);
    const Eigen::Map<const MatrixXd> compliance(condensed.compliance.data(), n, n);
    EXPECT_LT((compliance - expected).norm(), rounding * expected.norm());
    EXPECT_EQ(MatrixXd(compliance), compliance.transpose());
    EXPECT_LT(condensed.reaction_error(), 1e-8);
    EXPECT_GT(condensed.reaction_error(), 0);
}

// Forces on all unknowns, of no symmetry.
void expect_solved(const fem::LayerProblem& problem) {
    fem::WholeBody body(problem);
    std::vector<double> forces(body.discretisation.unknowns.n);
    for (std::size_t u = 0; u < forces.size(); ++u)
        forces[u] = std::sin(static_cast<double>(u * u) + .5);
    const auto found = body.state(forces).displacement;
    const auto expected = factor_of(body.discretisation).solve(forces);
    double off = 0, size = 0;
    for (std::size_t u = 0; u < forces.size(); ++u) {
        off = std::hypot(off, found[u] - expected[u]);
        size = std::hypot(size, expected[u]);
    }
    EXPECT_LT(off, rounding * size);
    EXPECT_EQ(body.state(forces).displacement, found);  // factors are kept or not
    EXPECT_EQ(body.state(forces).displacement, found);
}

std::vector<fem::BodyPart> parts_of(const Discretisation& layer) {
    return fem::parts_of(layer, fem::Elimination::contact_last);
}

std::vector<fem::LayerProblem> mirrored_layers() {
    std::vector<fem::LayerProblem> problems;
    for (const bool half : {false, true}) {
        problems.push_back(mirrored_layer(half));
        problems.push_back(mirrored_layer(half));
        problems.back().base = contact::Case::Base::frictionless;
        problems.back().sides = fem::Sides::fixed;
    }
    return problems;
}

TEST(FemBodyParts, OfAMirroredBodyAreTwo) {
    for (const auto& problem : mirrored_layers()) {
        const auto parts = parts_of(Discretisation(problem));
        ASSERT_EQ(parts.size(), 2u);
        const std::size_t even = parts[0].condensation.contact().size(),
                          odd = parts[1].condensation.contact().size();
        const Discretisation layer(problem);
        EXPECT_EQ(even + odd,
                  static_cast<std::size_t>(layer.unknowns.n - layer.unknowns.n_interior));
        EXPECT_GT(even, odd);  // y and z on the plane, not x
        expect_condensed(problem);
        expect_solved(problem);
    }
}

// Two patches on either side of the plane, none of whose nodes lies on it.
TEST(FemBodyParts, ContactMayLieBesideThePlane) {
    auto problem = mirrored_layer(true, 2.9e-3);
    for (auto& face : problem.mesh.faces) {
        if (face.boundary != Boundary::contact) continue;
        for (const int node : face.nodes)
            if (std::abs(problem.mesh.nodes[node][0] - 4e-3) < 1e-4)
                face.boundary = Boundary::free_top;
    }
    const Discretisation layer(problem);
    for (const double x : layer.surface.points.x) ASSERT_GT(std::abs(x - 4e-3), 1e-3);
    EXPECT_EQ(parts_of(layer).size(), 2u);
    expect_condensed(problem);
}

void expect_one_part(const fem::LayerProblem& problem) {
    EXPECT_FALSE(fem::mirror_symmetry(fem::Q2Space(problem.mesh)));
    EXPECT_EQ(parts_of(Discretisation(problem)).size(), 1u);
    expect_condensed(problem);
}

TEST(FemBodyParts, OfABodyWithoutMirrorImageIsOne) {
    auto moved = mirrored_layer(false);
    moved.mesh.nodes[moved.mesh.nodes.size() / 3][1] += 1e-11;  // 2e-9 of the extent
    expect_one_part(moved);

    auto of_other_material = mirrored_layer(false);
    of_other_material.mesh.regions.back() = meshes::Region::lower_layer;
    expect_one_part(of_other_material);

    auto with_other_contact = mirrored_layer(true);
    for (auto& face : with_other_contact.mesh.faces)
        if (face.boundary == Boundary::contact) {
            face.boundary = Boundary::free_top;
            break;
        }
    expect_one_part(with_other_contact);

    auto with_element_across = mirrored_layer(true);
    with_element_across.mesh = test::box_mesh({test::even(-3e-3, 3e-3, 5),
                                               test::even(0, 3e-3, 2),
                                               {-2.5e-3, -1.2e-3, -.5e-3, 0},
                                               2e-3,
                                               2e-3,
                                               true,
                                               -1.2e-3});
    expect_one_part(with_element_across);
}

// What 16 digits of a file leave.
TEST(FemBodyParts, RoundingIsNoAsymmetry) {
    auto problem = mirrored_layer(true);
    for (std::size_t i = 0; i < problem.mesh.nodes.size(); ++i)
        for (double& x : problem.mesh.nodes[i]) x += 1e-17 * std::sin(double(i));  // 2e-15 of 6 mm
    EXPECT_EQ(parts_of(Discretisation(problem)).size(), 2u);
}

// By iteration the same displacements and stresses as by a factor, K/G = 1e6 below and 2.2 above.
TEST(FemBodyParts, BlocksNeedNoFactor) {
    for (const bool half : {false, true}) {
        auto problem = mirrored_layer(half);
        EXPECT_FALSE(fem::block_inside_solver(problem, Discretisation(problem)));
        const auto along_y = test::even(0, 3e-3, 2);
        problem.mesh = test::box_mesh({test::even(-3e-3, 3e-3, 4),
                                       half ? along_y : test::mirrored(along_y),
                                       {-2.5e-3, -1.2e-3, -.5e-3, 0},
                                       2e-3,
                                       2e-3,
                                       half,
                                       -1.2e-3});
        fem::WholeBody body(problem);
        const auto block = fem::block_inside_solver(problem, body.discretisation);
        ASSERT_TRUE(block);
        std::vector<double> forces(body.discretisation.unknowns.n);
        for (std::size_t u = 0; u < forces.size(); ++u)
            forces[u] = std::sin(static_cast<double>(u * u) + .5);
        const fem::BodyState by_iteration = block(forces), by_factor = body.state(forces);
        const auto &found = by_iteration.displacement, &expected = by_factor.displacement;
        double off = 0, size = 0;
        for (std::size_t u = 0; u < forces.size(); ++u) {
            off = std::hypot(off, found[u] - expected[u]);
            size = std::hypot(size, expected[u]);
        }
        EXPECT_LT(off, rounding * size);
        const auto inside = body.discretisation.interior(by_iteration, forces),
                   exact = body.discretisation.interior(by_factor, forces);
        off = size = 0;
        for (std::size_t i = 0; i < exact.stress.size(); ++i)
            for (int k = 0; k < 6; ++k) {
                off = std::max(off, std::abs(inside.stress[i][k] - exact.stress[i][k]));
                size = std::max(size, std::abs(exact.stress[i][k]));
            }
        EXPECT_LT(off, 1e-6 * size);  // rounding of displacements times K/G
        EXPECT_NEAR(inside.strain_energy, exact.strain_energy, 1e-8 * exact.strain_energy);
        // Not by K times a rounded dilatation: as exactly as the forces were solved for.
        EXPECT_LT(inside.missing_force(), 1e-11 * inside.applied_force());
        EXPECT_EQ(block(forces).displacement, found);
    }
}

}  // namespace
}  // namespace tricontact::body_parts_test
