#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <vector>

#include "bem/half_space_compliance.h"
#include "bem/influence.h"

namespace tricontact {
namespace {

using bem::HalfSpaceCompliance;
using contact::ContactPoints;
using contact::MaterialPair;
using contact::TangentialField;

const ContactPoints grid_a = ContactPoints::grid(9, 6, {-.8, 2}, {.2, .3});
const ContactPoints grid_b = ContactPoints::grid(5, 7, {0, 0}, {.1, .1});

MaterialPair materials(double nu) {
    return {contact::Material{50, .3}, {3, nu}};
}

/// Matrix of a linear map of tangential fields, by its columns, x components first.
Eigen::MatrixXd matrix_of(
    std::size_t n, const std::function<void(const TangentialField&, TangentialField&)>& map) {
    Eigen::MatrixXd m(2 * n, 2 * n);
    TangentialField in(n), out(n);
    for (std::size_t k = 0; k < 2 * n; ++k) {
        double& entry = k < n ? in.x[k] : in.y[k - n];
        entry = 1;
        map(in, out);
        entry = 0;
        for (std::size_t i = 0; i < n; ++i) {
            m(i, k) = out.x[i];
            m(n + i, k) = out.y[i];
        }
    }
    return m;
}

double asymmetry(const Eigen::MatrixXd& m) {
    return (m - m.transpose()).cwiseAbs().maxCoeff() / m.cwiseAbs().maxCoeff();
}
double least_eigenvalue(const Eigen::MatrixXd& m) {
    const Eigen::MatrixXd symmetric = (m + m.transpose()) / 2;
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric).eigenvalues().minCoeff();
}

TEST(HalfSpaceCompliance, IsTheSumOfInfluenceCoefficients) {
    for (const double nu : {0., .3, .5})
        for (const auto& grid : {grid_a, grid_b}) {
            const HalfSpaceCompliance compliance(materials(nu), grid, 1);
            const bem::RectangleInfluence k(materials(nu), grid.spacing[0], grid.spacing[1]);
            const std::size_t n = grid.size();
            std::vector<double> p(n), u_z(n);
            TangentialField t(n), u(n);
            for (std::size_t i = 0; i < n; ++i) {
                p[i] = std::sin(3. * i);
                t.x[i] = std::sin(5. * i);
                t.y[i] = std::cos(2. * i);
            }
            compliance.normal(p, u_z);
            compliance.tangential(t, u);
            const double rounding = 1e-14 * n * k.at(0, 0).zz;
            for (std::size_t i = 0; i < n; ++i) {
                double z = 0, x = 0, y = 0;
                for (std::size_t j = 0; j < n; ++j) {
                    const auto c = k.at(grid.x[i] - grid.x[j], grid.y[i] - grid.y[j]);
                    z += c.zz * p[j];
                    x += c.xx * t.x[j] + c.xy * t.y[j];
                    y += c.yx() * t.x[j] + c.yy * t.y[j];
                }
                ASSERT_NEAR(u_z[i], z, rounding);
                ASSERT_NEAR(u.x[i], x, rounding);
                ASSERT_NEAR(u.y[i], y, rounding);
            }
            EXPECT_EQ(compliance.local_tangential(), k.at(0, 0).xx);
        }
}

TEST(HalfSpaceCompliance, SymmetricPositiveDefinite) {
    for (const double nu : {0., .3, .5})
        for (const auto& grid : {grid_a, grid_b}) {
            const HalfSpaceCompliance compliance(materials(nu), grid, 1);
            const auto tangential = matrix_of(
                grid.size(), [&](const auto& t, auto& u) { compliance.tangential(t, u); });
            EXPECT_LT(asymmetry(tangential), 1e-14);
            // The shortest waves of a grid of spacing h feel about h/4 per G; half of it, to be
            // sure.
            EXPECT_GT(least_eigenvalue(tangential), .1 * compliance.local_tangential());
            const auto normal =
                matrix_of(grid.size(), [&](const TangentialField& t, TangentialField& u) {
                    compliance.normal(t.x, u.x);
                    compliance.normal(t.y, u.y);
                });
            EXPECT_LT(asymmetry(normal), 1e-14);
            EXPECT_GT(least_eigenvalue(normal), 0);
        }
}

TEST(HalfSpaceCompliance, PreconditionerIsSymmetricPositiveAndGood) {
    for (const double nu : {0., .3, .5})
        for (const auto& grid : {grid_a, grid_b, ContactPoints::grid(16, 15, {0, 0}, {.1, .1})}) {
            const HalfSpaceCompliance compliance(materials(nu), grid, 1);
            const auto inverse = matrix_of(grid.size(), [&](const auto& r, auto& z) {
                compliance.precondition_tangential(r, z);
            });
            EXPECT_LT(asymmetry(inverse), 1e-13);
            EXPECT_GT(least_eigenvalue(inverse), 0);
            const auto tangential = matrix_of(
                grid.size(), [&](const auto& t, auto& u) { compliance.tangential(t, u); });
            auto condition = [](const Eigen::MatrixXd& m) {
                const Eigen::VectorXd values = m.eigenvalues().real();
                return values.maxCoeff() / values.minCoeff();
            };
            // it must be worth its transforms
            EXPECT_LT(condition(inverse * tangential), .6 * condition(tangential));
        }
}

TEST(HalfSpaceCompliance, DoesNotCouple) {
    EXPECT_FALSE(HalfSpaceCompliance(materials(.3), grid_a, 1).is_coupled());
}

TEST(HalfSpaceCompliance, ThreadsDoNotChangeABit) {
    const auto grid =
        ContactPoints::grid(400, 300, {0, 0}, {.1, .1});  // enough to be worth threads
    const HalfSpaceCompliance one(materials(.4), grid, 1), two(materials(.4), grid, 2);
    const std::size_t n = grid.size();
    TangentialField t(n), u1(n), u2(n);
    for (std::size_t i = 0; i < n; ++i) {
        t.x[i] = std::sin(1e-2 * i * i);
        t.y[i] = std::cos(3e-2 * i * i);
    }
    one.tangential(t, u1);
    two.tangential(t, u2);
    EXPECT_EQ(u1.x, u2.x);
    EXPECT_EQ(u1.y, u2.y);
    one.precondition_tangential(t, u1);
    two.precondition_tangential(t, u2);
    EXPECT_EQ(u1.x, u2.x);
    one.normal(t.x, u1.x);
    two.normal(t.x, u2.x);
    EXPECT_EQ(u1.x, u2.x);
}

}  // namespace
}  // namespace tricontact
