#include "contact/compliances/interior.h"

#include <gtest/gtest.h>

#include <numeric>

#include "fem/condensation.h"
#include "fem/q2_space.h"
#include "tests/unit/fem/layer_problems.h"

namespace tricontact::interior_test {
namespace {

using contact::Interior;
using fem::Discretisation;
using Point = std::array<double, 3>;

constexpr double bottom = -2.5e-3, volume = 6e-3 * 6e-3 * 2.5e-3;

// What a block looks like whose displacement grows linearly from its base.
class ConstantState {
  public:
    ConstantState(fem::LayerProblem problem, const Point& slope, double poisson)
        : material_{3e6, poisson}, slope_(slope) {
        problem.materials = {material_, material_};
        const Discretisation layer(problem);
        std::vector<double> u(layer.unknowns.n);
        const auto heights = heights_of_unknowns(problem, layer);
        for (std::size_t k = 0; k < u.size(); ++k)
            u[k] = slope[layer.unknowns.direction_of_unknown[k]] * (heights[k] - bottom);
        state = layer.interior({u}, std::vector<double>(u.size(), 0.));
    }

    std::array<double, 6> stress() const {
        const double g = material_.shear_modulus();
        const double lambda = 2 * g * material_.poisson / (1 - 2 * material_.poisson);
        const double normal = lambda * slope_[2];
        return {normal, normal, normal + 2 * g * slope_[2], 0, g * slope_[1], g * slope_[0]};
    }
    double energy_density() const {
        const auto s = stress();
        return (s[2] * slope_[2] + s[4] * slope_[1] + s[5] * slope_[0]) / 2;
    }

    Interior state;

  private:
    // By moving every node up by its height: the fields are linear in the displacements.
    static std::vector<double> heights_of_unknowns(const fem::LayerProblem& problem,
                                                   const Discretisation& layer) {
        const fem::Q2Space space(problem.mesh);
        std::vector<double> heights;
        for (const int node : layer.unknowns.node_of_unknown)
            heights.push_back(space.nodes[node][2]);
        return heights;
    }

    contact::Material material_;
    Point slope_;
};

TEST(FemInterior, ConstantStatesAreExact) {
    for (const bool half : {false, true})
        for (const Point& slope : {Point{.01, 0, 0}, Point{.01, half ? 0. : .02, -.03}}) {
            auto problem = test::small_layer(half);
            test::distort(problem.mesh, .1e-3);
            const ConstantState exact(problem, slope, .3);
            const double scale = exact.energy_density() / .01;
            for (const auto& stress : exact.state.stress)
                for (int k = 0; k < 6; ++k)
                    ASSERT_NEAR(stress[k], exact.stress()[k], 1e-11 * scale);  // rounding
            for (const double w : exact.state.energy_density)
                ASSERT_NEAR(w / exact.energy_density(), 1, 1e-11);
            EXPECT_NEAR(exact.state.strain_energy / (volume * exact.energy_density()), 1, 1e-11);
        }
}

// The base is pulled back by the stress on it. Boxes, where stresses on opposite sides cancel.
TEST(FemInterior, ConstantStatesPullAtTheBase) {
    for (const bool half : {false, true}) {
        const ConstantState exact(test::small_layer(half), {.01, half ? 0. : .02, -.03}, .3);
        const auto s = exact.stress();
        const double area = 36e-6;
        const Point reaction{-s[5] * area, -s[4] * area, -s[2] * area};
        for (int d = 0; d < 3; ++d)
            EXPECT_NEAR(exact.state.base_reaction->at(d), reaction[d], 1e-12 * s[2] * -area);
    }
}

// A layer under forces on all of its contact patch.
struct Pressed {
    explicit Pressed(const fem::LayerProblem& problem)
        : layer(problem), force(layer.unknowns.n, 0.) {
        fem::Condensation condensation(layer.assemble().matrix, layer.unknowns.node_of_unknown,
                                       layer.unknowns.n_interior);
        condensation.factorise();
        for (int u = layer.unknowns.n_interior; u < layer.unknowns.n; ++u)
            force[u] = std::sin(3. * u) - (layer.unknowns.direction_of_unknown[u] == 2);
        displacement = condensation.solve(force);
        state = layer.interior({displacement}, force);
    }
    double work() const {
        return std::inner_product(force.begin(), force.end(), displacement.begin(), 0.) / 2;
    }

    Discretisation layer;
    std::vector<double> force, displacement;
    Interior state;
};

TEST(FemInterior, ForcesAndEnergyBalance) {
    const Pressed pressed(test::small_layer());
    const auto& [layer, force, displacement, state] = pressed;
    Point applied{};
    for (std::size_t u = 0; u < force.size(); ++u)
        applied[layer.unknowns.direction_of_unknown[u]] += force[u];
    for (int d = 0; d < 3; ++d) {
        EXPECT_DOUBLE_EQ(state.applied[d], applied[d]);
        // The rounding of entries of K/G = 1e6.
        EXPECT_NEAR(state.base_reaction->at(d), -applied[d], 1e-8 * std::abs(applied[2]));
    }
    EXPECT_NEAR(state.strain_energy / pressed.work(), 1, 1e-8);
    double energy = 0;
    for (std::size_t h = 0; h < state.hexes.size(); ++h) {
        double box = 1;  // corners 0 and 6 are opposite
        for (int d = 0; d < 3; ++d)
            box *=
                std::abs(state.points[state.hexes[h][6]][d] - state.points[state.hexes[h][0]][d]);
        energy += box * state.energy_density[h];
    }
    EXPECT_NEAR(energy / state.strain_energy, 1, 1e-12);
}

TEST(FemInterior, HalfModelSpeaksForBothHalves) {
    const Pressed pressed(test::small_layer(true));
    EXPECT_NEAR(pressed.state.strain_energy / (2 * pressed.work()), 1, 1e-8);
    EXPECT_EQ(pressed.state.applied[1], 0);
    EXPECT_EQ(pressed.state.base_reaction->at(1), 0);
    for (const int d : {0, 2}) {
        double sum = 0;
        for (std::size_t u = 0; u < pressed.force.size(); ++u)
            if (pressed.layer.unknowns.direction_of_unknown[u] == d) sum += pressed.force[u];
        EXPECT_DOUBLE_EQ(pressed.state.applied[d], 2 * sum);
        EXPECT_NEAR(pressed.state.base_reaction->at(d), -2 * sum,
                    1e-8 * std::abs(pressed.state.applied[2]));
    }
}

TEST(FemInterior, RegionsShareNoPoints) {
    const Pressed pressed(test::small_layer());
    const auto& state = pressed.state;
    const std::size_t upper = 9 * 13 * 5, lower = 9 * 13 * 3;  // 4 x 6 x 2 and 4 x 6 x 1 elements
    ASSERT_EQ(state.points.size(), upper + lower);
    ASSERT_EQ(state.displacement.size(), state.points.size());
    ASSERT_EQ(state.stress.size(), state.points.size());
    ASSERT_EQ(state.hexes.size(), 72u);
    std::vector<int> region_of_point(state.points.size(), -1);
    for (std::size_t h = 0; h < state.hexes.size(); ++h)
        for (const int point : state.hexes[h]) {
            int& region = region_of_point[point];
            EXPECT_TRUE(region < 0 || region == state.region[h]);
            region = state.region[h];
            EXPECT_EQ(state.points[point][2] <= -1.2e-3,
                      region == 1 || state.points[point][2] == -1.2e-3);
        }
    // Both sides of the interface move alike.
    int n_pairs = 0;
    for (std::size_t p = 0; p < state.points.size(); ++p)
        for (std::size_t q = p + 1; q < state.points.size(); ++q)
            if (state.points[p] == state.points[q]) {
                EXPECT_EQ(state.displacement[p], state.displacement[q]);
                ++n_pairs;
            }
    EXPECT_EQ(n_pairs, 9 * 13);
}

}  // namespace
}  // namespace tricontact::interior_test
