#include "theory/cattaneo_mindlin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "contact/friction/friction.h"
#include "mdr/spring_bed.h"

namespace tricontact::mdr_cattaneo_mindlin_test {
namespace {

using std::numbers::pi;

// Bed in units mu = E* = G* = R = d = 1 (a = 1, F_N = 4/3), or scaled: lengths, moduli, mu.
struct Units {
    double length = 1, modulus = 1, shear_modulus = 1, friction = 1;
    double normal_force() const { return 4. / 3 * modulus * length * length; }
    double unit_shift() const { return friction * modulus / shear_modulus * length; }
};

mdr::SpringBed bed(const Units& units, int springs) {
    mdr::BedData data;
    data.profile = std::make_unique<mdr::PowerLawProfile>(1 / (2 * units.length), 2);
    data.effective_modulus = units.modulus;
    data.effective_shear_modulus = units.shear_modulus;
    data.friction = contact::Friction{units.friction}.law();
    data.n_springs = springs;
    data.half_length = 1.02 * units.length;
    return mdr::SpringBed(std::move(data));
}

contact::LoadStep step(const Units& units, double f) {
    contact::LoadStep s;
    s.normal.value = units.normal_force();
    s.tangential[0].value = f * units.friction * units.normal_force();
    return s;
}

const Units scaled{4.5e-3, 7e6, 5e6, 0.57};

TEST(MdrCattaneoMindlin, HalfSpaceScales) {
    mdr::SpringBed model = bed(scaled, 10000);
    model.advance(step(scaled, 0));
    const contact::Scales s = model.scales();
    // midpoint rule at the two edges: dx^2/4 = 1e-8
    EXPECT_NEAR(s.indentation / scaled.length, 1, 2e-8);
    EXPECT_NEAR(s.contact_radius / scaled.length, 1, 2e-8);
    EXPECT_NEAR(s.peak_pressure / (2 / pi * scaled.modulus), 1, 2e-8);
    EXPECT_NEAR(s.unit_shift / scaled.unit_shift(), 1, 2e-8);
    EXPECT_NEAR(s.normal_force / scaled.normal_force(), 1, 1e-14);
}

TEST(MdrCattaneoMindlin, StaticShiftAndStickArea) {
    for (const double f : {.1, .56, .9, .999}) {
        mdr::SpringBed model = bed(scaled, 4000);
        model.advance(step(scaled, 0));
        const contact::StepRecord r = model.advance(step(scaled, f));
        // dx = 5e-4 a: kinks cost dx^2/12, divided by dF/dU ~ (1 - f)^(1/3) > 0.1
        EXPECT_NEAR(r.shift[0] / scaled.unit_shift(), theory::static_shift_ratio(f), 1e-6) << f;
        const double stick = std::sqrt(r.stick_area / pi) / scaled.length;
        EXPECT_NEAR(stick, theory::stick_radius_ratio(f), 1e-3) << f;  // whole cells
        EXPECT_NEAR(r.contact_area, r.stick_area + r.slip_area, 1e-15 * r.contact_area);
    }
}

TEST(MdrCattaneoMindlin, StaticShiftDoesNotDependOnTheSteps) {
    mdr::SpringBed one = bed(scaled, 1000), many = bed(scaled, 1000);
    one.advance(step(scaled, 0));
    const double shift = one.advance(step(scaled, .7)).shift[0];
    many.advance(step(scaled, 0));
    double reached = 0;
    for (int k = 1; k <= 70; ++k) reached = many.advance(step(scaled, .01 * k)).shift[0];
    EXPECT_NEAR(reached / shift, 1, 1e-11);  // a path of 70 exact steps, rounding only
}

TEST(MdrCattaneoMindlin, CycleDissipation) {
    for (const Units& units : {Units{}, scaled})
        for (const double f : {.3, .6, .9}) {
            mdr::SpringBed model = bed(units, 10000);
            model.advance(step(units, 0));
            model.advance(step(units, f));
            double cycle = 0;
            for (const double end : {-f, f}) cycle += model.advance(step(units, end)).dissipation;
            const double exact = theory::cycle_dissipation(
                {units.friction, units.normal_force(), units.shear_modulus, units.length, f});
            EXPECT_NEAR(cycle / exact, 1, 1e-5) << f;
            EXPECT_TRUE(model.audit().passed());
        }
}

TEST(MdrCattaneoMindlin, CycleDissipationConverges) {
    const double f = .6, exact = theory::cycle_dissipation({1, 4. / 3, 1, 1, f});
    // The error depends on where the kinks fall in their cells: mean square of neighbouring beds.
    auto error = [&](int springs) {
        double squares = 0;
        constexpr int n_beds = 60;
        for (int k = 0; k < n_beds; ++k) {
            mdr::SpringBed model = bed(Units{}, springs + k);
            for (const double end : {0., f, -f}) model.advance(step(Units{}, end));
            // half a cycle dissipates half of its work
            const double work = 2 * model.advance(step(Units{}, f)).dissipation;
            squares += (work / exact - 1) * (work / exact - 1) / n_beds;
        }
        return std::sqrt(squares);
    };
    const double coarse = error(250), medium = error(501), fine = error(1000);
    EXPECT_NEAR(std::log2(coarse / medium), 2, .4);  // kinks: second order; a mean of samples
    EXPECT_NEAR(std::log2(medium / fine), 2, .4);
}

TEST(MdrCattaneoMindlin, TractionsOfTheSurface) {
    const double f = .56, p0 = 2 / pi * scaled.modulus;
    mdr::SpringBed model = bed(scaled, 4000);
    model.advance(step(scaled, 0));
    model.advance(step(scaled, f));
    const contact::Surface s = model.surface();
    ASSERT_EQ(s.layout, contact::Surface::Layout::line);
    ASSERT_EQ(s.size(), 500u);
    for (int i = 0; i < s.n_x; ++i) {
        const double rho = std::abs(s.x(i)) / scaled.length;
        const double hertz = rho < 1 ? std::sqrt(1 - rho * rho) : 0;
        const double tau = theory::cattaneo_mindlin_traction(rho, f);
        // 250 pieces of length h: at the centre the polygon costs pi^2/36 h = 1.1e-3
        EXPECT_NEAR(s.normal_traction[i] / p0, hertz, 1.1e-3) << rho;
        // The kink at the stick radius lies inside a piece: sqrt(h) over the pieces next to it.
        const bool at_kink = std::abs(rho - theory::stick_radius_ratio(f)) < 4. / 250;
        EXPECT_NEAR(s.tangential_traction_x[i] / (scaled.friction * p0), tau, at_kink ? .025 : 3e-3)
            << rho;
        EXPECT_EQ(s.friction_bound[i], scaled.friction * s.normal_traction[i]);
    }
}

}  // namespace
}  // namespace tricontact::mdr_cattaneo_mindlin_test
