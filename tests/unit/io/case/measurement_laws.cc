#include "io/case/measurement_laws.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace tricontact::io::measurement_laws_test {
namespace {

/// tau(p) of four numbers, p_r = 1.
double friction(double tau_0, double mu, double n, double cap, double p) {
    return std::min(tau_0 + mu * std::pow(p, n), cap);
}

// What a law leaves of .3 + .7 p^1.4, at most .9: numbers that it does not have are 0, 1 or none.
double of_law(const MeasurementLaw& law, double tau_0, double mu, double n, double cap, double p) {
    return friction(law.has_strength ? tau_0 : 0, law.has_coefficient ? mu : 0,
                    law.has_exponent ? n : 1, law.has_limit ? cap : 1e300, p);
}

/// Numbers of the wider law that make it the narrower one, from those of this.
bool becomes(const MeasurementLaw& wide, const MeasurementLaw& narrow) {
    for (const bool by_exponent : {false, true})
        for (const bool by_limit : {false, true}) {
            double largest = 0;
            for (const double p : {.1, .5, 1., 2.}) {
                const double wanted = of_law(narrow, .3, .7, 1.4, .9, p);
                double tau_0 = narrow.has_strength ? .3 : 0, mu = narrow.has_coefficient ? .7 : 0,
                       n = narrow.has_exponent ? 1.4 : 1, cap = narrow.has_limit ? .9 : 1e300;
                if (by_exponent && wide.has_exponent) mu = tau_0, n = 0, tau_0 = 0;
                if (by_limit && wide.has_limit) cap = tau_0, mu = 1e12, tau_0 = 0;
                largest = std::max(largest, std::abs(of_law(wide, tau_0, mu, n, cap, p) - wanted));
            }
            if (largest < 1e-9) return true;
        }
    return false;
}

TEST(MeasurementLaws, ContainWhatTheyBecomeAtEndsOfTheirRanges) {
    int n = 0;
    for (const MeasurementLaw& wide : measurement_laws())
        for (const MeasurementLaw& narrow : measurement_laws()) {
            const bool is_in = &wide != &narrow && becomes(wide, narrow);
            EXPECT_EQ(wide.contains(narrow), is_in) << wide.name << " and " << narrow.name;
            n += is_in;
        }
    EXPECT_EQ(n, 10);
}

// A cap is no end of a strength and a power, though that has more numbers.
TEST(MeasurementLaws, MoreNumbersDoNotContainAllOfFewer) {
    EXPECT_FALSE(measurement_law("strength-and-power").contains(measurement_law("capped")));
    EXPECT_TRUE(measurement_law("strength-and-power").contains(measurement_law("power")));
    EXPECT_FALSE(measurement_law("power").contains(measurement_law("strength-and-coulomb")));
}

}  // namespace
}  // namespace tricontact::io::measurement_laws_test
