#include "contact/solvers/projected_gradient.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

namespace tricontact::projected_gradient_test {
namespace {

using contact::TangentialControl;
using contact::TangentialField;

/// The three nodes of a quadratic element that is stretched without end across the load: forces are
/// row sums, displacements by the consistent mass M = [4 2 -1; 2 16 2; -1 2 4]/30. A uniform
/// traction moves all nodes by 1, one in proportion to (1, -1/2, 1) by 2.5 times itself.
class LongElement final : public contact::Compliance {
  public:
    LongElement() {
        points_.x = {0, 0, 0};
        points_.y = {-1, 0, 1};
        points_.area = {1. / 6, 4. / 6, 1. / 6};
        Eigen::Matrix3d mass;
        mass << 4, 2, -1, 2, 16, 2, -1, 2, 4;
        matrix_ = 30 * mass.inverse() * Eigen::Vector3d(1, 4, 1).asDiagonal() / 6;
    }
    const contact::ContactPoints& points() const override { return points_; }
    bool is_coupled() const override { return false; }
    void normal(std::span<const double> p, std::span<double> u_z) const override {
        product(p, u_z);
    }
    void tangential(const TangentialField& t, TangentialField& u) const override {
        product(t.x, u.x);
        product(t.y, u.y);
    }
    double local_tangential() const override { return matrix_.diagonal().mean(); }
    void precondition_tangential(const TangentialField& r, TangentialField& z) const override {
        z = r;
    }

  private:
    void product(std::span<const double> t, std::span<double> u) const {
        Eigen::Map<Eigen::Vector3d>(u.data()) =
            matrix_ * Eigen::Map<const Eigen::Vector3d>(t.data());
    }
    contact::ContactPoints points_;
    Eigen::Matrix3d matrix_;
};

TEST(ProjectedGradient, ConvergesWhereTheLargestModeIsNotUniform) {
    const LongElement compliance;
    TangentialField exact(3), previous(3);
    exact.x = {.5, .05, .5};  // 0.2 + 0.3 (1, -1/2, 1)
    compliance.tangential(exact, previous);
    const std::vector<double> bound(3, 1.);
    const std::array<TangentialControl, 2> control{
        {{TangentialControl::Kind::force, .2}, {TangentialControl::Kind::shift, 0}}};
    contact::TangentialSolution solution;
    solution.traction = solution.displacement = TangentialField(3);
    const std::vector<std::size_t> active{0, 1, 2};
    projected_gradient(compliance, active, *make_active_operator(compliance, active),
                       {bound, previous, control, 1}, 100, solution);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(solution.traction.x[i], exact.x[i], 1e-8);
    EXPECT_NEAR(solution.shift_increment[0], 0, 1e-8);
}

}  // namespace
}  // namespace tricontact::projected_gradient_test
