// Friction under a cylinder by the finite elements of a slice, beside boundary elements of the
// layer in plane strain and beside exact pressures.

#include <gtest/gtest.h>

#include <functional>

#include "bem/model.h"
#include "contact/cells.h"
#include "tests/verification/fem/line_rig.h"

namespace tricontact::fem::fem_oscillating_cylinder_test {
namespace {

using contact::Case;
using contact::History;

/// Rolling in few steps by an amplitude over the exact half width.
Case rolling_line(double w, double f, double size, double nu = .5) {
    Case c = line_case(size, nu);
    c.load.tangential_force.reset();
    c.load.tangential_ratio = f;
    c.load.press_steps = 5;
    c.rolling.emplace();
    c.rolling->amplitude = w * exact_line(c).half_width;
    c.rolling->steps_per_quarter = 2;
    c.rolling->periods = 6;
    c.rolling->run_all = true;
    return c;
}

History by_elements(const Case& c) {
    History history = contact::run(c, *make_layer_model(c));
    EXPECT_TRUE(history.audit.passed());
    return history;
}

/// Cells of a hundredth of the half width.
History by_waves(Case c) {
    c.of<contact::Cells>().spacing = 2e-5;
    return contact::run(c, *bem::make_model(c, 1, bem::Body::layer));
}

struct Point {
    double w, f;
};
class FemOscillatingCylinder : public testing::TestWithParam<Point> {};

// Elements of a twentieth of the half width. The sides, 8 thicknesses away, and the edges between
// two nodes leave 1e-4 of displacements and static shifts, 1e-3 of what rolling adds, of the limit,
// and of shifts under a small force, which are made where the sticking traction is singular.
TEST_P(FemOscillatingCylinder, AgreesWithTheLayersWaves) {
    const auto [w, f] = GetParam();
    const Case c = rolling_line(w, f, .1e-3);
    const History fem = by_elements(c), bem = by_waves(c);
    EXPECT_NEAR(fem.scales.indentation / bem.scales.indentation, 1, 3e-4);
    EXPECT_NEAR(fem.scales.unit_shift / bem.scales.unit_shift, 1, 3e-4);
    EXPECT_NEAR(fem.limit_tangential_ratio / bem.limit_tangential_ratio, 1, 3e-3);
    EXPECT_NEAR(fem.static_shift / bem.static_shift, 1, f < .1 ? 2e-3 : 1e-3);
    const auto &u = fem.shift_per_period, &v = bem.shift_per_period;
    EXPECT_NEAR(u.back() / v.back(), 1, 2e-3);
    if (f > 1.2 * bem.limit_tangential_ratio) {
        EXPECT_NEAR((u[5] - u[4]) / (v[5] - v[4]), 1, 2e-3);
    }
}
INSTANTIATE_TEST_SUITE_P(Rig, FemOscillatingCylinder,
                         testing::Values(Point{.1, .5}, Point{.26, .3}, Point{.26, .6},
                                         Point{.26, .8}, Point{.52, .3}, Point{.52, .5},
                                         Point{.77, .05}));

using Runner = std::function<History(const Case&)>;

/// Shifts at some forces, static (w = 0) or settled.
std::vector<double> shifts(double w, double size, double nu, const Runner& run) {
    std::vector<double> all;
    for (const double f : {.25, .45, .6}) {
        Case c = rolling_line(w, f, size, nu);
        c.rolling->steps = Case::Steps::turning_points;
        if (w == 0) c.rolling.reset();
        const History history = run(c);
        all.push_back(w == 0 ? history.static_shift : history.shift_per_period.back());
    }
    return all;
}

/// Root mean square of the relative errors.
double error_of(const std::vector<double>& values, const std::vector<double>& exact) {
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) sum += std::pow(values[i] / exact[i] - 1, 2);
    return std::sqrt(sum / static_cast<double>(values.size()));
}

// Edges of contact and stick zone lie anywhere between nodes: the errors of single shifts jump,
// their mean falls by nearly the second order.
TEST(FemOscillatingCylinder, ShiftsConverge) {
    for (const double nu : {.3, .5})
        for (const double w : {0., .26}) {
            const auto bem = shifts(w, 0, nu, by_waves);
            std::vector<double> errors;
            for (const double size : {.8e-3, .2e-3, .05e-3})
                errors.push_back(error_of(shifts(w, size, nu, by_elements), bem));
            EXPECT_GT(order(errors[0], errors[1], 4), 1) << nu << ' ' << w << ' ' << errors[1];
            EXPECT_LT(errors[2], errors[1]) << nu << ' ' << w;
            EXPECT_GT(order(errors[0], errors[2], 16), 1.5) << nu << ' ' << w << ' ' << errors[0];
            EXPECT_LT(errors[2], 2e-4) << nu << ' ' << w;
        }
}

// Without coupling the pressures are those of the exact contact, and so is the load that they keep
// up all along the path.
TEST(FemOscillatingCylinder, LimitIsThatOfTheExactPressures) {
    for (const double w : {.26, .52}) {
        Case c = rolling_line(w, .1, .1e-3);
        c.contact.coupling = false;
        const theory::LineContact exact = exact_line(c);
        const double limit = exact.load_beyond(*c.rolling->amplitude) / exact.load;
        EXPECT_NEAR(by_elements(c).limit_tangential_ratio / limit, 1, 2e-3) << w;
        c.rolling->run_all = false;
        c.rolling->periods = 30;
        for (const double share : {.97, 1.03}) {
            c.load.tangential_ratio = share * limit;
            EXPECT_EQ(by_elements(c).verdict.state,
                      share < 1 ? contact::State::shakedown : contact::State::ratcheting)
                << w;
        }
    }
}

// One relaxation function for all stiffness, and shear that relaxes alone.
TEST(FemOscillatingCylinder, RelaxingLayersAgree) {
    for (const auto bulk :
         {contact::Relaxation::Bulk::proportional, contact::Relaxation::Bulk::elastic}) {
        Case c = rolling_line(.26, .4, .2e-3, .4);
        c.rolling->periods = 2;
        c.load.press_steps = 1;
        c.rolling->speed = 1e-3;
        c.load.hold = 1;
        c.relaxation = contact::Relaxation{{{.8, .5}, {.3, 5}}, bulk};
        const History fem = by_elements(c), bem = by_waves(c);
        EXPECT_NEAR(fem.static_shift / bem.static_shift, 1, 2e-3);
        for (const std::size_t n : {0, 1})
            EXPECT_NEAR(fem.shift_per_period[n] / bem.shift_per_period[n], 1, 2e-3);
        // And it is another answer than the elastic one.
        c.relaxation.reset();
        EXPECT_GT(std::abs(bem.shift_per_period[1] / by_waves(c).shift_per_period[1] - 1), .01);
    }
}

// A layer that glides is held by its sides, 40 thicknesses away. Clamped, they also keep the
// layer's thickness: both displacements that count from there are smaller, what happens in the
// contact is not.
TEST(FemOscillatingCylinder, GlidingLayersAgreeButForTheirDatum) {
    Case c = rolling_line(.26, .5, .2e-3);
    c.layer.base = Case::Base::frictionless;
    const History fem = by_elements(c), bem = by_waves(c);
    EXPECT_NEAR(fem.scales.contact_radius / bem.scales.contact_radius, 1, 2e-3);
    EXPECT_NEAR(fem.scales.peak_pressure / bem.scales.peak_pressure, 1, 2e-3);
    EXPECT_NEAR(fem.limit_tangential_ratio / bem.limit_tangential_ratio, 1, 3e-3);
    EXPECT_NEAR(fem.scales.indentation / bem.scales.indentation, 1, .015);
    EXPECT_NEAR(fem.scales.unit_shift / bem.scales.unit_shift, 1, .035);
    const auto shaken = [](const History& h) { return h.shift_per_period.back() - h.static_shift; };
    EXPECT_NEAR(shaken(fem) / shaken(bem), 1, 5e-3);
}

}  // namespace
}  // namespace tricontact::fem::fem_oscillating_cylinder_test
