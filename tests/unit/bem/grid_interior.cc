#include "bem/grid_interior.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bem/grid_compliance.h"

namespace tricontact::bem::grid_interior_test {
namespace {

using contact::ContactPoints;
using contact::Interior;
using contact::Material;
using contact::TangentialField;

constexpr double h = .5e-3;  // cells [m]
const Material rubber{5e6, .4};

struct Loads {
    ContactPoints grid;
    std::vector<double> p;
    TangentialField t;
};

/// Without any symmetry, x longer than y.
Loads some_loads(int n_x, int n_y, double spacing) {
    Loads loads{
        ContactPoints::grid(n_x, n_y, {-n_x / 2 * spacing, -n_y / 2 * spacing}, {spacing, spacing}),
        {},
        TangentialField(n_x * n_y)};
    for (int i = 0; i < n_x * n_y; ++i) {
        loads.p.push_back(1e5 * (1 + std::sin(3. * i)));
        loads.t.x[i] = 3e4 * std::cos(2. * i);
        loads.t.y[i] = 2e4 * std::sin(5. * i);
    }
    return loads;
}

/// The fields are the sum over cells, one by one.
void expect_sum_over_cells(const Loads& loads) {
    const std::vector<double> depths{0, .4e-3, 2e-3};
    const InteriorView view{
        InteriorBody(theory::LayerStack{{{rubber, 3e-3}}, theory::LayerBase::bonded, {}}), depths,
        1};
    const Interior fields = grid_interior(view, loads.grid, loads.p, loads.t);
    const InteriorInfluence cell(view.body, {h, h}, depths, 20e-3);
    ASSERT_EQ(fields.axes[2], (std::vector<double>{-2e-3, -.4e-3, 0}));
    for (std::size_t k = 0; k < fields.size(); k += 5) {
        const auto [x, y, z] = fields.position(k);
        const std::size_t level = z == 0 ? 0 : z > -1e-3 ? 1 : 2;
        theory::InteriorResponse due;
        for (std::size_t i = 0; i < loads.p.size(); ++i) {
            const auto one = cell.at(level, x - loads.grid.x[i], y - loads.grid.y[i]);
            for (int load = 0; load < 3; ++load) {
                const double by = load == 0 ? loads.t.x[i] : load == 1 ? loads.t.y[i] : loads.p[i];
                for (int c = 0; c < 3; ++c)
                    due.displacement[c][0] += by * one.displacement[c][load];
                for (int c = 0; c < 6; ++c) due.stress[c][0] += by * one.stress[c][load];
            }
        }
        for (int c = 0; c < 3; ++c)  // z out of the substrate
            EXPECT_NEAR(fields.displacement[k][c], (c == 2 ? -1 : 1) * due.displacement[c][0],
                        1e-12 * 1e5 * h / rubber.young);
        for (int c = 0; c < 6; ++c)
            EXPECT_NEAR(fields.stress[k][c], (c >= 4 ? -1 : 1) * due.stress[c][0], 1e-11 * 1e5);
    }
}

TEST(GridInterior, IsTheSumOverAllCells) {
    expect_sum_over_cells(some_loads(9, 6, h));
}

// Periods are shorter where edges are free of load, on one side more than on the other.
TEST(GridInterior, OfALoadBesideTheMiddle) {
    Loads loads = some_loads(9, 6, h);
    for (int i = 0; i < 54; ++i)
        if (i % 9 < 5 || i % 9 > 7 || i / 9 < 1 || i / 9 > 2)
            loads.p[i] = loads.t.x[i] = loads.t.y[i] = 0;
    expect_sum_over_cells(loads);
}

TEST(GridInterior, WithoutLoadNothingMoves) {
    Loads loads = some_loads(9, 6, h);
    for (auto* field : {&loads.p, &loads.t.x, &loads.t.y}) std::ranges::fill(*field, 0);
    const auto fields =
        grid_interior({InteriorBody(rubber), {0, 1e-3}, 1}, loads.grid, loads.p, loads.t);
    for (const auto& u : fields.displacement) EXPECT_EQ(u, (std::array<double, 3>{}));
    for (const auto& stress : fields.stress) EXPECT_EQ(stress, (std::array<double, 6>{}));
}

// Half the work of the tractions, by the contact's own coefficients.
TEST(GridInterior, ForceAndEnergyAreThoseOfTheContact) {
    const Loads loads = some_loads(9, 6, h);
    auto compliance = half_space_compliance({{}, rubber}, loads.grid, 1);
    EXPECT_EQ(compliance->interior(loads.p, loads.t), nullptr);  // nobody told it
    compliance->set_view({InteriorBody(rubber), {0, 1e-3}, 1});
    const auto fields = compliance->interior(loads.p, loads.t);
    const std::size_t n = loads.p.size();
    std::vector<double> u_z(n), by_shear(n);
    TangentialField u(n), by_pressure(n);
    compliance->normal(loads.p, u_z);
    compliance->normal_from_tangential(loads.t, by_shear);
    compliance->tangential(loads.t, u);
    compliance->tangential_from_normal(loads.p, by_pressure);
    double work = 0;
    std::array<double, 3> force{};
    for (std::size_t i = 0; i < n; ++i) {
        work += loads.p[i] * (u_z[i] + by_shear[i]) + loads.t.x[i] * (u.x[i] + by_pressure.x[i]) +
                loads.t.y[i] * (u.y[i] + by_pressure.y[i]);
        force[0] += h * h * loads.t.x[i];
        force[1] += h * h * loads.t.y[i];
        force[2] -= h * h * loads.p[i];
    }
    EXPECT_NEAR(fields->strain_energy / (h * h * work / 2), 1, 1e-12);
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(fields->applied[d], force[d], 1e-12 * -force[2]);
    EXPECT_FALSE(fields->base_reaction);
}

TEST(GridInterior, ThreadsChangeNoBit) {
    const Loads loads = some_loads(9, 6, h);
    InteriorView view{InteriorBody(rubber), {0, 1e-3, 2e-3, 3e-3}, 1};
    const auto one = grid_interior(view, loads.grid, loads.p, loads.t);
    view.n_threads = 3;
    const auto three = grid_interior(view, loads.grid, loads.p, loads.t);
    EXPECT_EQ(one.stress, three.stress);
    EXPECT_EQ(one.displacement, three.displacement);
    EXPECT_EQ(one.strain_energy, three.strain_energy);
}

// 300 cells along x become blocks of 3: the force is kept, and points are few.
TEST(GridInterior, LargeGridsAreTakenByBlocks) {
    const Loads loads = some_loads(300, 8, .1e-3);
    const auto fields =
        grid_interior({InteriorBody(rubber), {0, 1e-3}, 1}, loads.grid, loads.p, loads.t);
    EXPECT_NEAR(fields.axes[0][20] - fields.axes[0][19], .3e-3, 1e-12);
    EXPECT_LT(fields.axes[0].size(), 150U);
    double force = 0;
    for (const double p : loads.p) force -= p * .01e-6;
    EXPECT_NEAR(fields.applied[2] / force, 1, 1e-12);
    // The middle cell is the centre of a block, so that points lie on the contact's own.
    const auto& x = fields.axes[0];
    const auto nearest = std::min_element(x.begin(), x.end(), [&](double a, double b) {
        return std::abs(a - loads.grid.x[149]) < std::abs(b - loads.grid.x[149]);
    });
    EXPECT_NEAR(*nearest, loads.grid.x[149], 1e-12);
}

TEST(GridInterior, DepthsAreFineInTheContactAndEndWhereTheyShould) {
    const auto depths = interior_depths(.05e-3, 4e-3, 12e-3);
    EXPECT_EQ(depths.front(), 0);
    EXPECT_EQ(depths.back(), 12e-3);
    EXPECT_NEAR(depths[1], 4e-3 / 25, 1e-15);
    EXPECT_NEAR(depths[20] - depths[19], depths[1], 1e-15);
    for (std::size_t i = 1; i < depths.size(); ++i) EXPECT_GT(depths[i], depths[i - 1]);
    EXPECT_LT(depths.size(), 45U);
    EXPECT_NEAR(interior_depths(.5e-3, 4e-3, 12e-3)[1], .5e-3, 1e-15);
    EXPECT_EQ(interior_depths(1, 1, .1), (std::vector<double>{0, .1}));
}

}  // namespace
}  // namespace tricontact::bem::grid_interior_test
