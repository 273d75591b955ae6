#include "fem/pair_compliance.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "contact/compliances/interior_parts.h"
#include "fem/condensed_compliance.h"
#include "meshes/round_body_mesh.h"

namespace tricontact::pair_compliance_test {
namespace {

using contact::Material;
using contact::TangentialField;
using fem::CondensedPart;
using fem::PairCompliance;

const Material soft{2e6, .3}, stiff{4e6, .4};

meshes::LayerMeshSpec patch(int n = 1) {
    return {.size = 1e-3,
            .patch_x = n * 1e-3,
            .patch_y = n * 1e-3,
            .half_x = 6e-3,
            .half_y = 6e-3,
            .thickness = 3e-3,
            .growth = 4,
            .half_model = true,
            .ends = {}};
}

CondensedPart condensed(meshes::HexMesh mesh, const Material& material, bool half_ball = false) {
    auto problem = std::make_shared<fem::LayerProblem>();
    problem->mesh = std::move(mesh);
    problem->materials = {material, material};
    if (half_ball) {
        problem->base = contact::Case::Base::frictionless;
        problem->held_by_symmetry = true;
    }
    fem::CondensedLayer layer = condense(*problem);
    return {problem, std::move(layer)};
}

CondensedPart layer(const Material& material) {
    return condensed(make_layer_mesh(patch()), material);
}

CondensedPart hemisphere(const Material& material, bool half_ball = false) {
    const auto s = patch();
    return condensed(meshes::make_half_ball_mesh({.radius = 3e-3,
                                                  .size = s.size,
                                                  .patch_x = s.patch_x,
                                                  .patch_y = s.patch_y,
                                                  .growth = s.growth,
                                                  .half_model = s.half_model}),
                     material, half_ball);
}

using Matrix = Eigen::MatrixXd;
Matrix matrix(const contact::Compliance& compliance) {
    const auto n = static_cast<Eigen::Index>(3 * compliance.points().size());
    return Eigen::Map<const Matrix>(compliance.dense(), n, n);
}

// Normal blocks stay, those between normal and tangential directions change their sign.
Matrix with_opposite_coupling(Matrix m) {
    const Eigen::Index t = m.rows() / 3 * 2, n = m.rows() / 3;
    m.block(0, t, t, n) *= -1;
    m.block(t, 0, n, t) *= -1;
    return m;
}

struct Tractions {
    explicit Tractions(const contact::ContactPoints& points) : p(points.size()), t(points.size()) {
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double k = static_cast<double>(i);
            p[i] = 2e4 + 1e4 * std::sin(k);
            t.x[i] = 1e4 * std::cos(k);
            t.y[i] = points.y[i] > 0 ? 1e4 * std::sin(2 * k) : 0;
            force[0] += points.area[i] * t.x[i];
            force[2] -= points.area[i] * p[i];
        }
    }
    std::vector<double> p;
    TangentialField t;
    std::array<double, 3> force{};  // on the substrate, z up
};

// A block seen from the rigid body on it, or from the one below it: what it does normally and in
// the surface is the same, and the coupling has the other sign (Dundurs: substrate less indenter).
TEST(FemPairCompliance, ABlockAboveCouplesTheOtherWay) {
    const CondensedPart block = layer(soft);
    const fem::CondensedCompliance below(block.problem, block.layer);
    const PairCompliance above(fem::plane_patch(patch()), block);
    EXPECT_EQ(matrix(above), with_opposite_coupling(matrix(below)));
    EXPECT_GT(matrix(above).topRightCorner(1, 1).norm(), 0);
    for (std::size_t i = 0; i < above.points().size(); ++i)
        EXPECT_NEAR(above.points().area[i] / below.points().area[i], 1, 1e-12);
}

TEST(FemPairCompliance, IsTheSumOfBothBodies) {
    const CondensedPart below = layer(stiff), above = hemisphere(soft);
    const Matrix substrate = matrix(fem::CondensedCompliance(below.problem, below.layer));
    const Matrix indenter = matrix(PairCompliance(fem::plane_patch(patch()), above));
    const PairCompliance pair(below, above);
    EXPECT_LT((matrix(pair) - substrate - indenter).norm(), 1e-14 * substrate.norm());
    EXPECT_LT((matrix(pair) - matrix(pair).transpose()).norm(), 1e-12 * substrate.norm());
    // Equal bodies do not couple; 1e-12: their numbers are the same but for the order of sums.
    const PairCompliance equal(below, below);
    const Eigen::Index n = equal.points().size();
    EXPECT_LT(matrix(equal).block(0, 2 * n, 2 * n, n).norm(), 1e-12 * substrate.norm());
}

// Forces of what holds each body from the displacements inside it: opposite to one another.
TEST(FemPairCompliance, BothBodiesAreHeld) {
    const PairCompliance pair(layer(stiff), hemisphere(soft));
    const Tractions tractions(pair.points());
    const auto missing = pair.missing_reaction(tractions.p, tractions.t);
    const auto both = pair.interior(tractions.p, tractions.t);
    ASSERT_TRUE(both && contact::has_indenter(*both));
    const auto below = std::make_unique<contact::Interior>(contact::substrate_part(*both));
    const contact::Interior above = pair.indenter_interior(tractions.p, tractions.t);
    ASSERT_TRUE(missing && below && below->base_reaction && above.base_reaction);
    const double allowed = pair.allowed_missing_reaction() * std::abs(tractions.force[2]);
    for (int d = 0; d < 3; ++d) {
        EXPECT_LT(std::abs((*missing)[d]), allowed);
        EXPECT_NEAR(below->applied[d], tractions.force[d], allowed);
        EXPECT_NEAR(above.applied[d], -tractions.force[d], allowed);
        EXPECT_NEAR((*below->base_reaction)[d], -tractions.force[d], allowed);
        EXPECT_NEAR((*above.base_reaction)[d], tractions.force[d], allowed);
    }
    // The energy of both is the work of the tractions: half of force times relative displacement.
    std::vector<double> u_z(tractions.p.size()), coupled(tractions.p.size());
    TangentialField u(tractions.p.size()), along(tractions.p.size());
    pair.normal(tractions.p, u_z);
    pair.normal_from_tangential(tractions.t, coupled);
    pair.tangential(tractions.t, u);
    pair.tangential_from_normal(tractions.p, along);
    double work = 0;
    for (std::size_t i = 0; i < u_z.size(); ++i)
        work += pair.points().area[i] / 2 *
                (tractions.p[i] * (u_z[i] + coupled[i]) + tractions.t.x[i] * (u.x[i] + along.x[i]) +
                 tractions.t.y[i] * (u.y[i] + along.y[i]));
    EXPECT_NEAR(both->strain_energy / work, 1, 1e-9);
    EXPECT_GT(both->strain_energy, above.strain_energy);
    EXPECT_EQ(both->points.size(), below->points.size() + above.points.size());
    // The indenter stands on the plane, its material above.
    for (const auto& x : above.points) EXPECT_GE(x[2], 0);
    // On a rigid plane there is nothing else.
    const auto alone = PairCompliance(fem::plane_patch(patch()), hemisphere(soft))
                           .interior(tractions.p, tractions.t);
    ASSERT_TRUE(alone);
    EXPECT_FALSE(contact::has_substrate(*alone));
    EXPECT_EQ(alone->strain_energy, above.strain_energy);
}

// A half ball that symmetry holds does not react along x to what has no resultant there.
TEST(FemPairCompliance, SymmetryTakesNoForce) {
    const PairCompliance pair(fem::plane_patch(patch()), hemisphere(soft, true));
    Tractions tractions(pair.points());
    std::fill(tractions.t.x.begin(), tractions.t.x.end(), 0.);
    std::fill(tractions.t.y.begin(), tractions.t.y.end(), 0.);
    for (std::size_t i = 0; i < tractions.p.size(); ++i) {  // even in x
        tractions.p[i] = 1e4;
        tractions.t.x[i] = pair.points().x[i] * 1e7;
    }
    const contact::Interior inside = pair.indenter_interior(tractions.p, tractions.t);
    const double force = std::abs(inside.applied[2]);
    EXPECT_NEAR((*inside.base_reaction)[0], 0, 1e-9 * force);
    EXPECT_NEAR((*inside.base_reaction)[2] / inside.applied[2], -1, 1e-9);
}

TEST(FemPairCompliance, RefusesPatchesThatDoNotMatch) {
    EXPECT_THROW(PairCompliance(fem::plane_patch(patch(2)), hemisphere(soft)), std::logic_error);
}

}  // namespace
}  // namespace tricontact::pair_compliance_test
