// Interpolated contacts of a layer beside those of the integral equation, at another scale.

#include "theory/adhesive/disc_table.h"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/bodies/indenter.h"

namespace tricontact::theory::disc_table_test {
namespace {

TEST(DiscTable, IsTheIntegralEquation) {
    for (const double nu : {.3, .5}) {
        const ElasticLayer layer{{1e6, nu}, 2e-3};
        DiscTable table(layer, std::make_shared<contact::Paraboloid>(10e-3),
                        {1e6, 10e-3, layer.thickness}, .05);
        // Thinner, softer, under a sharper body.
        const ElasticLayer other{{3e5, nu}, .7e-3};
        const contact::Paraboloid body(4e-3);
        const auto exact = layer_contacts(other, body);
        for (const double ratio : {1e-3, .037, .41, 1.9, 7.3}) {
            const double a = ratio * other.thickness;
            const DiscContact here = table.at(a, {3e5, 4e-3, other.thickness}), there = exact(a);
            // Of four neighbours .05 apart; tests of the fit allow 5e-3.
            EXPECT_NEAR(here.indentation / there.indentation, 1, 2e-6) << nu << ' ' << ratio;
            EXPECT_NEAR(here.force / there.force, 1, 2e-6) << nu << ' ' << ratio;
            EXPECT_NEAR(here.stiffness / there.stiffness, 1, 2e-6) << nu << ' ' << ratio;
            EXPECT_NEAR(here.edge / there.edge, 1, 2e-6) << nu << ' ' << ratio;
        }
    }
}

}  // namespace
}  // namespace tricontact::theory::disc_table_test
