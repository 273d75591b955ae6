// Bodies other than the sphere on the half-space: closed forms of frictionless contact, superposed
// normal contacts for the static shift, least pressures for the limit of shakedown.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "contact/cells.h"
#include "contact/load_path.h"
#include "tests/verification/bem/rig.h"
#include "tests/verification/bodies_cases.h"
#include "theory/rolling/body_rolling.h"

namespace tricontact::bem::bem_bodies_test {
namespace {

using contact::Case;

struct Errors {
    double indentation, radius, unit_shift;
};

Errors errors_of(const Case& c) {
    const auto model = make_model(c, 1);
    model->advance(contact::press_step(c));
    const contact::Scales s = model->scales();
    const contact::HalfSpaceScales exact = contact::half_space_scales(c);
    return {s.indentation / exact.indentation - 1, s.contact_radius / exact.contact_radius - 1,
            s.unit_shift / exact.unit_shift - 1};
}

class BemBodies : public testing::TestWithParam<verification::Body> {};

TEST_P(BemBodies, ArePressedAsTheClosedFormsSay) {
    for (const double nu : {0., .5}) {
        Case c = verification::body_case(GetParam().shape, GetParam().exponent);
        c.substrate.poisson = nu;
        c.of<contact::Cells>().per_radius = 22.5;
        const Errors e = errors_of(c);
        // 0.2 % are demanded.
        EXPECT_NEAR(e.indentation, 0, 1e-3);
        EXPECT_NEAR(e.unit_shift, 0, 1e-3);
        EXPECT_NEAR(e.radius, 0, 1e-2);  // cells are counted: a fifth of one along the edge
    }
}

/// Root mean square over six grids: the edge cuts the cells at random.
double mean_error(Case c, double cells_per_radius) {
    constexpr int n_grids = 6;
    double squares = 0;
    for (int k = 0; k < n_grids; ++k) {
        c.of<contact::Cells>().per_radius = cells_per_radius * (1 + k / 48.);
        const double e = errors_of(c).indentation;
        squares += e * e / n_grids;
    }
    return std::sqrt(squares);
}

TEST_P(BemBodies, ConvergeWithTheirOrder) {
    const Case c = verification::body_case(GetParam().shape, GetParam().exponent);
    const double coarse = mean_error(c, 9), fine = mean_error(c, 27);
    const double order = std::log(coarse / fine) / std::log(3.);
    EXPECT_GT(order, 1.5) << coarse << ' ' << fine;
}

// nu = 0: without the transverse traction that the superposition neglects it is exact.
TEST_P(BemBodies, AreShiftedAsSuperposedContacts) {
    Case c = verification::body_case(GetParam().shape, GetParam().exponent);
    c.substrate.poisson = 0;
    for (const double f : {.3, .7}) {
        c.load.tangential_ratio = f;
        const auto history = run_bem(c);
        EXPECT_NEAR(static_ratio(history) / theory::static_shift_ratio(c, f), 1, 2e-3) << f;
    }
}

TEST_P(BemBodies, HaveTheLimitOfTheirLeastPressures) {
    Case c = verification::body_case(GetParam().shape, GetParam().exponent);
    c.rolling = Case::Rolling{};
    c.rolling->steps = Case::Steps::per_quarter;
    c.rolling->steps_per_quarter = 3;  // between the turning points the pressure may be least
    c.rolling->periods = 1;
    c.load.tangential_ratio = .05;
    for (const double w : {.2, .45}) {
        c.rolling->amplitude_ratio = w;
        const auto exact = theory::shakedown_limit(c, w);
        EXPECT_NEAR(run_bem(c).limit_tangential_ratio, *exact, 4e-3) << w;
    }
}

INSTANTIATE_TEST_SUITE_P(HalfSpace, BemBodies, testing::ValuesIn(verification::bodies()),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace tricontact::bem::bem_bodies_test
