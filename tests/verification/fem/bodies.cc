// Bodies other than the sphere by finite elements, beside boundary elements on the same layer.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "bem/model.h"
#include "contact/cells.h"
#include "contact/run.h"
#include "fem/settings.h"
#include "tests/paths.h"
#include "tests/verification/bodies_cases.h"
#include "tests/verification/fem/rig.h"

namespace tricontact::fem::fem_bodies_test {
namespace {

using contact::Case;
using contact::History;

class FemBodies : public testing::TestWithParam<verification::Body> {};

TEST_P(FemBodies, AgreeWithBoundaryElements) {
    Case c = verification::body_case(GetParam().shape, GetParam().exponent);
    c.contact.coupling = true;
    c.substrate.poisson = .4;
    c.layer.thickness = 6e-3;
    c.load.press_steps = 3;
    c.load.tangential_ratio = .4;
    c.rolling = Case::Rolling{};
    c.rolling->amplitude = .3 * contact::half_space_scales(c).contact_radius;
    c.rolling->steps_per_quarter = 1;
    c.rolling->periods = 1;
    c.of<contact::Cells>().per_radius = 16;
    const auto half = contact::half_space_scales(c).half_widths;
    c.of<fem::Settings>().size = std::min(half[0], half[1]) / 4.5;
    c.of<fem::Settings>().cache = paths::layer_cache();
    const History fem = contact::run(c, *make_layer_model(c));
    const History bem = contact::run(c, *bem::make_model(c, 1, bem::Body::layer));
    // Some five elements in the contact radius, whose edge cuts them.
    EXPECT_NEAR(fem.scales.indentation / bem.scales.indentation, 1, .01);
    // Of the point whose pressure is infinite under a tip, which an element blurs.
    const double at_centre = contact::has_conical_tip(c) ? .05 : .02;
    EXPECT_NEAR(fem.scales.unit_shift / bem.scales.unit_shift, 1, at_centre);
    EXPECT_NEAR(fem.static_shift / bem.static_shift, 1, .02);
    EXPECT_NEAR(fem.shift_per_period.back() / bem.shift_per_period.back(), 1, .03);
    EXPECT_NEAR(fem.limit_tangential_ratio / bem.limit_tangential_ratio, 1, .02);
}

std::vector<verification::Body> tested_bodies() {
    auto all = verification::bodies();
    all.push_back({"Profile", Case::Shape::profile, 0});
    return all;
}
INSTANTIATE_TEST_SUITE_P(Layer, FemBodies, testing::ValuesIn(tested_bodies()),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace tricontact::fem::fem_bodies_test
