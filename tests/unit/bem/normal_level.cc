#include "bem/normal_level.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "bem/grid_compliance.h"
#include "bem/influence.h"
#include "bem/periodic_compliance.h"
#include "contact/solvers/grid_transfer.h"
#include "contact/solvers/normal_newton.h"

namespace tricontact::normal_level_test {
namespace {

using bem::GridConvolution;
using bem::NormalLevel;
using contact::ContactPoints;
using contact::NormalControl;
using contact::NormalGrid;
using contact::NormalSolution;
using Kind = NormalControl::Kind;

constexpr double e_star = 4, spacing = .02;
const contact::MaterialPair materials{std::nullopt, contact::Material{3, .5}};

/// Padded to (4k - 1) cells at least, so that there is a coarser one.
class Level {
  public:
    Level(int n_x, int n_y, int period_x, int period_y, int n_threads = 1)
        : cell_(materials, spacing, spacing),
          convolution_(n_x, n_y, period_x, period_y, n_threads),
          symbol_(convolution_.symbol(
              [&](int i, int j) { return cell_.at(i * spacing, j * spacing).zz; })),
          level_(convolution_, symbol_, spacing * spacing) {}

    const NormalLevel& operator*() const { return level_; }

  private:
    bem::RectangleInfluence cell_;
    GridConvolution convolution_;
    GridConvolution::Symbol symbol_;
    NormalLevel level_;
};

std::vector<double> field(std::size_t n) {
    std::vector<double> f(n);
    for (std::size_t k = 0; k < n; ++k) f[k] = std::sin(.7 * (k + 1.) * (k + 1.));
    return f;
}

// What a coarse grid does is by definition what the fine one does to squares of four cells.
TEST(NormalLevel, CoarserIsTheMeanOfSquares) {
    struct Size {
        int n_x, n_y, period_x, period_y;
    };
    for (const auto& [n_x, n_y, period_x, period_y] :
         {Size{80, 72, 80, 72}, Size{80, 72, 160, 144}, Size{68, 90, 140, 180}}) {
        const Level fine(n_x, n_y, period_x, period_y);
        const auto coarse = (*fine).coarser();
        ASSERT_TRUE(coarse);
        ASSERT_EQ(coarse->n_x(), n_x / 2);
        ASSERT_EQ(coarse->n_y(), n_y / 2);
        EXPECT_EQ(coarse->cell_area(), 4 * (*fine).cell_area());
        const auto p = field(static_cast<std::size_t>(n_x / 2) * (n_y / 2));
        std::vector<double> u(p.size()), whole(static_cast<std::size_t>(n_x) * n_y);
        for (int j = 0; j < n_y; ++j)
            for (int i = 0; i < n_x; ++i) whole[j * n_x + i] = p[j / 2 * (n_x / 2) + i / 2];
        coarse->displace(p, u);
        (*fine).displace(whole, whole);
        const auto means = contact::to_coarser(whole, n_x, n_y, 1);
        for (std::size_t k = 0; k < u.size(); ++k)
            ASSERT_NEAR(u[k], means[k], 1e-13 * spacing / e_star * 100) << k;
    }
}

TEST(NormalLevel, CoarsensWhatIsLargeAndHalvesEvenly) {
    EXPECT_FALSE((*Level(64, 64, 128, 128)).coarser());
    EXPECT_FALSE((*Level(81, 70, 162, 140)).coarser());
    const auto odd = (*Level(81, 71, 164, 144)).coarser();
    ASSERT_TRUE(odd);
    EXPECT_EQ(odd->n_x(), 41);
    EXPECT_EQ(odd->n_y(), 36);
}

TEST(NormalLevel, PreconditionerIsPositiveAndSymmetric) {
    const Level level(70, 81, 140, 168);
    const std::size_t n = 70 * 81;
    const auto a = field(n);
    std::vector<double> b(n), m_a(n), m_b(n);
    for (std::size_t k = 0; k < n; ++k) b[k] = std::cos(.3 * static_cast<double>(k * k));
    (*level).precondition(a, m_a);
    (*level).precondition(b, m_b);
    double aa = 0, bb = 0, ab = 0, ba = 0;
    for (std::size_t k = 0; k < n; ++k) {
        aa += a[k] * m_a[k], bb += b[k] * m_b[k];
        ab += a[k] * m_b[k], ba += b[k] * m_a[k];
    }
    EXPECT_GT(aa, 0);
    EXPECT_GT(bb, 0);
    EXPECT_NEAR(ab, ba, 1e-12 * std::sqrt(aa * bb));
}

TEST(GridTransfer, KeepsWhatIsUniformAndSkipsWhatIsInfinite) {
    std::vector<double> height(5 * 3, 2.);
    height[0] = height[1] = height[5] = height[6] = INFINITY;  // a whole square
    height[2] = INFINITY;
    const auto coarse = contact::to_coarser(height, 5, 3, 1);
    ASSERT_EQ(coarse.size(), 6u);
    EXPECT_EQ(coarse[0], INFINITY);
    for (std::size_t k = 1; k < 6; ++k) EXPECT_EQ(coarse[k], 2);
    for (const double p : contact::to_finer(std::vector<double>(6, 3.), 5, 3, 1)) EXPECT_EQ(p, 3);
}

/// Waves on a ball that ends at its rim, over n_x * n_y cells.
std::vector<double> wavy_ball(int n_x, int n_y) {
    std::vector<double> height;
    for (int j = 0; j < n_y; ++j)
        for (int i = 0; i < n_x; ++i) {
            const double x = (i - n_x / 2 + .3) * spacing, y = (j - n_y / 2 - .2) * spacing;
            const double r = std::hypot(x, y), waves = std::sin(20 * x) * std::cos(13 * y);
            height.push_back(r < .8 ? r * r / 2 + .004 * (1 + waves) : INFINITY);
        }
    return height;
}

/// The conditions that define the one solution.
void expect_contact(const NormalGrid& grid, const std::vector<double>& height,
                    const NormalSolution& s, double tolerance) {
    std::vector<double> u(height.size());
    grid.displace(s.pressure, u);
    double force = 0;
    for (std::size_t i = 0; i < u.size(); ++i) {
        const double gap = u[i] + height[i] - s.indentation;
        ASSERT_GE(s.pressure[i], 0);
        ASSERT_GE(gap, -tolerance * s.length);
        ASSERT_LE(s.pressure[i] > 0 ? gap : 0, tolerance * s.length);
        ASSERT_EQ(s.displacement[i], u[i]);
        force += grid.cell_area() * s.pressure[i];
    }
    EXPECT_NEAR(s.force / force, 1, 1e-12);
    EXPECT_LE(s.residual, tolerance);
}

TEST(NormalNewton, SolvesByForceAndByDepthOnAnyGrid) {
    constexpr double tolerance = 1e-9, force = .3;
    struct Size {
        int n_x, n_y, period_x, period_y;
    };
    for (const auto& [n_x, n_y, period_x, period_y] :
         {Size{96, 80, 192, 160}, Size{97, 83, 196, 168}, Size{40, 97, 80, 194}}) {
        const Level level(n_x, n_y, period_x, period_y);
        const auto height = wavy_ball(n_x, n_y);
        const contact::NormalNewton newton(*level, tolerance);
        NormalSolution by_force, by_depth, again;
        ASSERT_TRUE(newton.solve(height, {Kind::force, force}, {}, by_force));
        expect_contact(*level, height, by_force, tolerance);
        EXPECT_NEAR(by_force.force, force, 1e-13);
        ASSERT_TRUE(newton.solve(height, {Kind::indentation, by_force.indentation}, {}, by_depth));
        expect_contact(*level, height, by_depth, tolerance);
        // gaps of 1e-9 d times the stiffness of single cells, 1/(h E*) over a/(d E*)
        EXPECT_NEAR(by_depth.force / force, 1, 1e-7);
        ASSERT_TRUE(newton.solve(height, {Kind::force, force}, by_force.pressure, again));
        EXPECT_EQ(again.iterations, 1);
    }
}

TEST(NormalNewton, ThreadsDoNotChangeABit) {
    constexpr int n = 256;
    const auto height = wavy_ball(n, n);
    NormalSolution one, three;
    ASSERT_TRUE(contact::NormalNewton(*Level(n, n, 2 * n, 2 * n, 1), 1e-6)
                    .solve(height, {Kind::force, .3}, {}, one));
    ASSERT_TRUE(contact::NormalNewton(*Level(n, n, 2 * n, 2 * n, 3), 1e-6)
                    .solve(height, {Kind::force, .3}, {}, three));
    EXPECT_EQ(one.pressure, three.pressure);
    EXPECT_EQ(one.displacement, three.displacement);
    EXPECT_EQ(one.indentation, three.indentation);
    EXPECT_EQ(one.iterations, three.iterations);
}

// Hertz: a^3 = 3 F R/(4 E*), d = a^2/R; the solver takes it on a large grid by itself.
TEST(NormalNewton, FindsHertzOnALargeGrid) {
    constexpr int n = 320;
    constexpr double h = 1. / n, radius = 3, a = .4, first = -.5 * (n - 1) * h;
    const auto half_space =
        bem::half_space_compliance(materials, ContactPoints::grid(n, n, {first, first}, {h, h}), 1);
    ASSERT_TRUE(half_space->normal_grid());
    const auto& points = half_space->points();
    std::vector<double> height;
    for (std::size_t i = 0; i < points.size(); ++i)
        height.push_back((points.x[i] * points.x[i] + points.y[i] * points.y[i]) / (2 * radius));
    const double force = 4 * e_star * a * a * a / (3 * radius);
    const auto s = contact::NormalSolver(*half_space, 1e-8).solve(height, {Kind::force, force});
    expect_contact(*half_space->normal_grid(), height, s, 1e-8);
    EXPECT_LT(s.iterations, 40);
    // The depth of cells of h/a = 1/128: second order, about (h/a)^2.
    EXPECT_NEAR(s.indentation / (a * a / radius), 1, 2e-4);
}

// Johnson, Greenwood and Higginson (1985): p = p* [1 + (cos 2 pi x/l + cos 2 pi y/l)/2] E*..., full
// contact of a two-dimensional wave under more than sqrt(2) pi E* Delta/l.
TEST(NormalNewton, FindsFullContactOfAPeriodicWave) {
    constexpr int n = 320;
    constexpr double h = 1. / n, amplitude = .01;
    const bem::PeriodicCompliance half_space(materials, ContactPoints::grid(n, n, {0, 0}, {h, h}),
                                             1);
    ASSERT_TRUE(half_space.normal_grid());
    std::vector<double> height;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
            height.push_back(amplitude *
                             (1 - std::cos(2 * M_PI * i * h) * std::cos(2 * M_PI * j * h)));
    // u = 2 p/(E* q), q = 2 pi sqrt(2): the pressure that bends the surface after the wave.
    const double wave = M_PI * std::sqrt(2.) * e_star * amplitude, mean = 1.5 * wave;
    const auto s = contact::NormalSolver(half_space, 1e-8).solve(height, {Kind::force, mean});
    // A wave of 320 cells: K of squares differs by (pi/320)^2/6 from that of waves.
    for (int j = 0; j < n; j += 7)
        for (int i = 0; i < n; i += 7)
            ASSERT_NEAR(s.pressure[j * n + i] / mean,
                        1 + wave / mean * std::cos(2 * M_PI * i * h) * std::cos(2 * M_PI * j * h),
                        1e-4);
}

}  // namespace
}  // namespace tricontact::normal_level_test
