// Friction that varies over the substrate: what Hertz' pressure and the table carry by quadrature,
// and one factor all over, which is Coulomb's law with another coefficient.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "bem/model.h"
#include "contact/base/error.h"
#include "contact/cells.h"
#include "contact/run.h"
#include "tests/verification/bem/rig.h"

namespace tricontact::bem::friction_map_test {
namespace {

using contact::FrictionMap;

contact::Case equal_bodies() {
    contact::Case c = rig_case(.2, .3, 4);
    c.substrate.poisson = 0;
    c.indenter.material = c.substrate;
    c.of<contact::Cells>().spacing.reset();
    c.of<contact::Cells>().per_radius = 40;
    return c;
}

constexpr double far = 1;  // [m]

double factor_at(double x) {
    return .5 + .8 / (1 + std::exp(-x / 4e-4));
}

/// Smooth stripes along y: 0.5 on the left to 1.3 on the right, over a tenth of the radius or so.
std::shared_ptr<const FrictionMap> stripes() {
    std::vector<double> x{-far}, factor{factor_at(-far)};
    for (double at = -6e-3; at < 6e-3; at += 2e-5) {
        x.push_back(at);
        factor.push_back(factor_at(at));
    }
    x.push_back(far);
    factor.push_back(factor_at(far));
    return std::make_shared<FrictionMap>(x, std::vector<double>{}, factor);
}

/// ∫ factor(x) min over the path of p dA over the pressed force, of Hertz' pressures.
double carried(double a, double w) {
    constexpr int n = 2000;
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        const double s = -1 + (i + .5) * 2 / n, edge = std::abs(s) + w;
        // Over y: (pi/2) (1 - edge^2) of p/p0; over all 2 pi/3.
        if (edge < 1) sum += factor_at(s * a) * std::numbers::pi / 2 * (1 - edge * edge) * 2 / n;
    }
    return sum / (2 * std::numbers::pi / 3);
}

// Cells of a/40: Hertz' force is met to 2e-4, its parts alike.
TEST(FrictionMap, CarriesTheFactorsTimesHertzPressure) {
    contact::Case c = equal_bodies();
    c.friction.map = stripes();
    const contact::HalfSpaceScales hertz = contact::half_space_scales(c);
    const contact::History h = run_bem(c);
    const double mu = *c.friction.coefficient, a = hertz.contact_radius;
    const double sliding = carried(a, 0);
    EXPECT_GT(std::abs(sliding - 1), .05);  // no Coulomb
    EXPECT_NEAR(h.scales.sliding_force / (mu * hertz.normal_force), sliding, 1e-3);
    EXPECT_NEAR(h.limit_tangential_ratio, carried(a, .2) / sliding, 1e-3);
}

TEST(FrictionMap, OneFactorIsAnotherCoefficient) {
    contact::Case mapped = equal_bodies(), coulomb = mapped;
    const std::vector<double> ends{-far, far};
    mapped.friction.map = std::make_shared<FrictionMap>(ends, ends, std::vector<double>(4, .6));
    *coulomb.friction.coefficient *= .6;
    const contact::History one = run_bem(mapped), other = run_bem(coulomb);
    EXPECT_NEAR(one.static_shift / other.static_shift, 1, 1e-6);  // both solve to 1e-7
    EXPECT_NEAR(one.shift_per_period.back() / other.shift_per_period.back(), 1, 1e-6);
    EXPECT_NEAR(one.limit_tangential_ratio, other.limit_tangential_ratio, 1e-9);
}

TEST(FrictionMap, RefusesContactsBeyondIt) {
    contact::Case c = equal_bodies();
    const std::vector<double> ends{-1e-3, 1e-3};
    c.friction.map =
        std::make_shared<FrictionMap>(ends, std::vector<double>{}, std::vector<double>(2, 1.));
    try {
        run_bem(c);
        FAIL();
    } catch (const contact::InputError& e) {
        EXPECT_NE(std::string(e.what()).find("friction.map"), std::string::npos) << e.what();
    }
}

}  // namespace
}  // namespace tricontact::bem::friction_map_test
