#include "io/results/whole_interior.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>

namespace tricontact::io::whole_interior_test {
namespace {

using contact::Interior;
using Point = std::array<double, 3>;

// Local coordinates -1, 0, 1 of VTK's 27 nodes (vtkTriQuadraticHexahedron.h).
constexpr std::array<std::array<int, 3>, 27> local{
    {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1},  {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1},
     {-1, 1, 1},   {0, -1, -1}, {1, 0, -1},  {0, 1, -1},  {-1, 0, -1}, {0, -1, 1}, {1, 0, 1},
     {0, 1, 1},    {-1, 0, 1},  {-1, -1, 0}, {1, -1, 0},  {1, 1, 0},   {-1, 1, 0}, {-1, 0, 0},
     {1, 0, 0},    {0, -1, 0},  {0, 1, 0},   {0, 0, -1},  {0, 0, 1},   {0, 0, 0}}};

// A field that y = 0 mirrors: u and w, XX, YY, ZZ and XZ even, v, XY and YZ odd in y.
Point displacement_at(const Point& p) {
    const auto& [x, y, z] = p;
    return {x + 2 * y * y - z, y * (1 + 3 * x), 5 * z - x * y * y};
}
std::array<double, 6> stress_at(const Point& p) {
    const auto& [x, y, z] = p;
    return {x + y * y, 2 * z, 3 * x - y * y, y * z, y * (2 + x), x * z};
}

/// Elements of edge 2 from y = first on, side by side along y; local axes turned so that local y
/// is global x in the second.
Interior bodies(const std::vector<double>& firsts) {
    Interior in;
    std::map<Point, int> number;
    for (std::size_t e = 0; e < firsts.size(); ++e) {
        auto& hex = in.hexes.emplace_back();
        for (std::size_t k = 0; k < local.size(); ++k) {
            const auto [a, b, c] = local.at(k);
            const Point p = e % 2 == 0 ? Point{1. + a, firsts[e] + 1 + b, c - 1.}
                                       : Point{1. - b, firsts[e] + 1 + a, c - 1.};
            const auto [at, is_new] = number.try_emplace(p, static_cast<int>(in.points.size()));
            if (is_new) {
                in.points.push_back(p);
                in.displacement.push_back(displacement_at(p));
                in.stress.push_back(stress_at(p));
            }
            hex.at(k) = at->second;
        }
        in.region.push_back(static_cast<std::uint8_t>(e % 2));
        in.energy_density.push_back(1. + static_cast<double>(e));
    }
    in.strain_energy = 7;
    return in;
}

TEST(WholeInterior, HasTheFieldsOfBothSides) {
    const Interior half = bodies({0, 2});
    ASSERT_TRUE(is_half(half));
    const Interior whole = with_mirror_image(half);
    EXPECT_EQ(whole.points.size(), 2 * half.points.size() - 9);  // 9 on the plane
    for (std::size_t i = 0; i < whole.points.size(); ++i) {
        EXPECT_EQ(whole.displacement[i], displacement_at(whole.points[i]));
        EXPECT_EQ(whole.stress[i], stress_at(whole.points[i]));
    }
    EXPECT_EQ(whole.region, (std::vector<std::uint8_t>{0, 1, 0, 1}));
    EXPECT_EQ(whole.energy_density, (std::vector{1., 2., 1., 2.}));
    EXPECT_EQ(whole.strain_energy, 7);
    EXPECT_FALSE(is_half(whole));
}

// Every node is where its local coordinates put it, and volumes are positive, as in the half.
TEST(WholeInterior, ElementsKeepTheirOrderOfNodes) {
    const Interior whole = with_mirror_image(bodies({0, 2}));
    ASSERT_EQ(whole.hexes.size(), 4u);
    for (const auto& hex : whole.hexes) {
        const auto node = [&](std::size_t k) {
            return whole.points[static_cast<std::size_t>(hex.at(k))];
        };
        const auto edge = [&](std::size_t k) {
            const Point a = node(0), b = node(k);
            return Point{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
        };
        const Point u = edge(1), v = edge(3), w = edge(4);
        EXPECT_DOUBLE_EQ(w[2] * (u[0] * v[1] - u[1] * v[0]), 8);
        for (std::size_t k = 0; k < local.size(); ++k)
            for (std::size_t d = 0; d < 3; ++d)
                EXPECT_DOUBLE_EQ(node(k).at(d), node(0).at(d) +
                                                    (local.at(k)[0] + 1) / 2. * u.at(d) +
                                                    (local.at(k)[1] + 1) / 2. * v.at(d) +
                                                    (local.at(k)[2] + 1) / 2. * w.at(d))
                    << k;
    }
}

// What the plane would share with its image has no shear across it.
TEST(WholeInterior, OfThePlaneTheMeanOfBothSidesIsKept) {
    Interior half = bodies({0});
    for (auto& stress : half.stress) stress = {1, 2, 3, 4, 5, 6};
    const Interior whole = with_mirror_image(half);
    for (std::size_t i = 0; i < whole.points.size(); ++i) {
        const double y = whole.points[i][1], side = y > 0 ? 1 : y < 0 ? -1 : 0;
        EXPECT_EQ(whole.stress[i], (std::array{1., 2., 3., side * 4., side * 5., 6.}));
    }
}

TEST(WholeInterior, OthersAreNoHalf) {
    EXPECT_FALSE(is_half(bodies({-2, 0})));
    EXPECT_FALSE(is_half(bodies({1})));  // does not touch the plane
    EXPECT_FALSE(is_half(bodies({-2})));
    Interior grid;
    grid.axes = {std::vector<double>{0, 1}, {0, 1}, {0, 1}};
    EXPECT_FALSE(is_half(grid));
}

}  // namespace
}  // namespace tricontact::io::whole_interior_test
