#include "contact/friction/friction.h"

#include <gtest/gtest.h>

#include <vector>

#include "contact/base/error.h"
#include "contact/case.h"

namespace tricontact::friction_test {
namespace {

using contact::Friction;
using contact::FrictionLaw;

/// tau_max = min(mu p, cap), Orowan's: no coefficient of its own.
class Capped final : public FrictionLaw {
  public:
    void bounds(const Points& points, std::span<double> bound) const override {
        for (std::size_t i = 0; i < bound.size(); ++i)
            bound[i] = std::min(.5 * points.pressure[i], 2.);
    }
};

TEST(Friction, CoulombsBoundsAreProportionalToThePressures) {
    const auto law = Friction{.57}.law();
    const std::vector<double> pressure{0, 1, 2e6};
    std::vector<double> bound(3);
    law->bounds({pressure}, bound);
    EXPECT_EQ(bound, (std::vector<double>{0, .57, .57 * 2e6}));
    EXPECT_EQ(law->bound(2e6), bound[2]);
    EXPECT_EQ(law->coulomb(), .57);
}

// Amontons: what a contact carries hangs on F_N alone, whatever the bounds sum up to.
TEST(Friction, CoulombsLimitFollowsFromTheNormalForce) {
    const auto law = Friction{.5}.law();
    EXPECT_EQ(law->limit({20, 7}), 10);
    EXPECT_EQ(law->limit({20, 7}, .3), .3 * .5 * 20);
    EXPECT_EQ(law->ratio({20, 7}), .5);
    EXPECT_EQ(law->ratio_at(1e6), .5);
    EXPECT_EQ(law->share({5, 7}, {20, 7}), .25);
}

TEST(Friction, AnotherLawCarriesTheSumOfItsBounds) {
    const Capped law;
    EXPECT_FALSE(law.coulomb());
    EXPECT_EQ(law.bound(1), .5);
    EXPECT_EQ(law.bound(100), 2);
    EXPECT_EQ(law.limit({20, 7}), 7);
    EXPECT_EQ(law.limit({20, 7}, .5), 3.5);
    EXPECT_EQ(law.ratio({20, 7}), 7. / 20);
    EXPECT_EQ(law.ratio_at(100), .02);
    EXPECT_EQ(law.share({5, 3.5}, {20, 7}), .5);
}

}  // namespace
}  // namespace tricontact::friction_test
