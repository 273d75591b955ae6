#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <memory>
#include <numbers>

#include "contact/bodies/indenter.h"
#include "contact/solvers/contact_region.h"
#include "contact/solvers/normal_solver.h"
#include "fem/pair_compliance.h"
#include "meshes/round_body_mesh.h"

// An indenter that deforms beside axisymmetric finite elements of another program (Q2, P1
// discontinuous pressure, curved elements, three meshes each, their scatter at most 1e-4 of F and
// 1e-3 of a): F within .3 %, a and p0 within 1 %, with 4 elements in the radius already. The
// shallow cases take the finest meshes for their size and stand once each. What the default
// accuracy makes of these bodies at d = 1 mm is in indenter_bodies.cc.

namespace tricontact::fem::two_bodies_test {
namespace {

constexpr double R = 1e-2, mm = 1e-3, MPa = 1e6;

struct Reference {
    double nu, d;     // [-], [mm]
    double F, a, p0;  // [N], [mm], [MPa]
};

enum class Body { hemisphere, ball };

meshes::LayerMeshSpec patch_for(double radius, double elements) {
    const double size = radius / elements;
    return {.size = size,
            .patch_x = size * std::ceil(1.12 * elements),
            .patch_y = size * std::ceil(1.12 * elements),
            .half_x = 200 * mm,
            .half_y = 200 * mm,
            .thickness = 5 * mm,
            .half_model = true,
            .ends = {}};
}

CondensedPart body(Body kind, const contact::Material& material, const meshes::LayerMeshSpec& s) {
    auto problem = std::make_shared<LayerProblem>();
    problem->mesh = meshes::make_half_ball_mesh({.radius = R,
                                                 .size = s.size,
                                                 .patch_x = s.patch_x,
                                                 .patch_y = s.patch_y,
                                                 .growth = s.growth,
                                                 .half_model = s.half_model});
    problem->materials = {material, material};
    if (kind == Body::ball) {
        problem->base = contact::Case::Base::frictionless;
        problem->held_by_symmetry = true;
    }
    CondensedLayer condensed = condense(*problem);
    return {problem, std::move(condensed)};
}

CondensedPart layer(const contact::Material& material, const meshes::LayerMeshSpec& s) {
    auto problem = std::make_shared<LayerProblem>();
    problem->mesh = make_layer_mesh(s);
    problem->materials = {material, material};
    CondensedLayer condensed = condense(*problem);
    return {problem, std::move(condensed)};
}

struct Pressed {
    double F, a, p0;
};

Pressed press(const contact::Compliance& compliance, double d) {
    const auto heights = contact::heights_over(compliance.points(), contact::Sphere(R), {0, 0});
    const auto solution = contact::NormalSolver(compliance, 1e-8)
                              .solve(heights, {contact::NormalControl::Kind::indentation, d});
    EXPECT_FALSE(contact::reaches_edge(compliance.points(), solution.pressure));
    const auto& points = compliance.points();
    std::size_t middle = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (std::hypot(points.x[i], points.y[i]) < 1e-9) middle = i;
    return {solution.force, contact::contact_radius(points, solution.pressure, {0, 0}),
            solution.pressure[middle]};
}

void expect_as(const Reference& r, const Pressed& found) {
    EXPECT_NEAR(found.F / r.F, 1, .003) << r.nu << " " << r.d;
    EXPECT_NEAR(found.a / (r.a * mm), 1, .01) << r.nu << " " << r.d;
    EXPECT_NEAR(found.p0 / (r.p0 * MPa), 1, .01) << r.nu << " " << r.d;
}

constexpr double elements = 4;  // in the contact radius

TEST(FemTwoBodies, HemisphereOnARigidPlane) {
    for (const Reference& r : {Reference{.495, .1, .38130, 1.0242, .173255},
                               Reference{.3, 1, 12.0063, 3.3867, .48900}}) {
        const auto s = patch_for(r.a * mm, elements);
        auto part = body(Body::hemisphere, {2 * MPa, r.nu}, s);
        expect_as(r, press(PairCompliance(plane_patch(s), std::move(part)), r.d * mm));
    }
}

TEST(FemTwoBodies, HemisphereOnALayer) {
    for (const Reference& r :
         {Reference{.3, .1, .21837, 1.0367, .096793}, Reference{.3, 1, 8.9953, 3.4774, .34873}}) {
        const auto s = patch_for(r.a * mm, elements);
        auto part = body(Body::hemisphere, {2 * MPa, r.nu}, s);
        auto below = layer({4 * MPa, r.nu}, s);
        expect_as(r, press(PairCompliance(std::move(below), std::move(part)), r.d * mm));
    }
}

TEST(FemTwoBodies, BallBetweenPlates) {
    for (const Reference& r : {Reference{.3, .1, .30964, 1.0185, .142175},
                               Reference{.495, 1, 12.5632, 3.2421, .55987}}) {
        const auto s = patch_for(r.a * mm, elements);
        expect_as(r, press(PairCompliance(plane_patch(s), body(Body::ball, {2 * MPa, r.nu}, s)),
                           r.d * mm));
    }
}

// Two equal hemispheres are each other's mirror image: half of the approach each, no coupling.
TEST(FemTwoBodies, TwoEqualHemispheres) {
    const auto s = patch_for(3.3867 * mm, 3);
    const contact::Material material{2 * MPa, .3};
    const PairCompliance one(plane_patch(s), body(Body::hemisphere, material, s));
    // The other body stands below, its own patch curved: contact's areas are those of the plane.
    CondensedPart below = body(Body::hemisphere, material, s);
    below.layer.points = plane_patch(s).points;
    const PairCompliance two(std::move(below), body(Body::hemisphere, material, s));
    const auto heights = contact::heights_over(two.points(), contact::Sphere(R), {0, 0});
    std::vector<double> twice = heights;
    for (double& h : twice) h *= 2;
    using Kind = contact::NormalControl::Kind;
    const auto single =
        contact::NormalSolver(one, 1e-9).solve(heights, {Kind::indentation, 1 * mm});
    const auto both = contact::NormalSolver(two, 1e-9).solve(twice, {Kind::indentation, 2 * mm});
    EXPECT_NEAR(both.force / single.force, 1, 1e-6);
    const double p0 = *std::ranges::max_element(single.pressure);
    for (std::size_t i = 0; i < both.pressure.size(); ++i)
        EXPECT_NEAR(both.pressure[i] / p0, single.pressure[i] / p0, 1e-6);
    // Equal bodies decouple.
    const std::size_t n = two.points().size();
    double cross = 0, normal = 0;
    for (std::size_t c = 0; c < n; ++c)
        for (std::size_t r = 0; r < n; ++r) {
            cross = std::max(cross, std::abs(two.dense()[(2 * n + c) * 3 * n + r]));
            normal = std::max(normal, std::abs(two.dense()[(2 * n + c) * 3 * n + 2 * n + r]));
        }
    EXPECT_LT(cross, 1e-10 * normal);
}

// A circle r <= a glued to a rigid plane that moves along x by one.
TEST(FemTwoBodies, TangentialStiffnessOfAGluedCircle) {
    struct Glued {
        double nu, a, stiffness;  // [-], [mm], over E = 2 MPa: [N/mm]
    };
    for (const Glued& g : {Glued{.495, 3, 6.760}, Glued{.3, 2, 5.1916}}) {
        std::array<double, 2> found{};
        for (int level = 0; level < 2; ++level) {
            const auto s = patch_for(g.a * mm, level == 0 ? elements / 2 : elements);
            const PairCompliance pair(plane_patch(s), body(Body::hemisphere, {2 * MPa, g.nu}, s));
            const auto& points = pair.points();
            const auto n = static_cast<Eigen::Index>(points.size());
            std::vector<Eigen::Index> glued;
            for (int c = 0; c < 3; ++c)
                for (Eigen::Index i = 0; i < n; ++i)
                    if (std::hypot(points.x[i], points.y[i]) <= g.a * mm * (1 + 1e-9) &&
                        !(c == 1 && points.y[i] == 0))
                        glued.push_back(c * n + i);
            const Eigen::Map<const Eigen::MatrixXd> all(pair.dense(), 3 * n, 3 * n);
            const Eigen::MatrixXd C = all(glued, glued);
            Eigen::VectorXd u(glued.size());
            for (std::size_t k = 0; k < glued.size(); ++k) u[k] = glued[k] < n ? 1 : 0;
            const Eigen::VectorXd f = C.ldlt().solve(u);
            found[level] = f.dot(u) * 1e-3;  // N/m in N/mm
        }
        const double extrapolated = 2 * found[1] - found[0];
        EXPECT_NEAR(extrapolated / g.stiffness, 1, .01) << g.nu << " " << g.a;
    }
}

// Johnson (1985), eq. 5.57: half of the approach of two plates, E* d L/F = 2/pi [2 ln(4R/a) - 1]/2,
// but for terms of the order (a/R)^2; 1e-3: eight elements in a.
TEST(FemTwoBodies, CylinderBetweenPlates) {
    for (const double nu : {.3, .495}) {
        const contact::Material material{2 * MPa, nu};
        const double a = .05 * R, E_star = 1 / material.plane_compliance();
        const double L = 1 * mm, load = std::numbers::pi * E_star * a * a / (4 * R) * L;
        const double size = a / 8;
        const meshes::LayerMeshSpec s{.size = size,
                                      .patch_x = 10 * size,
                                      .patch_y = L / 2,
                                      .half_x = 10 * size,
                                      .half_y = L / 2,
                                      .thickness = size,
                                      .half_model = true,
                                      .plane_strain = true,
                                      .ends = {}};
        auto problem = std::make_shared<LayerProblem>();
        problem->mesh = meshes::make_cylinder_mesh(
            {.radius = R, .size = size, .patch_x = s.patch_x, .half_y = L / 2});
        problem->materials = {material, material};
        problem->base = contact::Case::Base::frictionless;
        problem->held_by_symmetry = true;
        problem->line_length = L;
        CondensedLayer condensed = condense(*problem);
        condensed.points = plane_patch(s).points;
        const CondensedLayer line = contact_line(condensed);
        const PairCompliance pair(ContactSurface{{}, line.points, {}}, {problem, line});
        const auto heights = contact::heights_over(pair.points(), contact::Paraboloid(R), {0, 0});
        const auto solution = contact::NormalSolver(pair, 1e-8)
                                  .solve(heights, {contact::NormalControl::Kind::force, load});
        const double approach = (2 * std::log(4 * R / a) - 1) / std::numbers::pi;
        EXPECT_NEAR(E_star * solution.indentation * L / load / approach, 1, .001);
        EXPECT_NEAR(contact::contact_radius(pair.points(), solution.pressure, {0, 0}) / a, 1, .003);
    }
}

}  // namespace
}  // namespace tricontact::fem::two_bodies_test
