#include "theory/sprung_contact.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <iostream>
#include <numbers>

#include "contact/base/error.h"
#include "theory/hertz_under_law.h"
#include "theory/rolling/soft_interface.h"

namespace tricontact::theory::sprung_contact_test {
namespace {

using Kind = contact::NormalControl::Kind;
constexpr double radius = 7e-3, modulus = 2.4e6, shear_modulus = 1.6e6, force = .6;

// Hertz' contact to first order in 1/k_n: the table's stiff end is 1e-4 soft.
TEST(SprungContact, StiffSpringsAreHertzContact) {
    const double a = std::cbrt(.75 * force * radius / modulus);
    const SprungPress press =
        press_on_springs(radius, modulus, 1e5 * modulus / a, {Kind::force, force});
    EXPECT_NEAR(press.contact_radius / a, 1, 3e-4);
    EXPECT_NEAR(press.indentation * radius / (a * a), 1, 3e-4);
}

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

// 48 elements: 1e-4.
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
        const HertzUnderLaw exact(law, a, p0, shear_modulus);
        const SprungContact found(law, {}, radius, force, modulus, shear_modulus);
        std::cout << found.friction_limit() / exact.friction_limit() - 1 << ' ' << found.unit_shift() / exact.unit_shift() - 1;
        for (const double f : {.05, .2, .5, .8, .95, .99})
            std::cout << ' ' << found.shift(f * found.friction_limit()) / exact.shift(f * exact.friction_limit()) - 1;
        std::cout << '\n';
    }
}

TEST(SprungContact, SoftInterfacesHaveTheirClosedForm) {
    const contact::Friction law{.coefficient = .4};
    const double k = 1e-4 * modulus / radius, kt = .3 * k;
    const SprungContact found(law, {k, kt}, radius, 1e-6, modulus, shear_modulus);
    const double depth = std::sqrt(1e-6 / (std::numbers::pi * k * radius));
    for (const double u : {.05, .3, .6, .9})
        std::cout << found.shift(soft_interface_force(u) * .4e-6) * kt / (.4 * k * depth) / u - 1 << ' ';
    std::cout << '\n';
}

// Where k_t/k_n = G*/E* tractions are mu (p of F_N - p of less), as Cattaneo, Jaeger and Ciavarella have it.
TEST(SprungContact, ProportionalSpringsAreJaegers) {
    const double mu = .4;
    for (const double k : {1e8, 1e9, 1e10}) {
        const SprungContact found({.coefficient = mu}, {k, k * shear_modulus / modulus}, radius,
                                  force, modulus, shear_modulus);
        const double all = press_on_springs(radius, modulus, k, {Kind::force, force}).indentation;
        for (const double f : {.05, .3, .6, .9, .99}) {
            const double less =
                press_on_springs(radius, modulus, k, {Kind::force, (1 - f) * force}).indentation;
            std::cout << found.shift(f * mu * force) / (mu * modulus / shear_modulus * (all - less)) - 1 << ' ';
        }
        std::cout << '\n';
    }
}

TEST(SprungContact, Cost) {
    const auto from = std::chrono::steady_clock::now();
    double sum = 0;
    for (int i = 0; i < 200; ++i)
        sum += SprungContact({.coefficient = .4}, {1e9 + i * 1e6, 1e9}, radius, force, modulus, shear_modulus).unit_shift();
    std::cout << std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count() / 200 << " s each " << sum << '\n';
}

}  // namespace
}  // namespace tricontact::theory::sprung_contact_test
