// Differences of surfaces of other grids, springs and nodes.

#include "comparisons/differences/surface_difference.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/comparisons/nodes.h"

namespace tricontact::comparisons::surface_difference_test {
namespace {

using contact::Surface;
using synthetic::as_irregular_nodes;

template <class Function>
Surface grid_of(int n, double spacing, const Function& pressure) {
    Surface s;
    s.n_x = s.n_y = n;
    s.spacing = {spacing, spacing};
    s.first = {-spacing * (n - 1) / 2, -spacing * (n - 1) / 2};
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) s.normal_traction.push_back(pressure(s.x(i), s.y(j)));
    s.tangential_traction_x = s.displacement_x = s.normal_traction;
    s.tangential_traction_y.assign(s.size(), 0);
    s.contact_state.assign(s.size(), contact::ContactState::stick);
    return s;
}

double plane_field(double x, double y) {
    return 5 + 2 * x - y;
}

double hertz(double x, double y) {
    const double r2 = x * x + y * y;
    return r2 < 1 ? std::sqrt(1 - r2) : 0;
}

// Fields that are linear are the same on any grid: what is left is rounding.
TEST(SurfaceDifference, LinearFieldsDoNotDiffer) {
    const Surface fine = grid_of(41, .05, plane_field), coarse = grid_of(21, .1, plane_field);
    const Surface nodes = as_irregular_nodes(grid_of(21, .1, plane_field), [](double x, double y) {
        return contact::Vector2{x, y};
    });
    for (const auto& [a, b] : {std::pair{fine, coarse}, {coarse, fine}, {nodes, fine}}) {
        const SurfaceDifference d = difference_of(a, b);
        EXPECT_EQ(d.a.n_x, 41);
        EXPECT_LT(std::abs(d.pressure.value), 1e-12);
        EXPECT_LT(d.traction.l2, 1e-12);
        ASSERT_EQ(d.of(&Surface::displacement_x).size(), 41u * 41u);
        EXPECT_TRUE(d.of(&Surface::displacement_y).empty());
    }
}

// What is added is what differs, and where.
TEST(SurfaceDifference, LargestIsWhereItWasPut) {
    const Surface b = grid_of(21, .1, plane_field);
    Surface a = b;
    a.normal_traction[5 * 21 + 3] -= .25;
    const SurfaceDifference d = difference_of(a, b);
    EXPECT_NEAR(d.pressure.value, -.25, 1e-12);
    EXPECT_NEAR(d.pressure.place[0], b.x(3), 1e-12);
    EXPECT_NEAR(d.pressure.place[1], b.y(5), 1e-12);
    EXPECT_NEAR(d.pressure.over, 8, 1e-12);
    EXPECT_EQ(d.traction.value, 0);
}

// Springs tell pressures by the distance from the axis: Hertz' (1882) on either is the same but for
// the straight lines between springs, h^2/8 p'' inside and sqrt(2h) in the last one of 1e-3 a.
TEST(SurfaceDifference, SpringsStandForABodyOfRevolution) {
    Surface line;
    line.layout = Surface::Layout::line;
    line.n_x = 2401, line.n_y = 1;
    line.first = {-1.2, 0};
    line.spacing = {1e-3, 0};
    for (int i = 0; i < line.n_x; ++i) line.normal_traction.push_back(hertz(line.x(i), 0));
    line.displacement_x = line.normal_traction;
    const SurfaceDifference d = difference_of(line, grid_of(41, .05, hertz));
    EXPECT_EQ(d.a.n_y, 41);
    EXPECT_LT(std::abs(d.pressure.value), std::sqrt(2e-3));
    EXPECT_LT(d.pressure.l2, 1e-3);
    EXPECT_TRUE(d.of(&Surface::displacement_x).empty());
    const SurfaceDifference of_springs = difference_of(line, line);
    EXPECT_EQ(of_springs.a.n_y, 1);
    EXPECT_EQ(of_springs.pressure.value, 0);
    EXPECT_LE(of_springs.a.n_x, 2001);
}

TEST(SurfaceDifference, ModelsAreComparedInTheLastStateThatBothHave) {
    const auto history = [](const char* model, std::vector<double> phases, double factor) {
        contact::History h;
        h.model = model;
        for (const double phase : phases)
            h.snapshots.push_back(
                {phase, grid_of(11, .2, [&](double x, double y) { return factor * hertz(x, y); })});
        return h;
    };
    const auto differences = model_differences(
        {history("bem-layer", {0, 1, 2}, 1), history("fem", {0, 1}, 1.5), history("mdr", {}, 1)});
    ASSERT_EQ(differences.size(), 1u);
    EXPECT_EQ(differences[0].name_a, "fem");
    EXPECT_EQ(differences[0].phase, 1);
    EXPECT_NEAR(differences[0].pressure.value, .5, 1e-12);
    EXPECT_NEAR(differences[0].pressure.l2, .5, 1e-12);
    EXPECT_EQ(difference_figures(differences[0], "x").size(), 2u);
    EXPECT_EQ(difference_files({"bem-layer", "fem"}),
              std::vector<std::string>{"difference_fem_bem-layer.vti"});
    EXPECT_FALSE(difference_section({}, {}, {}));
    EXPECT_TRUE(difference_section(differences, {}, {}));
}

}  // namespace
}  // namespace tricontact::comparisons::surface_difference_test
