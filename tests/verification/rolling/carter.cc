// A cylinder in steady rolling against Carter (1926), over three grids.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "rolling/run.h"
#include "tests/unit/rolling/problems.h"
#include "theory/creep_law.h"

namespace tricontact::rolling_carter_test {
namespace {

using rolling_test::Rig;

constexpr std::array grids = {41, 80, 160};  // cells per half length, one odd

rolling::SteadyRolling roll(double f, int n) {
    const Rig rig{.n = n};
    return rolling::steady_rolling(*rig.row_grid(), rig.row(f));
}

/// Largest errors of the traction over mu p0: at all but the two cells beside either edge, where
/// the pressure of strips is first order only, and away from all square roots of the exact
/// traction.
struct TractionError {
    double largest = 0, smooth = 0;
};
TractionError traction_error(double f, int n) {
    const Rig rig{.n = n};
    const auto s = roll(f, n).surface;
    const double unit = rig.friction * rig.modulus() * rig.half_length / (2 * rig.radius);
    const double end_of_stick = 1 - 2 * theory::carter_stick_ratio(f);
    TractionError error;
    for (int i = 0; i < s.n_x; ++i) {
        const double x = s.x(i) / rig.half_length;
        if (std::abs(x) > 1 - 2. / n) continue;
        const double here =
            std::abs(s.tangential_traction_x[i] / unit - theory::carter_traction(x, f));
        error.largest = std::max(error.largest, here);
        if (std::abs(x) < .9 && std::abs(x - end_of_stick) > .1)
            error.smooth = std::max(error.smooth, here);
    }
    return error;
}

// The slip of a cell is a difference to the next one, half a cell ahead: first order.
TEST(RollingCarter, CreepageConvergesAtFirstOrderAndExtrapolatesToIt) {
    for (const double f : {.2, .5, .8}) {
        std::vector<double> error;
        for (const int n : grids) {
            const double xi = roll(f, n).state.creepage.longitudinal / Rig{.n = n}.creepage();
            error.push_back(xi / theory::carter_creepage_ratio(f) - 1);
        }
        for (std::size_t k = 1; k < error.size(); ++k) {
            const double order =
                std::log(error[k - 1] / error[k]) / std::log(1. * grids[k] / grids[k - 1]);
            EXPECT_NEAR(order, 1, .1) << "f " << f << ", " << grids[k] << " cells";
        }
        EXPECT_LT(std::abs(error.back()), 5e-3) << f;
        EXPECT_NEAR(2 * error[2] - error[1], 0, 3e-4) << f;
    }
}

// Where the boundary of stick falls is known to a cell.
TEST(RollingCarter, StickZoneBeginsAtTheLeadingEdge) {
    for (const double f : {.2, .5, .8})
        for (const int n : grids) {
            const auto state = roll(f, n).state;
            EXPECT_NEAR(state.stick_area / state.contact_area, theory::carter_stick_ratio(f),
                        1.5 / n)
                << f << " " << n;
        }
    const auto finest = roll(.5, 320).state;
    EXPECT_NEAR(finest.stick_area / finest.contact_area, theory::carter_stick_ratio(.5), 3e-3);
}

// First order, but (h/a)^(1/2) where the slip zone begins like a square root: there the error
// depends on where a cell falls.
TEST(RollingCarter, TractionIsTheDifferenceOfTwoEllipses) {
    for (const double f : {.2, .5, .8}) {
        const std::array error = {traction_error(f, 80), traction_error(f, 161),
                                  traction_error(f, 320)};
        EXPECT_NEAR(error[1].smooth / error[0].smooth, .5, .05) << f;
        EXPECT_NEAR(error[2].smooth / error[1].smooth, .5, .05) << f;
        EXPECT_LT(error[2].smooth, 1e-3) << f;
        EXPECT_LT(error[2].largest, .75 * error[0].largest) << f;
        EXPECT_LT(error[2].largest, 1e-2) << f;
    }
}

TEST(RollingCarter, CreepagePrescribedGivesTheForce) {
    const Rig rig{.n = 160};
    for (const double ratio : {.1, .4, .9, 1.3}) {
        auto problem = rig.row(0);
        problem.drive.creepage[0] = ratio * rig.creepage();
        const auto state = rolling::steady_rolling(*rig.row_grid(), problem).state;
        EXPECT_NEAR(state.force[0] / (rig.friction * rig.row_force()),
                    theory::carter_force_ratio(ratio), 3e-3)
            << ratio;
    }
}

// Both of one material: nothing couples, and the relative displacement alone counts.
TEST(RollingCarter, HoldsForTwoElasticBodiesOfOneMaterial) {
    Rig rig{.n = 200};
    rig.substrate = {2e9, .3};
    rig.indenter = rig.substrate;
    const auto state = rolling::steady_rolling(*rig.row_grid(), rig.row(.5)).state;
    EXPECT_NEAR(state.creepage.longitudinal / rig.creepage(), theory::carter_creepage_ratio(.5),
                3e-3 * theory::carter_creepage_ratio(.5));
}

}  // namespace
}  // namespace tricontact::rolling_carter_test
