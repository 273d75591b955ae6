#include "theory/springs/sprung_contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "contact/base/error.h"
#include "tests/random/spring_rig.h"
#include "theory/hertz_under_law.h"
#include "theory/rolling/soft_interface.h"

namespace tricontact::theory::sprung_contact_test {
namespace {

using Kind = contact::NormalControl::Kind;
constexpr double radius = 7e-3, young = 1.8e6, force = .6;
constexpr double modulus = young / .75, shear_modulus = 4 * young / 3 / 1.5;

// To first order in 1/k_n: of springs 1e-5 soft nothing is seen, and the family begins at 1e-4.
TEST(SprungContact, StiffSpringsAreHertzContact) {
    const double a = std::cbrt(.75 * force * radius / modulus);
    const SprungPress press =
        press_on_springs(radius, modulus, 1e5 * modulus / a, {Kind::force, force});
    EXPECT_NEAR(press.contact_radius / a, 1, 3e-4);
    EXPECT_NEAR(press.indentation * radius / (a * a), 1, 3e-4);
}

// F_N = pi k_n R d^2, a^2 = 2 R d.
TEST(SprungContact, SoftSpringsAreAWinklerFoundation) {
    const double k = 1e-4 * modulus / radius, depth = 1e-5;
    const SprungPress press = press_on_springs(radius, modulus, k, {Kind::indentation, depth});
    EXPECT_NEAR(press.normal_force / (std::numbers::pi * k * radius * depth * depth), 1, 4e-4);
    EXPECT_NEAR(press.contact_radius * press.contact_radius / (2 * radius * depth), 1, 1e-4);
}

TEST(SprungContact, PressesByForceAndByDepthAreTheSame) {
    for (const double k : {1e8, 1e9, 1e10}) {
        const SprungPress one = press_on_springs(radius, modulus, k, {Kind::force, force});
        const SprungPress other =
            press_on_springs(radius, modulus, k, {Kind::indentation, one.indentation});
        EXPECT_NEAR(other.normal_force / force, 1, 1e-8);
    }
}

// 48 elements: 1e-4 of the shift, of a bound with a kink (tau_cap) 7e-4.
TEST(SprungContact, RigidInterfacesAreHertzContactUnderTheLaw) {
    const contact::Friction laws[] = {
        {.coefficient = .5},
        {.shear_strength = .1e6},
        {.coefficient = .5, .shear_strength = .1e6},
        {.coefficient = .5, .pressure_exponent = .6, .reference_pressure = .2e6},
        {.coefficient = .5, .strength_limit = .1e6}};
    const double a = std::cbrt(.75 * force * radius / modulus);
    const double p0 = 1.5 * force / (std::numbers::pi * a * a);
    for (const contact::Friction& law : laws) {
        const double accuracy = law.strength_limit ? 7e-4 : 1.5e-4;
        const HertzUnderLaw exact(law, a, p0, shear_modulus);
        const SprungContact found(law, {}, radius, force, modulus, shear_modulus);
        EXPECT_NEAR(found.friction_limit() / exact.friction_limit(), 1, accuracy);
        EXPECT_NEAR(found.unit_shift() / exact.unit_shift(), 1, accuracy);
        for (const double f : {.05, .2, .5, .8, .95, .99})
            EXPECT_NEAR(
                found.shift(f * found.friction_limit()) / exact.shift(f * exact.friction_limit()),
                1, accuracy)
                << law.formula() << f;
        EXPECT_EQ(found.stuck_stiffness(), 0);
    }
}

TEST(SprungContact, SoftInterfacesHaveTheirClosedForm) {
    const contact::Friction law{.coefficient = .4};
    const double k = 1e-4 * modulus / radius, kt = .3 * k, load = 1e-6;
    const SprungContact found(law, {k, kt}, radius, load, modulus, shear_modulus);
    const double depth = std::sqrt(load / (std::numbers::pi * k * radius));
    for (const double u : {.05, .3, .6, .9})
        EXPECT_NEAR(found.shift(soft_interface_force(u) * .4 * load) * kt / (.4 * k * depth) / u, 1,
                    5e-4);
}

// Where k_t/k_n = G*/E* what slipped is mu p of F_N, less what the stick zone has as a contact of
// less force (Jaeger 1998, Ciavarella 1998): F_T = mu (F_N - F'), U = mu E*/G* (d - d').
TEST(SprungContact, ProportionalSpringsSlipAsJaegerAndCiavarellaHaveIt) {
    const double mu = .4;
    for (const double k : {1e8, 1e9, 1e10}) {
        const SprungContact found({.coefficient = mu}, {k, k * shear_modulus / modulus}, radius,
                                  force, modulus, shear_modulus);
        const double all = press_on_springs(radius, modulus, k, {Kind::force, force}).indentation;
        for (const double f : {.05, .3, .6, .9, .99}) {
            const double less =
                press_on_springs(radius, modulus, k, {Kind::force, (1 - f) * force}).indentation;
            EXPECT_NEAR(found.shift(f * mu * force) / (mu * modulus / shear_modulus * (all - less)),
                        1, 4e-4);
        }
    }
}

// Rings of constant traction, which share nothing with the program: 64 of them are 0.4 % off.
TEST(SprungContact, AgreesWithRingsUnderEachLaw) {
    for (const double k : {3e8, 2e9}) {
        for (const bool is_strength : {false, true}) {
            const auto law = [=](double p) { return is_strength ? .1e6 : .5 * p; };
            const SpringRig rings{radius, young, 1 / k, 1 / (.4 * k), law};
            const SpringRig::Pressed press = rings.under(force);
            EXPECT_NEAR(press_on_springs(radius, modulus, k, {Kind::force, force}).indentation /
                            press.depth,
                        1, 2e-3);
            const contact::Friction friction = is_strength
                                                   ? contact::Friction{.shear_strength = .1e6}
                                                   : contact::Friction{.coefficient = .5};
            const SprungContact found(friction, {k, .4 * k}, radius, force, modulus, shear_modulus);
            const double limit = found.friction_limit();
            EXPECT_NEAR(limit / rings.limit(force), 1, 4e-3);
            const std::vector<double> forces{.1 * limit, .4 * limit, .8 * limit};
            const auto shifts = rings.shifts(force, forces);
            for (std::size_t i = 0; i < forces.size(); ++i)
                EXPECT_NEAR(found.shift(forces[i]) / shifts[i], 1, 6e-3) << k << is_strength << i;
            // A strength lets nothing slip until the springs of the edge carry it.
            EXPECT_EQ(found.stuck_stiffness() > 0, is_strength);
        }
    }
}

TEST(SprungContact, RefusesWhatIsNoContact) {
    const SprungContact found({.coefficient = .5}, {1e9, 1e9}, radius, force, modulus,
                              shear_modulus);
    EXPECT_THROW(found.shift(.301), contact::InputError);
    EXPECT_THROW(press_on_springs(radius, modulus, 0, {Kind::force, force}), std::domain_error);
}

}  // namespace
}  // namespace tricontact::theory::sprung_contact_test
