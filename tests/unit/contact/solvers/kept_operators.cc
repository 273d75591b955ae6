#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "contact/solvers/tangential_solver.h"
#include "tests/unit/contact/dense_compliance.h"

namespace tricontact::kept_operators_test {
namespace {

using contact::TangentialControl;
using contact::TangentialField;
using contact::TangentialSolution;
using contact::TangentialSolver;
using contact_test::DenseCompliance;

/// The tangential part of a compliance as a matrix too, by columns of 3 n.
class ExposedCompliance final : public contact::Compliance {
  public:
    explicit ExposedCompliance(const DenseCompliance& of) : of_(of) {
        const auto n = static_cast<Eigen::Index>(points().size());
        Eigen::MatrixXd all = Eigen::MatrixXd::Zero(3 * n, 3 * n);
        all.topLeftCorner(2 * n, 2 * n) = of.tangential_matrix();
        matrix_.assign(all.data(), all.data() + all.size());
    }
    const contact::ContactPoints& points() const override { return of_.points(); }
    bool is_coupled() const override { return false; }
    void normal(std::span<const double> p, std::span<double> u_z) const override {
        of_.normal(p, u_z);
    }
    void tangential(const TangentialField& t, TangentialField& u) const override {
        of_.tangential(t, u);
    }
    double local_tangential() const override { return of_.local_tangential(); }
    void precondition_tangential(const TangentialField& r, TangentialField& z) const override {
        of_.precondition_tangential(r, z);
    }
    const double* dense() const override { return matrix_.data(); }

  private:
    const DenseCompliance& of_;
    std::vector<double> matrix_;
};

// Contacts of which each lacks two points, more than are kept, between those that come back: to the
// last bit what a solver finds that has seen no other.
TEST(KeptOperators, ContactsThatComeBackAreSolvedAsBefore) {
    constexpr int n = 60;
    constexpr double tolerance = 1e-10;
    const DenseCompliance all(n, 12);
    const ExposedCompliance compliance(all);
    TangentialSolver one(compliance, tolerance);
    const TangentialField at_rest(n);
    const auto solve = [&](int i, int k, bool compare) {
        std::vector<double> bound(n);
        double total = 0;
        for (int p = 0; p < n; ++p) {
            if (p != i && p != k) bound[p] = .4 + .2 * std::sin(5. * p);
            total += bound[p] * compliance.points().area[p];
        }
        const std::array<TangentialControl, 2> control{
            {{TangentialControl::Kind::force, .6 * total}, {TangentialControl::Kind::force, 0}}};
        const contact::TangentialProblem problem{bound, at_rest, control, 5};
        TangentialSolution found, due;
        one.solve(problem, found);
        if (!compare) return;
        TangentialSolver(compliance, tolerance).solve(problem, due);
        EXPECT_EQ(found.traction.x, due.traction.x) << i << ' ' << k;
        EXPECT_EQ(found.traction.y, due.traction.y) << i << ' ' << k;
        EXPECT_EQ(found.shift_increment[0], due.shift_increment[0]) << i << ' ' << k;
    };
    const auto come_back = [&] {
        for (int again = 0; again < 3; ++again)
            for (int i = 0; i < 6; ++i) solve(i, i + 1, true);
    };
    come_back();
    for (int i = 0; i < n; ++i)
        for (int k = i + 1; k < std::min(i + 12, n); ++k) solve(i, k, (i + k) % 16 == 0);
    come_back();
}

}  // namespace
}  // namespace tricontact::kept_operators_test
