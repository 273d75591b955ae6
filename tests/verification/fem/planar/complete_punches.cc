// Blocks with sharp edges on thick blocks: the pressure at the edge is infinite as a power of the
// distance, which the wedge's corner has by itself.

#include <gtest/gtest.h>

#include "tests/unit/fem/planar/two_bodies.h"

namespace tricontact::complete_punches_test {
namespace {

using namespace planar_test;

/// s of the force within r from the edge, r^s, between two distances. Nodes lie from the middle to
/// the edge; forces of those between r and the edge, half of the node at r.
double exponent(const Pressed& pressed, const ContactGrid& grid, int near, int far) {
    const auto force = [&](int elements) {
        const std::size_t first = grid.size() - 1 - 2 * elements;
        double sum = pressed.pressure[first] * grid.area[first] / 2;
        for (std::size_t i = first + 1; i < grid.size(); ++i)
            sum += pressed.pressure[i] * grid.area[i];
        return sum;
    };
    return std::log(force(far) / force(near)) / std::log(double(far) / near);
}

// Dundurs and Lee (1972), the same nu = .3, an angle of 90 degrees: E of the punch over that of the
// block. The next powers of the distance, and elements at the corner that do not know the
// singularity, leave .02.
TEST(FemPlanarCompletePunches, PressureRisesWithTheWedgesPower) {
    struct Case {
        double ratio, power;  // 0: rigid
    };
    for (const Case& c : {Case{0, .5}, Case{10, .555744}, Case{1, .774013}, Case{.1, .962214}}) {
        const Sizes sizes{96, 1. / 96, 1.2, 12};
        std::vector<CondensedSection> bodies;
        if (c.ratio > 0)
            bodies.push_back(body_of(block_section(sizes, 1, 2, [](double) { return 0.; }),
                                     Solid::plane_strain, {2 * c.ratio, .3}, Support::even));
        bodies.push_back(body_of(layer_section(sizes, 60, 60), Solid::plane_strain, {2, .3}));
        const ContactGrid grid = grid_between(bodies);
        PairOptions options;
        options.halves = true;
        options.is_whole_face = true;
        const Pressed pressed = press(bodies, grid, options, std::vector<double>(grid.size(), 0),
                                      {contact::NormalControl::Kind::force, 1e-3});
        EXPECT_NEAR(exponent(pressed, grid, 4, 8), c.power, .02) << c.ratio;
    }
}

}  // namespace
}  // namespace tricontact::complete_punches_test
