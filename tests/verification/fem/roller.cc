// The ends of a roller on the finite element layer.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/verification/fem/line_rig.h"

namespace tricontact::fem::fem_roller_test {
namespace {

using contact::Case;

/// Pressure on the line x = 0 over the exact line contact's, by the distance from the end [m].
std::map<double, double> along_the_middle(Case c, double depth) {
    c.indenter.length = .02;
    c.load.normal_force = 32.3 / 4;
    c.layer.depth = depth;
    const auto model = make_layer_model(c);
    press(*model, c);
    const contact::Surface s = model->surface();
    const double p0 = exact_line(c).centre_pressure;
    std::map<double, double> pressure;
    for (std::size_t i = 0; i < s.size(); ++i)
        if (s.node_x[i] == 0 && s.node_y[i] >= 0)
            pressure[c.indenter.length / 2 - s.node_y[i]] = s.normal_traction[i] / p0;
    return pressure;
}

// Without lateral contraction plane strain has no lateral stress: flush ends change nothing. Row
// sums at the very end stand for half a line of nodes, and are left out.
TEST(FemRoller, FlushEndsChangeNothingWithoutLateralContraction) {
    const auto p = along_the_middle(roller_case(.8e-3, 0), .02);
    for (const auto& [distance, ratio] : p) {
        if (distance <= 0) continue;
        EXPECT_NEAR(ratio, p.rbegin()->second, 5e-3) << distance;
    }
}

// An incompressible layer is stiff by what surrounds it: at the free face less than half is left,
// where plane stress of the contact's own line would leave 1 - nu^2.
TEST(FemRoller, FlushEndsOfAnIncompressibleLayerCarryLittle) {
    const auto p = along_the_middle(roller_case(.8e-3), .02);
    EXPECT_LT(std::next(p.begin())->second, .5 * .75 * p.rbegin()->second);
    EXPECT_GT(p.rbegin()->second, 1);  // the middle carries it
}

// p ~ y^(-1/2) at a sharp rigid edge; -0.23 of two equal materials is far off. Between nodes 0.1 mm
// and 0.05 mm from it, a fortieth of the half width, the regular part takes some of the slope.
TEST(FemRoller, SharpEndsOnALayerThatGoesOnAreSingular) {
    const auto p = along_the_middle(roller_case(.4e-3), .04);
    const auto near = std::next(p.begin()), next = std::next(near);
    const double slope =
        std::log(next->second / near->second) / std::log(next->first / near->first);
    EXPECT_NEAR(slope, -.5, .1);
}

}  // namespace
}  // namespace tricontact::fem::fem_roller_test
