// Work by the law is the integral of its bound along the way, whatever it begins with.

#include "contact/friction/friction_memory.h"

#include <gtest/gtest.h>

#include <array>

#include "contact/friction/friction.h"

namespace tricontact::contact::friction_memory_test {
namespace {

Friction coulomb() {
    return {.coefficient = .5};
}

double bound_at(const FrictionLaw& law, double pressure, double way) {
    double bound = 0;
    law.bounds({{&pressure, 1}, {}, {}, {&way, 1}}, {&bound, 1});
    return bound;
}

/// By the midpoint rule over n small slips, each remembered.
double summed_work(const FrictionLaw& law, double pressure, double way, double slip, int n) {
    double work = 0;
    for (int k = 0; k < n; ++k) {
        work += bound_at(law, pressure, law.way(way, slip / n / 2, pressure)) * slip / n;
        way = law.way(way, slip / n, pressure);
    }
    return work;
}

TEST(FrictionMemory, WorkIsTheIntegralOfTheBound) {
    Friction linear = coulomb(), exponential = coulomb(), hard = coulomb(), soft = coulomb();
    linear.weakening = FrictionWeakening{FrictionWeakening::Law::linear, .3, 2e-5};
    exponential.weakening = FrictionWeakening{FrictionWeakening::Law::exponential, .3, 2e-5};
    hard.yield = InterfaceYield{3e5, 1e10};
    soft.yield = InterfaceYield{3e5, -2e10};
    constexpr int n = 4000;
    for (const Friction& friction : {linear, exponential, hard, soft}) {
        const auto law = friction.law();
        for (const double pressure : {4e5, 7e5, 1e6})
            for (const double way : {0., 5e-6, 3e-5})
                for (const double slip : {1e-6, 1e-5, 6e-5})
                    EXPECT_NEAR(law->work(pressure, way, law->way(way, slip, pressure), slip) /
                                    (pressure * slip),
                                summed_work(*law, pressure, way, slip, n) / (pressure * slip),
                                1. / n)  // of kinks, n^-1; else n^-2
                        << friction.formula() << ' ' << pressure << ' ' << way << ' ' << slip;
    }
}

TEST(FrictionMemory, HealsWhereItSticksAndStaysWhereItFlowed) {
    Friction falling = coulomb(), hard = coulomb();
    falling.weakening = FrictionWeakening{FrictionWeakening::Law::linear, .3, 2e-5};
    hard.yield = InterfaceYield{3e5, 1e10};
    EXPECT_EQ(falling.law()->healed(1e-5), 0);
    EXPECT_EQ(hard.law()->healed(1e-5), 1e-5);
    // 0.5 * 0.7 MPa is 50 kPa above tau_c0: 5 um of flow, whatever slips on.
    EXPECT_DOUBLE_EQ(hard.law()->way(0, 1e-4, 7e5), 5e-6);
    EXPECT_DOUBLE_EQ(hard.law()->way(8e-6, 1e-4, 7e5), 8e-6);  // hardened under more pressure
    EXPECT_EQ(hard.law()->way(0, 1e-4, 5e5), 0);               // slips before it flows
}

TEST(FrictionMemory, YieldWithoutHardeningIsALimitOfStrength) {
    Friction yields = coulomb(), limited = coulomb();
    yields.yield = InterfaceYield{3e5, 0};
    limited.strength_limit = 3e5;
    EXPECT_FALSE(yields.remembers());
    for (const double pressure : {1e5, 5e5, 1e6})
        EXPECT_EQ(yields.law()->bound(pressure), limited.law()->bound(pressure));
}

}  // namespace
}  // namespace tricontact::contact::friction_memory_test
