#include "bem/grid_compliance.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <vector>

#include "bem/influence.h"
#include "contact/compliances/active_operator.h"

namespace tricontact::grid_compliance_test {
namespace {

using bem::GridCompliance;
using bem::half_space_compliance;
using contact::ContactPoints;
using contact::MaterialPair;
using contact::TangentialField;
using contact::operator-;

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

// Coupling included, for half-spaces and for a layer.
template <class Influence>
void expect_sum_of_coefficients(const GridCompliance& compliance, const Influence& k) {
    const ContactPoints& grid = compliance.points();
    const std::size_t n = grid.size();
    std::vector<double> p(n), by_p(n), by_t(n);
    TangentialField t(n), u(n), u_by_p(n);
    for (std::size_t i = 0; i < n; ++i) {
        p[i] = std::sin(3. * i);
        t.x[i] = std::sin(5. * i);
        t.y[i] = std::cos(2. * i);
    }
    compliance.normal(p, by_p);
    compliance.normal_from_tangential(t, by_t);
    compliance.tangential(t, u);
    compliance.tangential_from_normal(p, u_by_p);
    const double rounding = 1e-14 * n * k.at(0, 0).zz;
    for (std::size_t i = 0; i < n; ++i) {
        double zz = 0, zt = 0, xt = 0, yt = 0, xz = 0, yz = 0;
        for (std::size_t j = 0; j < n; ++j) {
            const auto c = k.at(grid.x[i] - grid.x[j], grid.y[i] - grid.y[j]);
            zz += c.zz * p[j];
            zt += c.zx() * t.x[j] + c.zy() * t.y[j];
            xt += c.xx * t.x[j] + c.xy * t.y[j];
            yt += c.yx() * t.x[j] + c.yy * t.y[j];
            xz += c.xz * p[j];
            yz += c.yz * p[j];
        }
        ASSERT_NEAR(by_p[i], zz, rounding);
        ASSERT_NEAR(by_t[i], zt, rounding);
        ASSERT_NEAR(u.x[i], xt, rounding);
        ASSERT_NEAR(u.y[i], yt, rounding);
        ASSERT_NEAR(u_by_p.x[i], xz, rounding);
        ASSERT_NEAR(u_by_p.y[i], yz, rounding);
    }
    EXPECT_EQ(compliance.local_tangential(), k.at(0, 0).xx);
}

TEST(GridCompliance, IsTheSumOfInfluenceCoefficients) {
    for (const double nu : {0., .3, .5})
        for (const auto& grid : {grid_a, grid_b}) {
            const auto& [h_x, h_y] = grid.spacing;
            expect_sum_of_coefficients(*half_space_compliance(materials(nu), grid, 1),
                                       bem::RectangleInfluence(materials(nu), h_x, h_y));
            const theory::LayerStack layer{{{{3, nu}, .7}}, theory::LayerBase::bonded, {}};
            expect_sum_of_coefficients(*bem::layer_compliance(layer, {}, grid, 1),
                                       bem::LayerInfluence(layer, {}, h_x, h_y, 5));
        }
}

// Small half-spaces leave their symbols to the next on the same cells. Others differ by material,
// spacing, interface or mirror; two at once do not share them.
TEST(GridCompliance, NextOnTheSameCellsIsTheSame) {
    const auto softer = half_space_compliance({contact::Material{50, .3}, {1.5, .3}}, grid_a, 1);
    auto wider_grid = ContactPoints::grid(9, 6, {-.8, 2}, {.4, .6});
    for (int turn = 0; turn < 3; ++turn) {
        const auto first = half_space_compliance(materials(.3), grid_a, 1);
        const auto second = half_space_compliance(materials(.3), grid_a, 1);
        const auto wider = half_space_compliance(materials(.3), wider_grid, 1);
        const auto on_springs =
            half_space_compliance(materials(.3), grid_a, 1, {.normal_stiffness = 2});
        const bem::RectangleInfluence cell(materials(.3), .2, .3);
        expect_sum_of_coefficients(*first, cell);
        expect_sum_of_coefficients(*second, cell);
        expect_sum_of_coefficients(*wider, bem::RectangleInfluence(materials(.3), .4, .6));
        std::vector<double> one(grid_a.size()), rigid(one), sprung(one), soft(one);
        one[7] = 1;
        first->normal(one, rigid);
        on_springs->normal(one, sprung);
        softer->normal(one, soft);
        EXPECT_NEAR(sprung[7] - rigid[7], .5, 1e-14);
        EXPECT_GT(soft[7], 1.5 * rigid[7]);
        EXPECT_TRUE(on_springs->points().on_springs);
        EXPECT_FALSE(second->points().on_springs);
    }
}

TEST(GridCompliance, SymmetricPositiveDefinite) {
    for (const double nu : {0., .3, .5})
        for (const auto& grid : {grid_a, grid_b}) {
            const auto owner = half_space_compliance(materials(nu), grid, 1);
            const GridCompliance& compliance = *owner;
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

TEST(GridCompliance, PreconditionerIsSymmetricPositiveAndGood) {
    for (const double nu : {0., .3, .5})
        for (const auto& grid : {grid_a, grid_b, ContactPoints::grid(12, 11, {0, 0}, {.1, .1})}) {
            const auto owner = half_space_compliance(materials(nu), grid, 1);
            const GridCompliance& compliance = *owner;
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

std::vector<std::size_t> all_of(const ContactPoints& grid) {
    std::vector<std::size_t> all(grid.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
}

// Alone it is the preconditioner without, and the softer the layer, the nearer it is to the inverse
// of both: what the bare period leaves out is of the body alone.
TEST(GridCompliance, PreconditionsUnderALayer) {
    const ContactPoints grid = ContactPoints::grid(9, 8, {0, 0}, {.1, .1});
    for (const double nu : {0., .5}) {
        const auto compliance = half_space_compliance(materials(nu), grid, 1);
        const auto products = compliance->among(all_of(grid));
        ASSERT_TRUE(products && products->knows_layers());
        const auto n = static_cast<Eigen::Index>(grid.size());
        const auto tangential =
            matrix_of(grid.size(), [&](const auto& t, auto& u) { products->apply(t, u); });
        const auto without =
            matrix_of(grid.size(), [&](const auto& r, auto& z) { products->precondition(r, z); });
        double last = std::numeric_limits<double>::infinity();
        for (const double soft : {0., 1., 10., 100., 1e4}) {
            const double local = soft * compliance->local_tangential();
            const contact::LayerCompliance layer{local, .2 * local, .5 * local};
            const auto inverse = matrix_of(grid.size(), [&](const auto& r, auto& z) {
                products->precondition_under(layer, r, z);
            });
            EXPECT_LT(asymmetry(inverse), 1e-13);
            EXPECT_GT(least_eigenvalue(inverse), 0);
            if (soft == 0) {
                EXPECT_LT((inverse - without).cwiseAbs().maxCoeff(),
                          1e-13 * without.cwiseAbs().maxCoeff());
            }
            Eigen::MatrixXd both = tangential;
            both.diagonal().head(n).array() += layer.xx;
            both.diagonal().tail(n).array() += layer.yy;
            both.topRightCorner(n, n).diagonal().array() += layer.xy;
            both.bottomLeftCorner(n, n).diagonal().array() += layer.xy;
            const Eigen::VectorXd values = (inverse * both).eigenvalues().real();
            const double condition = values.maxCoeff() / values.minCoeff();
            EXPECT_LT(condition, last) << soft;
            last = condition;
        }
        EXPECT_LT(last, 1.001);
    }
}

// On half of the plane, whose layer has no xy.
TEST(GridCompliance, PreconditionsMirroredUnderALayer) {
    constexpr int n_x = 32, n_y = 8;
    const auto half = ContactPoints::mirrored_grid(n_x, n_y, 0, {.1, .1});
    const auto whole = ContactPoints::grid(n_x, 2 * n_y - 1, {0, -.7}, {.1, .1});
    const auto on_half = half_space_compliance(materials(.3), half, 1);
    const auto on_whole = half_space_compliance(materials(.3), whole, 1);
    TangentialField r(half.size()), z(half.size()), all_r(whole.size()), all_z(whole.size());
    for (int j = 0; j < 2 * n_y - 1; ++j)
        for (int i = 0; i < n_x; ++i) {
            const int row = std::abs(j - (n_y - 1)), side = j < n_y - 1 ? -1 : 1;
            const std::size_t k = row * n_x + i;
            r.set(k, {std::sin(3. * k), row == 0 ? 0 : std::cos(5. * k)});
            all_r.set(j * n_x + i, {r.x[k], side * r.y[k]});
        }
    const double local = on_half->local_tangential();
    on_half->among(all_of(half))->precondition_under({3 * local, local, 5 * local}, r, z);
    on_whole->among(all_of(whole))->precondition_under({3 * local, 0, 5 * local}, all_r, all_z);
    double largest = 0, worst = 0;
    for (std::size_t k = 0; k < half.size(); ++k) {
        const std::size_t of_whole = (k / n_x + n_y - 1) * n_x + k % n_x;
        largest = std::max(largest, std::abs(z.x[k]));
        worst = std::max(worst, contact::norm(z.at(k) - all_z.at(of_whole)));
    }
    EXPECT_LT(worst, 1e-13 * largest);
}

TEST(GridCompliance, CouplesWhereTheMaterialsDo) {
    EXPECT_TRUE(half_space_compliance(materials(.3), grid_a, 1)->is_coupled());
    EXPECT_FALSE(half_space_compliance({{}, {3, .5}}, grid_a, 1)->is_coupled());
    EXPECT_FALSE(
        half_space_compliance({contact::Material{3, .3}, {3, .3}}, grid_a, 1)->is_coupled());
    const theory::LayerStack layer{{{{3, .5}, .7}}, theory::LayerBase::bonded, {}};
    EXPECT_TRUE(bem::layer_compliance(layer, {}, grid_a, 1)->is_coupled());
}

TEST(GridCompliance, ThreadsDoNotChangeABit) {
    const auto grid =
        ContactPoints::grid(400, 300, {0, 0}, {.1, .1});  // enough to be worth threads
    const auto one = half_space_compliance(materials(.4), grid, 1),
               two = half_space_compliance(materials(.4), grid, 2);
    const std::size_t n = grid.size();
    TangentialField t(n), u1(n), u2(n);
    for (std::size_t i = 0; i < n; ++i) {
        t.x[i] = std::sin(1e-2 * i * i);
        t.y[i] = std::cos(3e-2 * i * i);
    }
    one->tangential(t, u1);
    two->tangential(t, u2);
    EXPECT_EQ(u1.x, u2.x);
    EXPECT_EQ(u1.y, u2.y);
    one->precondition_tangential(t, u1);
    two->precondition_tangential(t, u2);
    EXPECT_EQ(u1.x, u2.x);
    one->normal(t.x, u1.x);
    two->normal(t.x, u2.x);
    EXPECT_EQ(u1.x, u2.x);
}

}  // namespace
}  // namespace tricontact::grid_compliance_test
