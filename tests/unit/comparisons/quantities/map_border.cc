// The share of the normal force at the border of a height map.

#include "comparisons/quantities/map_border.h"

#include <gtest/gtest.h>

#include <memory>

namespace tricontact::comparisons::map_border_test {
namespace {

/// n x n nodes, 1 mm apart.
contact::Case case_of(int n) {
    contact::Case c;
    c.indenter.height_map = std::make_shared<const contact::HeightMap>(contact::HeightMap{
        n, n, {1e-3, 1e-3}, std::vector<double>(static_cast<std::size_t>(n) * n)});
    return c;
}

/// Uniform pressure on cells whose middles are the nodes, but for `outside` rows of cells around.
contact::Surface surface_of(int n, int outside, contact::Vector2 offset = {}) {
    contact::Surface s;
    s.n_x = s.n_y = n + 2 * outside;
    s.spacing = {1e-3, 1e-3};
    s.offset = offset;
    const double first = -(n / 2 + outside) * 1e-3;
    s.first = {first + offset[0], first + offset[1]};
    for (int j = 0; j < s.n_y; ++j)
        for (int i = 0; i < s.n_x; ++i) {
            const bool inside = i >= outside && j >= outside && i < n + outside && j < n + outside;
            s.normal_traction.push_back(inside ? 2e5 : 0);
        }
    return s;
}

TEST(MapBorder, CountsTheOutermostCells) {
    for (const int n : {4, 5, 9}) {
        contact::History history;
        history.snapshots = {{0, surface_of(n, 2)}};
        // Exact: all cells carry the same.
        EXPECT_DOUBLE_EQ(*border_force_share(case_of(n), history),
                         1 - (n - 2.) * (n - 2.) / (n * n))
            << n;
    }
}

TEST(MapBorder, GoesWithTheBodyAndIsTheLargestOfAllStates) {
    contact::History history;
    contact::Surface inner = surface_of(9, 1);
    for (int j = 0; j < inner.n_y; ++j)
        for (int i = 0; i < inner.n_x; ++i)
            if (i < 3 || j < 3 || i > 7 || j > 7) inner.normal_traction[j * inner.n_x + i] = 0;
    history.snapshots = {{0, inner}};
    EXPECT_EQ(border_force_share(case_of(9), history), 0.);
    history.snapshots.push_back({1, surface_of(9, 1, {7e-3, -2e-3})});
    EXPECT_DOUBLE_EQ(*border_force_share(case_of(9), history), 32. / 81);
}

TEST(MapBorder, IsOfMapsThatEnd) {
    contact::History history;
    history.snapshots = {{0, surface_of(5, 1)}};
    contact::Case periodic = case_of(5);
    periodic.period = 5e-3;
    EXPECT_FALSE(border_force_share(periodic, history));
    EXPECT_FALSE(border_force_share(contact::Case{}, history));
    EXPECT_FALSE(border_force_share(case_of(5), contact::History{}));
}

}  // namespace
}  // namespace tricontact::comparisons::map_border_test
