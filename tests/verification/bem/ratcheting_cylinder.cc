// The rolling cylinder beyond its limit: the shift per period beside Carter's rolling, and beside
// the layer that is as thick as a half-space.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "bem/model.h"
#include "contact/cells.h"
#include "contact/half_space_scales.h"
#include "contact/run.h"
#include "theory/oscillating_cylinder.h"

namespace tricontact::bem_ratcheting_cylinder_test {
namespace {

using contact::Case;

/// The rig of the thesis' section 5.1.3 as docs/explanation/cylinder.md has it: w over the model's
/// half width.
Case rig(double w, double f, int cells, int steps_per_quarter) {
    Case c;
    c.indenter.shape = Case::Shape::cylinder;
    c.indenter.radius = 40e-3;
    c.indenter.length = 80e-3;
    c.substrate = {3.6e6, .5};
    c.friction.coefficient = .79;
    c.load.normal_force = 32.3;
    c.load.tangential_ratio = f;
    c.rolling.emplace();
    c.rolling->amplitude_ratio = w;
    c.rolling->amplitude_reference = Case::AmplitudeReference::model;
    c.rolling->steps_per_quarter = steps_per_quarter;
    c.rolling->periods = 12;
    c.rolling->run_all = true;
    c.contact.coupling = false;
    c.of<contact::Cells>().per_radius = cells;
    return c;
}

/// Du of the last period [m].
double increment(const Case& c, bem::Body body = bem::Body::half_space) {
    const auto history = contact::run(c, *bem::make_model(c, 1, body));
    const auto& shift = history.shift_per_period;
    return shift.back() - shift[shift.size() - 2];
}

// A way of 2 W that is long beside the contact is rolled in steady state but for its beginning,
// with Carter's creepage. Steps of a cell: first order in both together.
TEST(BemRatchetingCylinder, FarBeyondTheLimitRollsAsCarters) {
    for (const double f : {.3, .7}) {
        std::vector<double> slopes;
        for (const int cells : {12, 17, 24}) {
            const auto at = [&](int w) {
                Case c = rig(w, f, cells, w * cells);
                c.indenter.length *= 250;  // the strip's own length, (a/L)^2, does not count
                *c.load.normal_force *= 250;
                c.rolling->periods = 2;  // alike from the first one on
                return c;
            };
            const Case c = at(3);
            const auto scales = contact::half_space_scales(c);
            const double lambda = contact::line_shift_factor(
                c.materials(), c.indenter.length / scales.contact_radius);
            slopes.push_back((increment(at(4)) - increment(c)) / scales.unit_shift /
                             theory::line_steady_slope(f, lambda));
        }
        const double order = std::log((1 - slopes[0]) / (1 - slopes[2])) / std::log(24. / 12.);
        EXPECT_NEAR(order, 1, .15) << f;
        EXPECT_GT(slopes[1], slopes[0]);
        EXPECT_NEAR(2 * slopes[2] - slopes[0], 1, 2e-3) << f;
    }
}

// Du is made in and near the contact: in metres the datum of the displacements does not matter, the
// layer's rigid ground as little as the half-space's length. An entry of the table in
// docs/explanation/cylinder.md, with its numerical error.
TEST(BemRatchetingCylinder, ThickLayerRatchetsAsTheHalfSpace) {
    constexpr double entry = .2087, error = .0029;  // w = 0.52, f_T = 0.7
    Case c = rig(.52, .7, 24, 12);
    const double half_space = increment(c);
    c.layer.thickness = .25;
    const double layer = increment(c, bem::Body::layer);
    EXPECT_NEAR(layer / half_space, 1, 2e-3);  // (a/b)^2 and (a/L)^2
    EXPECT_NEAR(layer / contact::half_space_scales(c).unit_shift, entry, error);
}

}  // namespace
}  // namespace tricontact::bem_ratcheting_cylinder_test
