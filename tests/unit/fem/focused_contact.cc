#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "contact/compliances/focused_compliance.h"
#include "contact/friction/friction.h"
#include "contact/surface_model.h"
#include "fem/dense_compliance.h"

// Coupled contact by a matrix, solved on the points that may touch.

namespace tricontact::focused_contact_test {
namespace {

using contact::ContactPoints;
using contact::norm;
using contact::operator-;
using contact::TangentialField;
using fem::DenseCompliance;

constexpr int n_x = 24, n_y = 16;

/// Softened kernels of Boussinesq and Cerruti of a compressible half-space, in units of the grid.
std::shared_ptr<const DenseCompliance> half_space() {
    constexpr double nu = .3;
    ContactPoints points =
        ContactPoints::grid(n_x, n_y, {-(n_x - 1) / 2., -(n_y - 1) / 2.}, {1, 1});
    const std::size_t n = points.size();
    std::vector<double> matrix(9 * n * n);
    const auto entry = [&](std::size_t c, std::size_t i, std::size_t d, std::size_t j) -> double& {
        return matrix[3 * n * (d * n + j) + c * n + i];
    };
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            const double x = points.x[i] - points.x[j], y = points.y[i] - points.y[j];
            const double s = std::sqrt(x * x + y * y + (i == j ? .08 : .2)), s3 = s * s * s;
            entry(0, i, 0, j) = (1 - nu) / s + nu * x * x / s3;
            entry(1, i, 1, j) = (1 - nu) / s + nu * y * y / s3;
            entry(0, i, 1, j) = entry(1, i, 0, j) = nu * x * y / s3;
            entry(2, i, 2, j) = (1 - nu) / s;
            // Pressure draws the surface towards it; friction lowers what lies ahead of it.
            entry(0, i, 2, j) = entry(2, j, 0, i) = -(.5 - nu) * x / (s * s);
            entry(1, i, 2, j) = entry(2, j, 1, i) = -(.5 - nu) * y / (s * s);
        }
    return std::make_shared<const DenseCompliance>(points, std::move(matrix));
}

/// Two paraboloids, the second higher up.
class TwoBumps final : public contact::Indenter {
  public:
    explicit TwoBumps(double higher) : higher_(higher) {}
    double height(double x, double y) const override {
        const double far = x - 9;
        return std::min((x * x + y * y) / 40, higher_ + (far * far + y * y) / 40);
    }
    contact::Vector2 slope(double x, double y) const override {
        return {(height(x + 1e-4, y) - height(x - 1e-4, y)) / 2e-4,
                (height(x, y + 1e-4) - height(x, y - 1e-4)) / 2e-4};
    }

  private:
    double higher_;
};

TEST(FocusedContact, ProductsAmongSomePointsAreThoseAmongAll) {
    const auto all = half_space();
    contact::FocusedCompliance focused(*all);
    const std::size_t n = all->points().size();
    std::vector<std::size_t> some;
    for (std::size_t i = 0; i < n; ++i)
        if (std::hypot(all->points().x[i] - 2, all->points().y[i]) < 4.3) some.push_back(i);
    std::vector<double> p(n), u(n), u_all(n);
    TangentialField t(n), v(n), v_all(n);
    for (const std::size_t i : some) {
        p[i] = 1 + std::sin(static_cast<double>(i));
        t.set(i, {std::cos(static_cast<double>(i)), std::sin(2. * static_cast<double>(i))});
    }
    focused.focus(some);
    ASSERT_TRUE(focused.is_focused());
    const double rounding = 1e-14 * static_cast<double>(some.size());
    const auto expect_same = [&] {
        for (const std::size_t i : some) EXPECT_NEAR(u[i], u_all[i], rounding) << i;
    };
    focused.normal(p, u);
    all->normal(p, u_all);
    expect_same();
    focused.normal_from_tangential(t, u);
    all->normal_from_tangential(t, u_all);
    expect_same();
    focused.tangential_from_normal(p, v);
    all->tangential_from_normal(p, v_all);
    for (const std::size_t i : some) EXPECT_LT(norm(v.at(i) - v_all.at(i)), rounding) << i;
    focused.focus_on_all();
    focused.normal(p, u);
    all->normal(p, u_all);
    EXPECT_EQ(u, u_all);
}

// A second bump comes down where nothing was expected to touch: the gap is nowhere negative, closed
// where there is pressure, and friction is that of the law, whatever points it was looked for on.
TEST(FocusedContact, FindsContactFarFromTheLastOne) {
    const auto compliance = half_space();
    constexpr double tolerance = 1e-8, mu = .4;
    contact::SurfaceModel model("model", compliance, std::make_shared<TwoBumps>(.8),
                                contact::Friction{mu}.law(), tolerance);
    contact::LoadStep step;
    step.normal = {contact::NormalControl::Kind::indentation, .6};
    step.tangential[0] = {contact::TangentialControl::Kind::shift, .05};
    int touching = 0;
    for (const double depth : {.6, 1.05, 1.1, .7, 1.1}) {
        step.normal.value = depth;
        step.phase += .1;
        step.recurs = false;
        step.tangential[0].value += .05;
        model.advance(step);
        ASSERT_TRUE(model.audit().passed()) << depth;
        const contact::Surface s = model.surface();
        std::vector<double> u(s.gap.size()), lowering(u.size());
        compliance->normal(s.normal_traction, u);
        TangentialField t(u.size());
        t.x = s.tangential_traction_x;
        t.y = s.tangential_traction_y;
        compliance->normal_from_tangential(t, lowering);
        bool far = false;
        for (std::size_t i = 0; i < u.size(); ++i) {
            const double x = compliance->points().x[i], y = compliance->points().y[i];
            const double gap = u[i] + lowering[i] + TwoBumps(.8).height(x, y) - depth;
            ASSERT_GE(gap, -2 * tolerance * depth) << i;
            ASSERT_NEAR(s.gap[i], gap, 1e-12);
            if (!(s.normal_traction[i] > 0)) continue;
            ASSERT_LE(gap, 2 * tolerance * depth) << i;
            ASSERT_LE(norm(t.at(i)), mu * s.normal_traction[i] * (1 + 1e-12));
            far = far || x > 6;
        }
        touching += far;
        EXPECT_EQ(far, depth > 1) << depth;
    }
    EXPECT_EQ(touching, 3);
}

}  // namespace
}  // namespace tricontact::focused_contact_test
