#include "fem/finite_strain/strained_body.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "tests/unit/fem/finite_strain/strained_block.h"
#include "tests/unit/fem/layer_problems.h"

namespace tricontact::strained_body_test {
namespace {

using fem::StrainedBody;
using fem::StrainedState;
using test::BlockSpec;
using test::StrainedBlock;
using test::Tensor;

constexpr double rounding = 1e-12;  // of a few thousand operations on numbers of order 1

Tensor stress_of(const StrainedBlock& block, const Tensor& f) {
    StrainedBody::Response response;
    block.body.evaluate(block.state_of(f), response);
    return StrainedBlock::cauchy(block.piola(response.force), f);
}

BlockSpec block_of(double c01_ratio) {
    BlockSpec spec;
    spec.c01_ratio = c01_ratio;
    return spec;
}

// Rivlin (1948), Treloar (1975), ch. 5: sigma_zz - sigma_xx = 2 (l^2 - 1/l) (c10 + c01/l).
TEST(StrainedBody, UniaxialStretchIsTheClosedForm) {
    for (const double c01_ratio : {0., .3}) {
        const StrainedBlock block(block_of(c01_ratio));
        const double g = block.shear_modulus;
        for (const double l : {.6, .95, 1.3, 2.}) {
            const Tensor stress = stress_of(block, test::uniaxial(l));
            const double exact = g * (l * l - 1 / l) * (1 - c01_ratio + c01_ratio / l);
            EXPECT_NEAR((stress(2, 2) - stress(0, 0)) / g, exact / g, rounding);
            EXPECT_NEAR((stress(1, 1) - stress(0, 0)) / g, 0, rounding);
            EXPECT_NEAR((stress - Tensor(stress.diagonal().asDiagonal())).norm() / g, 0, rounding);
        }
    }
}

// Rivlin (1948): sigma_xz = 2 (c10 + c01) gamma, sigma_xx - sigma_yy = 2 c10 gamma^2,
// sigma_yy - sigma_zz = 2 c01 gamma^2.
TEST(StrainedBody, SimpleShearIsTheClosedForm) {
    for (const double c01_ratio : {0., .3}) {
        const StrainedBlock block(block_of(c01_ratio));
        const double g = block.shear_modulus;
        for (const double gamma : {-.2, .5, 1.5}) {
            const Tensor stress = stress_of(block, test::simple_shear(gamma));
            EXPECT_NEAR(stress(0, 2) / g, gamma, rounding);
            EXPECT_NEAR((stress(0, 0) - stress(1, 1)) / g, (1 - c01_ratio) * gamma * gamma,
                        rounding);
            EXPECT_NEAR((stress(1, 1) - stress(2, 2)) / g, c01_ratio * gamma * gamma, rounding);
        }
    }
}

// A patch test: under uniform strain and mean stress, of any volume, nodes inside are in balance.
TEST(StrainedBody, UniformStressLeavesNodesInsideInBalance) {
    const StrainedBlock block(block_of(.3));
    Tensor f;
    f << 1.2, .3, -.1, .2, .9, .4, -.3, .1, 1.1;
    auto state = block.state_of(f);
    // The mean stress p in each element: all in the first function, 1/sqrt(volume).
    const double p = 2e6;
    StrainedBody::Response response;
    block.body.evaluate(state, response);
    const double j = f.determinant();
    for (std::size_t c = 0; c < state.mean_stress.size(); ++c) {
        const double root = response.excess_volume[c][0] / (j - 1);  // of the element's volume
        state.mean_stress[c] = {p * root, 0, 0, 0};
    }
    block.body.evaluate(state, response);
    const Tensor stress = StrainedBlock::cauchy(block.piola(response.force), f);
    const double g = block.shear_modulus;
    const Tensor b = std::pow(j, -2. / 3) * f * f.transpose();
    const Tensor exact = test::mooney_rivlin(b, .35 * g, .15 * g) / j + p * Tensor::Identity();
    EXPECT_NEAR((stress - exact).norm() / exact.norm(), 0, rounding);
    int n_inside = 0;
    const double scale = g * 1e-6;  // stress times the block's area
    for (std::size_t i = 0; i < block.nodes().size(); ++i) {
        const auto x = block.position(i);
        if (std::abs(x[0]) > .999e-3 || std::abs(x[1]) > .749e-3 || x[2] > -1e-6 || x[2] < -.999e-3)
            continue;
        ++n_inside;
        for (int a = 0; a < 3; ++a) EXPECT_NEAR(response.force[3 * i + a] / scale, 0, rounding);
    }
    EXPECT_EQ(n_inside, 27);  // of 5 x 5 x 5
}

/// Random displacements [m] of all nodes but those held, and mean stresses [Pa m^3/2].
StrainedState random_state(const fem::Discretisation& layer, const StrainedBody& body,
                           double displacement, double mean_stress) {
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> uniform(-1, 1);
    StrainedState state = body.at_rest();
    for (std::size_t i = 0; i < layer.unknowns.of_node.size(); ++i)
        for (int a = 0; a < 3; ++a)
            if (layer.unknowns.of_node[i][a] >= 0)
                state.displacement[3 * i + a] = displacement * uniform(generator);
    for (auto& amplitudes : state.mean_stress)
        for (double& amplitude : amplitudes) amplitude = mean_stress * uniform(generator);
    return state;
}

struct TwoLayers {
    explicit TwoLayers()
        : problem([] {
              auto distorted = test::small_layer();
              test::distort(distorted.mesh, .2e-3);
              return distorted;
          }()),
          layer(problem),
          body(layer, {.2, .4}) {}
    fem::LayerProblem problem;
    fem::Discretisation layer;
    StrainedBody body;
};

// A rotated strained body has the same energy, and forces rotated with it.
TEST(StrainedBody, RotationRotatesForces) {
    const TwoLayers two;
    const auto state = random_state(two.layer, two.body, 30e-6, 1e2);
    const Tensor r = test::rotation(2.1, {1, -2, .5});
    StrainedState rotated = state;
    for (std::size_t i = 0; i < two.layer.space.nodes.size(); ++i) {
        const Eigen::Vector3d x(two.layer.space.nodes[i].data());
        const Eigen::Vector3d u(&state.displacement[3 * i]);
        Eigen::Map<Eigen::Vector3d>(&rotated.displacement[3 * i]) = r * (x + u) - x;
    }
    StrainedBody::Response response, of_rotated;
    two.body.evaluate(state, response);
    two.body.evaluate(rotated, of_rotated);
    // Displacements are now of the size of the body, a hundred times larger.
    EXPECT_NEAR(of_rotated.energy / response.energy, 1, 1e3 * rounding);
    double largest = 0, error = 0;
    for (std::size_t i = 0; i < two.layer.space.nodes.size(); ++i) {
        const Eigen::Vector3d force(&response.force[3 * i]);
        largest = std::max(largest, force.norm());
        error = std::max(error, (r * force - Eigen::Vector3d(&of_rotated.force[3 * i])).norm());
    }
    EXPECT_LT(error / largest, 1e3 * rounding);
}

// Forces are the derivative of int W + q (J - 1) - q^2/(2K), which is energy + q excess.
TEST(StrainedBody, ForcesAreTheDerivativeOfTheEnergy) {
    const TwoLayers two;
    const auto state = random_state(two.layer, two.body, 30e-6, 1e2);
    StrainedBody::Response response;
    two.body.evaluate(state, response);
    const auto direction = random_state(two.layer, two.body, 1., 0.).displacement;
    const double exact =
        std::inner_product(direction.begin(), direction.end(), response.force.begin(), 0.);
    const auto potential = [&](double step) {
        auto moved = state;
        for (std::size_t i = 0; i < direction.size(); ++i)
            moved.displacement[i] += step * direction[i];
        StrainedBody::Response of_moved;
        two.body.evaluate(moved, of_moved);
        double sum = of_moved.energy;
        for (std::size_t c = 0; c < moved.mean_stress.size(); ++c)
            for (int m = 0; m < 4; ++m)
                sum += moved.mean_stress[c][m] * of_moved.excess_volume[c][m];
        return sum;
    };
    // Central differences of the fourth order: 1e-7 m is 1e-2 of the displacements; O(1e-8).
    const double h = 3e-7;
    const double derivative =
        (8 * (potential(h) - potential(-h)) - (potential(2 * h) - potential(-2 * h))) / (12 * h);
    EXPECT_NEAR(derivative / exact, 1, 1e-7);
}

// The stiffness is assembled by other code, with other quadrature points' functions: deal.II's.
TEST(StrainedBody, SmallStrainsAreTheLinearStiffness) {
    const TwoLayers two;
    const auto stiffness = test::dense(two.layer.assemble().matrix);
    std::vector<double> errors;
    for (const double amplitude : {1e-8, .5e-8, .25e-8}) {  // strains of 1e-4
        const auto state = random_state(two.layer, two.body, amplitude, 0);
        StrainedBody::Response response;
        two.body.evaluate(state, response);
        Eigen::VectorXd u(two.layer.unknowns.n), force(two.layer.unknowns.n);
        for (int k = 0; k < two.layer.unknowns.n; ++k) {
            const auto component =
                3 * static_cast<std::size_t>(two.layer.unknowns.node_of_unknown[k]) +
                two.layer.unknowns.direction_of_unknown[k];
            u[k] = state.displacement[component];
            // Without mean stress, all of it is what the excess volume would make.
            force[k] = response.effective_force[component];
        }
        const Eigen::VectorXd linear = stiffness * u;
        errors.push_back((force - linear).norm() / linear.norm());
    }
    EXPECT_LT(errors.back(), 1e-4);
    for (const double order : test::orders(errors)) EXPECT_NEAR(order, 1, .02);
}

// E and J - 1 lose no digits: Cauchy stress of a strain of 1e-9 to rounding of itself.
TEST(StrainedBody, TinyStrainsLoseNoDigits) {
    const StrainedBlock block(block_of(.3));
    const double gamma = 1e-9, g = block.shear_modulus;
    StrainedBody::Response response;
    block.body.evaluate(block.state_of(test::simple_shear(gamma)), response);
    EXPECT_NEAR(block.piola(response.force)(0, 2) / (g * gamma), 1, rounding);
    EXPECT_NEAR(response.energy / (g * gamma * gamma / 2 * StrainedBlock::volume), 1, rounding);
}

}  // namespace
}  // namespace tricontact::strained_body_test
