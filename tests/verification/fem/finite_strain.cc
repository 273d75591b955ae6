// The rig on a neo-Hookean layer: what finite strains change. References are those of a prototype,
// a program of its own (other elements' code, other contact solver), extrapolated from three
// meshes; an axisymmetric computation by GetFEM agrees (docs/explanation/peers.md).

#include <gtest/gtest.h>

#include "tests/verification/fem/strained_rig.h"

namespace tricontact::fem::finite_strain_test {
namespace {

using contact::Case;
using contact::History;

contact::Vector2 place(const contact::Surface& s, std::size_t i) {
    return {s.node_x[i] + s.displacement_x[i], s.node_y[i] + s.displacement_y[i]};
}

/// Of each node, seen from above [m^2]: its share of its elements' areas, by their corners and
/// middles of edges. Other code than the model's own.
std::vector<double> projected_areas(const contact::Surface& s) {
    std::vector<double> area(s.size());
    for (const auto& quad : s.quads) {
        double twice = 0;
        for (int k = 0; k < 8; ++k) {  // around: corner, middle, corner, ...
            const auto around = [&](int at) {
                return place(s, quad[at % 2 == 0 ? at / 2 : 4 + at / 2]);
            };
            const auto a = around(k), b = around((k + 1) % 8);
            twice += a[0] * b[1] - a[1] * b[0];
        }
        for (int k = 0; k < 9; ++k)
            area[quad[k]] += std::abs(twice) / 2 * (k < 4 ? 1. : k < 8 ? 4. : 16.) / 36;
    }
    return area;
}

/// sqrt(5/2 <r^2>) of the pressure: Hertz' contact radius, but no matter of single nodes. [m]
double effective_radius(const contact::Surface& s, double normal_force) {
    const std::vector<double> area = projected_areas(s);
    double force = 0, moment = 0;
    for (std::size_t i = 0; i < s.size(); ++i) {
        const auto x = place(s, i);
        force += area[i] * s.normal_traction[i];
        moment += area[i] * s.normal_traction[i] * contact::dot(x, x);
    }
    // It is the true pressure on the true surface that carries F_N; nodes' areas are not exact.
    EXPECT_NEAR(force / normal_force, 1, 1e-3);
    return std::sqrt(2.5 * moment / force);
}

struct Pressed {
    double indentation, effective_radius, peak_pressure;
};

Pressed pressed(contact::Model& model, const Case& c) {
    const contact::StepRecord record = press(model, c);
    EXPECT_TRUE(model.audit().passed());
    contact::Surface surface = model.surface();
    if (c.law == Case::Law::linear)  // its tractions act on the undeformed surface
        for (auto* u : {&surface.displacement_x, &surface.displacement_y})
            u->assign(surface.size(), 0);
    return {record.indentation, effective_radius(surface, record.normal_force),
            model.scales().peak_pressure};
}

struct Body {
    const char* name;
    Case::Shape shape;
    Pressed reference;  // [m], [m], [Pa]
};
class FiniteStrainOfBody : public ::testing::TestWithParam<Body> {};

// Beside the linear layer under the paraboloid: .32292 mm, 4.3572 mm, .5330 MPa. Elements of .7 mm
// add 1e-4 to d, 4e-4 to the radius and, in row sums, 4e-3 to the pressure at the centre; less to
// their changes.
TEST_P(FiniteStrainOfBody, NormalContact) {
    Case c = strained_case(.7e-3);
    c.indenter.shape = GetParam().shape;
    const Pressed strained = pressed(*BothModels(c).strained, c);
    c.law = Case::Law::linear;
    c.indenter.shape = Case::Shape::paraboloid;  // on the same mesh
    const Pressed linear = pressed(*make_layer_model(c), c);
    const auto& [d, a, p] = GetParam().reference;
    EXPECT_NEAR(strained.indentation / d, 1, 3e-4);
    EXPECT_NEAR(strained.effective_radius / a, 1, 1e-3);
    EXPECT_NEAR(change(strained.indentation, linear.indentation), change(d, .32292e-3), 1.5e-4);
    EXPECT_NEAR(change(strained.effective_radius, linear.effective_radius), change(a, 4.3572e-3),
                5e-4);
    EXPECT_NEAR(change(strained.peak_pressure, linear.peak_pressure), change(p, .5330e6), 3e-4);
}

INSTANTIATE_TEST_SUITE_P(
    Rig, FiniteStrainOfBody,
    ::testing::Values(Body{"Paraboloid", Case::Shape::paraboloid, {.32363e-3, 4.3724e-3, .5291e6}},
                      Body{"Sphere", Case::Shape::sphere, {.32399e-3, 4.3703e-3, .5296e6}}),
    [](const auto& test) { return std::string(test.param.name); });

Case sheared_case(double size) {
    Case c = strained_case(size);
    c.load.tangential_force.reset();
    c.load.tangential_ratio = .56;
    c.load.press_steps = 8;
    return c;
}

double static_shift(contact::Model& model, const Case& c) {
    const History history = contact::run(c, model);
    EXPECT_TRUE(history.audit.passed());
    return history.static_shift;
}

// The prototype: .1490 +- .0003 mm, -1.65 % of the linear one. Elements of .7 mm add .1 % to both.
TEST(FiniteStrain, StaticShift) {
    const Case c = sheared_case(.7e-3);
    const BothModels both(c);
    const double linear = static_shift(*both.linear, c), strained = static_shift(*both.strained, c);
    EXPECT_NEAR(strained, .1490e-3, .0003e-3);
    EXPECT_NEAR(change(strained, linear), -.0165, 3e-4);
}

// The prototype: .2068 +- .0005 mm beside .2142 mm of the linear layer. Elements of 1 mm take .2 %
// off both; turning points take .13 % off this one, but nothing off the linear (steps of .35 mm:
// .2065 and .2138).
TEST(FiniteStrain, SettledShiftByTurningPoints) {
    Case c = sheared_case(1e-3);
    c.load.press_steps = 1;
    c.rolling.emplace();
    c.rolling->amplitude = .24 * 4.3638e-3;  // of the linear contact radius
    c.rolling->steps = Case::Steps::turning_points;
    const BothModels both(c);
    const History linear = contact::run(c, *both.linear),
                  strained = contact::run(c, *both.strained);
    EXPECT_TRUE(strained.audit.passed());
    const double settled = strained.shift_per_period.back();
    EXPECT_NEAR(settled, .2068e-3, .0005e-3 + .002 * .2068e-3);
    EXPECT_NEAR(change(settled, linear.shift_per_period.back()), change(.2068, .2142),
                .0005 / .2068);
}

// Rolling there and back leads back: what a settled contact still creeps per period falls to
// nothing, on a paraboloid, which does not stay itself, as on a sphere.
TEST(FiniteStrain, ASettledContactDoesNotCreep) {
    for (const auto shape : {Case::Shape::paraboloid, Case::Shape::sphere}) {
        Case c = sheared_case(2e-3);
        c.indenter.shape = shape;
        c.load.tangential_ratio = .3;
        c.load.press_steps = 1;
        c.rolling.emplace();
        c.rolling->amplitude = .5e-3;
        c.rolling->steps = Case::Steps::turning_points;
        c.rolling->periods = 7;
        c.rolling->run_all = true;
        const History history = contact::run(c, *make_layer_model(c));
        const auto& u = history.shift_per_period;
        EXPECT_LT(std::abs(u[6] - u[5]), 1e-7 * history.scales.unit_shift);
    }
}

struct Changes {
    double indentation, shift;
};
Changes changes(Case c) {
    c.load.press_steps = 5;
    const BothModels both(c);
    const History linear = contact::run(c, *both.linear),
                  strained = contact::run(c, *both.strained);
    EXPECT_TRUE(strained.audit.passed());
    return {change(strained.scales.indentation, linear.scales.indentation),
            change(strained.static_shift, linear.static_shift)};
}

// A tenth of the strains: d/a and a/R of the same contact radius.
TEST(FiniteStrain, ChangesFallWithTheStrains) {
    Case c = sheared_case(1.4e-3);
    const Changes full = changes(c);
    c.indenter.radius = .4;
    c.load.normal_force = 2.11;
    const Changes tenth = changes(c);
    // What is of second order is 1 % of the strains: a tenth of itself in the shift.
    EXPECT_NEAR(full.indentation / tenth.indentation, 10, .5);
    EXPECT_NEAR(full.shift / tenth.shift, 10, 1);
}

// K/G, as a user would say it: by Poisson's ratio at the same E. What the linear layer does.
TEST(FiniteStrain, IncompressibleIsALimit) {
    const auto history = [](double bulk_ratio) {
        Case c = sheared_case(1.4e-3);
        c.load.press_steps = 3;
        c.substrate.poisson = (3 * bulk_ratio - 2) / (2 * (3 * bulk_ratio + 1));
        return contact::run(c, *make_layer_model(c));
    };
    const History loose = history(1e4), tight = history(1e6);
    EXPECT_NEAR(change(loose.scales.indentation, tight.scales.indentation), 0, 1e-4);
    EXPECT_NEAR(change(loose.static_shift, tight.static_shift), 0, 1e-4);
}

}  // namespace
}  // namespace tricontact::fem::finite_strain_test
