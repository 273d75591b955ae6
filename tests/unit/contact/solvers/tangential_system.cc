#include "contact/solvers/tangential_system.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/unit/contact/dense_compliance.h"

namespace tricontact::tangential_system_test {
namespace {

using contact::TangentialField;
using contact::TangentialSystem;
using contact::Vector2;
using contact_test::DenseCompliance;

constexpr int n_points = 40;

/// A random state of zones: every third point open, half of the others slipping.
struct Zones {
    std::vector<std::size_t> active;
    std::vector<std::uint8_t> slipping;
    std::vector<Vector2> tangent;
    std::vector<double> curvature;

    explicit Zones(int slip_every) {
        for (int i = 0; i < n_points; ++i) {
            if (i % 3 == 1) continue;
            active.push_back(i);
            const bool slips = slip_every > 0 && i % slip_every == 0;
            slipping.push_back(slips);
            const double angle = 1.7 * i;
            tangent.push_back(slips ? Vector2{std::cos(angle), std::sin(angle)} : Vector2{});
            curvature.push_back(slips ? .05 * (i % 5) : 0);
        }
    }
    /// Columns: the admissible directions of every active point.
    Eigen::MatrixXd basis() const {
        std::vector<Eigen::VectorXd> columns;
        auto add = [&](std::size_t i, const Vector2& direction) {
            Eigen::VectorXd column = Eigen::VectorXd::Zero(2 * n_points);
            column[static_cast<int>(i)] = direction[0];
            column[static_cast<int>(i) + n_points] = direction[1];
            columns.push_back(column);
        };
        for (std::size_t k = 0; k < active.size(); ++k) {
            if (slipping[k]) {
                add(active[k], tangent[k]);
                continue;
            }
            add(active[k], {1, 0});
            add(active[k], {0, 1});
        }
        Eigen::MatrixXd b(2 * n_points, static_cast<Eigen::Index>(columns.size()));
        for (Eigen::Index c = 0; c < b.cols(); ++c) b.col(c) = columns[c];
        return b;
    }
};

struct RightHandSide {
    TangentialField r{n_points};
    Vector2 c{.3, -.2};

    RightHandSide() {
        for (int i = 0; i < n_points; ++i) {
            r.x[i] = std::sin(3. * i);
            r.y[i] = std::cos(5. * i);
        }
    }
};

/// Among the active points, and back.
TangentialField among(const Zones& zones, const TangentialField& f) {
    TangentialField some(zones.active.size());
    for (std::size_t k = 0; k < some.size(); ++k) some.set(k, f.at(zones.active[k]));
    return some;
}
TangentialField on_all(const Zones& zones, const TangentialField& f) {
    TangentialField all(n_points);
    for (std::size_t k = 0; k < f.size(); ++k) all.set(zones.active[k], f.at(k));
    return all;
}

/// z and dU from one dense factorisation of the saddle point system.
Eigen::VectorXd dense_solution(const DenseCompliance& compliance, const Zones& zones,
                               const RightHandSide& rhs, std::array<bool, 2> force_controlled) {
    const Eigen::VectorXd w = compliance.weights2();
    const Eigen::MatrixXd b = zones.basis();
    const Eigen::MatrixXd bw = b.transpose() * w.asDiagonal();
    Eigen::VectorXd d = Eigen::VectorXd::Zero(2 * n_points);
    for (std::size_t k = 0; k < zones.active.size(); ++k) {
        const auto i = static_cast<int>(zones.active[k]);
        d[i] = d[i + n_points] = zones.curvature[k];
    }
    const Eigen::Index m = b.cols();
    Eigen::MatrixXd saddle = Eigen::MatrixXd::Zero(m + 2, m + 2);
    saddle.topLeftCorner(m, m) =
        bw * (compliance.tangential_matrix() * w.asDiagonal() * b + d.asDiagonal() * b);
    Eigen::VectorXd right(m + 2);
    right.head(m) = bw * DenseCompliance::stack(rhs.r);
    for (int e = 0; e < 2; ++e) {
        Eigen::VectorXd ones = Eigen::VectorXd::Zero(2 * n_points);
        ones.segment(e * n_points, n_points).setOnes();
        if (force_controlled[e]) {
            saddle.block(0, m + e, m, 1) = -bw * ones;
            saddle.block(m + e, 0, 1, m) = (bw * ones).transpose();
            right[m + e] = rhs.c[e];
        } else {
            saddle(m + e, m + e) = 1;
            right[m + e] = 0;
        }
    }
    const Eigen::VectorXd y = saddle.fullPivLu().solve(right);
    Eigen::VectorXd result(2 * n_points + 2);
    result << b * y.head(m), y.tail(2);
    return result;
}

void compare(const Zones& zones, std::array<bool, 2> force_controlled) {
    const DenseCompliance compliance(n_points, 11);
    const RightHandSide rhs;
    const auto products = make_active_operator(compliance, zones.active);
    TangentialSystem system(compliance, zones.active, *products, force_controlled);
    ASSERT_TRUE(system.set_zones({zones.slipping, zones.tangent, zones.curvature, {}}));
    const auto& result = system.solve(among(zones, rhs.r), rhs.c, {0, 1e-13, 2000});
    const TangentialField all = on_all(zones, result.z);
    const Eigen::VectorXd expected = dense_solution(compliance, zones, rhs, force_controlled);
    const Eigen::VectorXd z = DenseCompliance::stack(all);
    // residual 1e-13 over the smallest eigenvalue of A, about 0.05, with room for rounding
    const double scale = expected.head(2 * n_points).cwiseAbs().maxCoeff();
    EXPECT_LT((z - expected.head(2 * n_points)).cwiseAbs().maxCoeff(), 1e-10 * scale);
    for (int d = 0; d < 2; ++d)
        EXPECT_NEAR(result.shift_increment[d], expected[2 * n_points + d], 1e-10);
    TangentialField u(n_points);
    compliance.tangential(all, u);
    for (std::size_t k = 0; k < zones.active.size(); ++k) {
        EXPECT_NEAR(result.a_z.x[k], u.x[zones.active[k]], 1e-11 * scale);
        EXPECT_NEAR(result.a_z.y[k], u.y[zones.active[k]], 1e-11 * scale);
    }
}

TEST(TangentialSystem, MatchesADenseSolution) {
    for (const int slip_every : {0, 2, 5, 1})
        for (const auto& control : {std::array{true, true}, std::array{true, false},
                                    std::array{false, true}, std::array{false, false}}) {
            SCOPED_TRACE(testing::Message()
                         << slip_every << ' ' << control[0] << ' ' << control[1]);
            compare(Zones(slip_every), control);
        }
}

TEST(TangentialSystem, EarlierZonesLeaveNoTrace) {
    const DenseCompliance compliance(n_points, 14);
    const Zones first(2), second(5);
    const RightHandSide rhs;
    const auto products_fresh = make_active_operator(compliance, second.active);
    TangentialSystem fresh(compliance, second.active, *products_fresh, {true, true});
    fresh.set_zones({second.slipping, second.tangent, second.curvature, {}});
    const auto expected = fresh.solve(among(second, rhs.r), rhs.c, {1e-8, 0, 2000});
    const auto products_used = make_active_operator(compliance, second.active);
    TangentialSystem used(compliance, second.active, *products_used, {true, true});
    used.set_zones({first.slipping, first.tangent, first.curvature, {}});
    used.solve(among(first, rhs.r), rhs.c, {1e-8, 0, 2000});
    used.set_zones({second.slipping, second.tangent, second.curvature, {}});
    const auto& result = used.solve(among(second, rhs.r), rhs.c, {1e-8, 0, 2000});
    EXPECT_EQ(result.z.x, expected.z.x);  // bit by bit
    EXPECT_EQ(result.z.y, expected.z.y);
    EXPECT_EQ(result.shift_increment, expected.shift_increment);
    EXPECT_EQ(result.iterations, expected.iterations);
}

TEST(TangentialSystem, KeepsTheForceWhateverTheAccuracy) {
    const DenseCompliance compliance(n_points, 12);
    const Zones zones(2);
    const RightHandSide rhs;
    const auto products = make_active_operator(compliance, zones.active);
    TangentialSystem system(compliance, zones.active, *products, {true, true});
    ASSERT_TRUE(system.set_zones({zones.slipping, zones.tangent, zones.curvature, {}}));
    for (const int iterations : {1, 3, 10}) {
        const auto& result = system.solve(among(zones, rhs.r), rhs.c, {0, 0, iterations});
        Vector2 force{};
        for (std::size_t k = 0; k < zones.active.size(); ++k)
            for (int d = 0; d < 2; ++d)
                force[d] += compliance.points().area[zones.active[k]] * result.z.at(k)[d];
        EXPECT_NEAR(force[0], rhs.c[0], 1e-12) << iterations;
        EXPECT_NEAR(force[1], rhs.c[1], 1e-12) << iterations;
    }
}

TEST(TangentialSystem, StopsAtEitherLimit) {
    const DenseCompliance compliance(n_points, 12);
    const Zones zones(2);
    const RightHandSide rhs;
    const auto products = make_active_operator(compliance, zones.active);
    TangentialSystem system(compliance, zones.active, *products, {true, true});
    ASSERT_TRUE(system.set_zones({zones.slipping, zones.tangent, zones.curvature, {}}));
    const int coarse = system.solve(among(zones, rhs.r), rhs.c, {.1, 0, 2000}).iterations;
    const int fine = system.solve(among(zones, rhs.r), rhs.c, {1e-6, 0, 2000}).iterations;
    EXPECT_LT(coarse, fine);
    EXPECT_LE(system.solve(among(zones, rhs.r), rhs.c, {1e-6, 1e3, 2000}).iterations, 2);
}

TEST(TangentialSystem, SaysWhenTheZonesCannotCarryTheForce) {
    const DenseCompliance compliance(n_points, 13);
    Zones zones(1);
    for (std::size_t k = 0; k < zones.active.size(); ++k) zones.tangent[k] = {0, 1};
    // everything slips in x: no force in x can be added
    const auto products_both = make_active_operator(compliance, zones.active);
    TangentialSystem both(compliance, zones.active, *products_both, {true, true});
    EXPECT_FALSE(both.set_zones({zones.slipping, zones.tangent, zones.curvature, {}}));
    const auto products_across = make_active_operator(compliance, zones.active);
    TangentialSystem across(compliance, zones.active, *products_across, {false, true});
    EXPECT_TRUE(across.set_zones({zones.slipping, zones.tangent, zones.curvature, {}}));
    // and other zones may follow
    const Zones others(3);
    EXPECT_TRUE(both.set_zones({others.slipping, others.tangent, others.curvature, {}}));
}

}  // namespace
}  // namespace tricontact::tangential_system_test
