#include "theory/creep_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "contact/case.h"
#include "mdr/model.h"
#include "mdr/settings.h"
#include "theory/rolling/kalker.h"

namespace tricontact::theory::creep_law_test {
namespace {

/// A rigid paraboloid, all scales other than 1.
contact::Case sphere(double nu, double f) {
    contact::Case c;
    c.indenter.radius = 40e-3;
    c.substrate = {5.2e6, nu};
    c.friction.coefficient = .57;
    c.contact.coupling = false;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = f;
    return c;
}

double sliding_creepage_of(const contact::Case& c, double (*coefficient)(double)) {
    const CombinedMaterial material = combined_material(c.materials());
    const double a = contact::half_space_scales(c).contact_radius;
    return sliding_creepage(c.friction_coefficient() * *c.load.normal_force, material.shear_modulus,
                            a * a, coefficient(material.poisson));
}

/// Creepage of a bed of springs that is rolled on from rest under F_T over five contact radii, in
/// steps of one spring.
double rolled_creepage(contact::Case c, int springs_per_radius) {
    const double a = contact::half_space_scales(c).contact_radius, way = 5 * a;
    c.rolling.emplace().amplitude = way;
    c.of<mdr::Settings>().springs = 6 * springs_per_radius * 2;
    const auto bed = mdr::make_model(c);
    contact::LoadStep step = contact::press_step(c);
    bed->advance(step);
    step.tangential[0].value =
        *c.load.tangential_ratio * c.friction_coefficient() * *c.load.normal_force;
    double shift = bed->advance(step).shift[0], before = shift;
    const int n_steps = 5 * springs_per_radius;
    for (int i = 1; i <= n_steps; ++i) {
        step.offset[0] = way * i / n_steps;
        before = shift;
        shift = bed->advance(step).shift[0];
    }
    return (shift - before) * n_steps / way;
}

TEST(CreepLaw, IsThatOfTheSpringsOfMdrRolledOn) {
    for (const double nu : {0., .3, .5})
        for (const double f : {.3, .56, .9}) {
            const contact::Case c = sphere(nu, f);
            const double exact = sliding_creepage_of(c, mdr_coefficient) * cubic_creepage_ratio(f);
            // A spring enters with the profile half a spacing deep: first order, 3/2 of 1/200.
            EXPECT_NEAR(rolled_creepage(c, 200) / exact, 1, 8e-3) << nu << ' ' << f;
        }
}

TEST(CreepLaw, SpringsConvergeToIt) {
    const contact::Case c = sphere(.5, .56);
    const double exact = sliding_creepage_of(c, mdr_coefficient) * cubic_creepage_ratio(.56);
    const double coarse = std::abs(rolled_creepage(c, 75) / exact - 1);
    const double fine = std::abs(rolled_creepage(c, 300) / exact - 1);
    EXPECT_GT(std::log(coarse / fine) / std::log(4.), .9) << coarse << ' ' << fine;
}

// Thesis, eqs. 2.1.21, 2.2.24 and 2.2.31, in its own units mu a/R.
TEST(CreepLaw, IsTheThesisOnes) {
    for (const double nu : {0., .3, .5}) {
        const contact::Case c = sphere(nu, .56);
        const double a = contact::half_space_scales(c).contact_radius;
        const double unit = c.friction_coefficient() * a / c.indenter.radius;
        const contact::MaterialPair materials = c.materials();
        const double johnson = sliding_creepage_of(c, vermeulen_johnson_coefficient) / unit;
        const double mdr = sliding_creepage_of(c, mdr_coefficient) / unit;
        EXPECT_NEAR(johnson, (4 - 3 * nu) / (4 * (1 - nu)), 1e-12) << nu;
        EXPECT_NEAR(mdr, 2 * materials.effective_modulus() / materials.effective_shear_modulus(),
                    1e-12);
        EXPECT_NEAR(mdr / johnson, 4 * (2 - nu) / (4 - 3 * nu), 1e-12) << nu;
    }
}

// In units mu a/R it does not matter whether the sphere is rigid or of the substrate's material:
// both bodies give way twice as much, but a half-space is pressed by half the force at the same a.
TEST(CreepLaw, IsTheSameForEqualBodies) {
    contact::Case c = sphere(.3, .56);
    const auto in_units = [](const contact::Case& one) {
        return sliding_creepage_of(one, vermeulen_johnson_coefficient) /
               contact::half_space_scales(one).contact_radius;
    };
    const double rigid = in_units(c);
    c.indenter.material = c.substrate;
    EXPECT_NEAR(in_units(c) / rigid, 1, 1e-12);
}

// A shear strength, in the plane: whatever sticks is strained alike. The strain is 1/(pi E*/2)
// times the principal value of ∫ tau/(x - s) ds; midpoints in angles that both square roots like, x
// halfway between two of them.
TEST(CreepLaw, StrengthStrainsWhatSticksByTheCreepage) {
    for (const double f : {.3, .6, .9}) {
        const double begin = 1 - 2 * strength_stick_ratio(f);
        const double middle = (1 + begin) / 2, half = (1 - begin) / 2;
        constexpr int n = 4000;
        double force = 1 + begin;
        for (int j = 0; j < n; ++j) {
            const double t = std::numbers::pi * (j + .5) / n;
            force += strength_traction(middle + half * std::cos(t), f) * half * std::sin(t) *
                     std::numbers::pi / n;
        }
        EXPECT_NEAR(force / 2, f, 1e-6);
        for (const int at : {n / 5, n / 2, 4 * n / 5}) {
            const double x = middle + half * std::cos(std::numbers::pi * at / n);
            double strain = std::log((x + 1) / (x - begin));
            for (int j = 0; j < n; ++j) {
                const double t = std::numbers::pi * (j + .5) / n, s = middle + half * std::cos(t);
                strain +=
                    strength_traction(s, f) / (x - s) * half * std::sin(t) * std::numbers::pi / n;
            }
            // xi = 2/(pi E*) strain tau_0 = 4 tau_0/(pi E*) artanh f.
            EXPECT_NEAR(strain / 2, strength_creepage_ratio(f), 1e-5) << f << ' ' << at;
        }
    }
}

// MDR's springs one by one: min(xi (a - x), 2 tau_0 sqrt(a^2 - x^2)/G*), midpoints.
TEST(CreepLaw, StrengthOfTheBedIsTheSumOfItsSprings) {
    for (const double eta : {.1, 1., 4.}) {
        constexpr int n = 100000;
        double sum = 0;
        for (int i = 0; i < n; ++i) {
            const double x = -1 + (2 * i + 1.) / n;
            sum += std::min(2 * eta * (1 - x), 2 * std::sqrt(1 - x * x)) * 2 / n;
        }
        EXPECT_NEAR(strength_bed_force_ratio(eta), sum / std::numbers::pi, 1e-6) << eta;
    }
    for (const double f : {1e-3, .2, .99}) {
        EXPECT_NEAR(strength_bed_force_ratio(strength_bed_creepage_ratio(f)), f, 1e-12);
        EXPECT_NEAR(strength_force_ratio(strength_creepage_ratio(f)), f, 1e-14);
    }
    EXPECT_THROW(strength_creepage_ratio(1), std::domain_error);
    EXPECT_THROW(strength_traction(0, 1.1), std::domain_error);
    EXPECT_THROW(strength_bed_force_ratio(-1), std::domain_error);
}

TEST(CreepLaw, ForceAndCreepageAreInverse) {
    for (const double f : {1e-3, .2, .99, 1.})
        EXPECT_NEAR(cubic_force_ratio(cubic_creepage_ratio(f)), f, 1e-14) << f;
    EXPECT_EQ(cubic_force_ratio(2), 1);
    EXPECT_THROW(cubic_force_ratio(-1), std::domain_error);
    EXPECT_THROW(cubic_creepage_ratio(1.1), std::domain_error);
}

}  // namespace
}  // namespace tricontact::theory::creep_law_test
