#include "fem/condensed_compliance.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <memory>

#include "contact/compliances/compliance.h"
#include "contact/substrates/partly_relaxing_substrate.h"
#include "tests/unit/fem/layer_problems.h"

namespace tricontact::condensed_compliance_test {
namespace {

using contact::TangentialField;
using fem::CondensedCompliance;
using fem::CondensedLayer;

struct Tractions {
    explicit Tractions(const contact::ContactPoints& points) : p(points.size()), t(points.size()) {
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double k = static_cast<double>(i);
            p[i] = 2e5 + 1e5 * std::sin(k);
            t.x[i] = 1e5 * std::cos(k);
            t.y[i] = 1e5 * std::sin(2 * k);
            for (int d = 0; d < 3; ++d)
                force[d] += points.area[i] * (d == 0 ? t.x[i] : d == 1 ? t.y[i] : -p[i]);
        }
    }
    std::vector<double> p;
    TangentialField t;
    std::array<double, 3> force{};
};

// Two roads to the ground's reaction: by reciprocity from the condensation, and from the
// displacements of the whole body.
TEST(FemCondensedCompliance, GroundCarriesTheForce) {
    for (const bool half : {false, true}) {
        const auto problem = std::make_shared<fem::LayerProblem>(test::small_layer(half));
        const CondensedCompliance compliance(problem, fem::condense(*problem));
        const Tractions tractions(compliance.points());
        const auto missing = compliance.missing_reaction(tractions.p, tractions.t);
        const auto inside = compliance.interior(tractions.p, tractions.t);
        ASSERT_TRUE(missing && inside);
        const double allowed = 1e-8 * std::abs(tractions.force[2]);  // K/G = 1e6, rounded
        for (int d = 0; d < 3; ++d) {
            EXPECT_LT(std::abs((*missing)[d]), allowed);
            EXPECT_LT(std::abs(inside->applied[d] + inside->base_reaction->at(d)), allowed);
        }
        EXPECT_NE((*missing)[2], 0);  // measured, not promised
    }
}

// A ground that carries nothing misses the whole force; halves cancel each other's y.
TEST(FemCondensedCompliance, GroundThatCarriesNothingIsSeen) {
    for (const bool half : {false, true}) {
        const auto problem = std::make_shared<fem::LayerProblem>(test::small_layer(half));
        CondensedLayer layer = fem::condense(*problem);
        const std::size_t n = layer.points.size();
        for (std::size_t d = 0; d < 3; ++d)
            for (std::size_t c = 0; c < 3 * n; ++c)
                layer.missing_reaction[d][c] = c / n == d ? 1 : 0;
        const CondensedCompliance compliance(problem, std::move(layer));
        const Tractions tractions(compliance.points());
        const auto missing = compliance.missing_reaction(tractions.p, tractions.t);
        ASSERT_TRUE(missing);
        for (int d = 0; d < 3; ++d)
            EXPECT_NEAR((*missing)[d], half && d == 1 ? 0 : tractions.force[d],
                        1e-12 * std::abs(tractions.force[2]));
    }
}

// Coupled by elements' mean displacements: only the coupling differs, by those means, and what one
// traction does to the other stays the same both ways.
TEST(FemCondensedCompliance, CouplesByElementMeans) {
    for (const bool half : {false, true}) {
        const auto problem = std::make_shared<fem::LayerProblem>(test::small_layer(half));
        const CondensedCompliance by_nodes(problem, fem::condense(*problem)),
            by_means(problem, fem::condense(*problem), {}, true);
        const contact::ContactPoints& points = by_means.points();
        const auto n = static_cast<Eigen::Index>(3 * points.size());
        const Eigen::Map<const Eigen::MatrixXd> a(by_means.dense(), n, n),
            b(by_nodes.dense(), n, n);
        EXPECT_LT((a - a.transpose()).norm(), 1e-12 * a.norm());
        const Eigen::Index z = n / 3;
        EXPECT_EQ(a.topLeftCorner(2 * z, 2 * z), b.topLeftCorner(2 * z, 2 * z));
        EXPECT_EQ(a.bottomRightCorner(z, z), b.bottomRightCorner(z, z));
        EXPECT_GT((a - b).norm(), 1e-4 * b.norm());
        // What flows through the surface keeps its volume.
        const Eigen::Map<const Eigen::VectorXd> area(points.area.data(), z);
        const Eigen::VectorXd volume = a.bottomLeftCorner(z, 2 * z).transpose() * area,
                              before = b.bottomLeftCorner(z, 2 * z).transpose() * area;
        // Elements that are no rectangles have other means than their nodes' areas give.
        EXPECT_LT((volume - before).norm(), .1 * before.norm());
    }
}

// Two materials, finite and infinite bulk moduli, distorted elements: where the shear moduli take a
// factor, the interpolation between a few condensations is the condensation, to its own bound.
TEST(FemCondensedCompliance, InterpolatesInTheShearModulus) {
    const fem::LayerProblem relaxed = test::small_layer();
    auto at = [&](double ratio) {
        auto problem = std::make_shared<fem::LayerProblem>(relaxed);
        for (auto& material : problem->materials) material = material.with_shear_ratio(ratio);
        return std::make_shared<CondensedCompliance>(problem, fem::condense(*problem));
    };
    const contact::StieltjesInterpolation interpolation(6, 1e-5);
    contact::CombinedCompliance::Parts parts;
    for (const double x : interpolation.nodes) parts.push_back(at(x));
    contact::CombinedCompliance combined(parts, true);
    for (const double x : {1., 2.2, 6.}) {
        const auto direct = at(x);
        combined.set_weights(interpolation.shares(x));
        const auto n = static_cast<Eigen::Index>(3 * direct->points().size());
        const Eigen::Map<const Eigen::MatrixXd> a(combined.dense(), n, n), b(direct->dense(), n, n);
        const double worst = (a - b).norm() / b.norm();
        EXPECT_LT(worst, 1e-5) << x;
        EXPECT_GT(worst, 1e-9) << x;  // it is an interpolation
        // Products are those of the matrix.
        const Tractions t(direct->points());
        std::vector<double> u(t.p.size()), v(t.p.size());
        combined.normal(t.p, u);
        direct->normal(t.p, v);
        EXPECT_NEAR(u[3] / v[3], 1, 1e-4);
        combined.normal_from_tangential(t.t, u);
        direct->normal_from_tangential(t.t, v);
        EXPECT_NEAR(u[3] / v[3], 1, 1e-3);
    }
}

}  // namespace
}  // namespace tricontact::condensed_compliance_test
