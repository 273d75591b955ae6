#include "theory/layer/sticking_contact.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "contact/base/error.h"

namespace tricontact::sticking_contact_test {
namespace {

using theory::ElasticLayer;
using theory::LayerBase;
using theory::sticking_stiffness;
using theory::StickTractions;

constexpr double pi = std::numbers::pi;

/// Over 8 G a/(2 - nu); b = 3 mm, G = 2 MPa.
double stiffening(double a_over_b, double nu, StickTractions tractions) {
    const double g = 2e6, b = 3e-3, a = a_over_b * b;
    return sticking_stiffness(ElasticLayer{{2 * (1 + nu) * g, nu}, b}, a, tractions) /
           (8 * g * a / (2 - nu));
}

TEST(TheoryStickingContact, HalfSpace) {
    EXPECT_NEAR(sticking_stiffness(contact::MaterialPair({}, {5.2e6, .5}), 4e-3) /
                    (8 * (5.2e6 / 3) * 4e-3 / 1.5),
                1, 1e-14);
    // Springs in series: two equal bodies are half as stiff.
    const contact::Material m{3e6, .3};
    EXPECT_NEAR(sticking_stiffness(contact::MaterialPair(m, m), .1) /
                    sticking_stiffness(contact::MaterialPair({}, m), .1),
                .5, 1e-14);
}

// At nu = 1/2 the half-space has no coupling.
TEST(TheoryStickingContact, ThickLayersAreHalfSpaces) {
    for (const double nu : {-.5, 0., .3, .5})
        for (const auto tractions : {StickTractions::radial, StickTractions::in_plane}) {
            // The layer holds the contact as a whole: first order in a/b.
            EXPECT_NEAR(stiffening(1e-9, nu, tractions), 1, 1e-8) << nu;
            const double c1 = (stiffening(1e-4, nu, tractions) - 1) / 1e-4;
            const double c2 = (stiffening(1e-2, nu, tractions) - 1) / 1e-2;
            EXPECT_NEAR(c2 / c1, 1, .01) << nu;
        }
    EXPECT_NEAR(stiffening(1e-9, .5, StickTractions::all), 1, 1e-8);
}

// Thin layers shear as a whole: F_T = G pi a^2/b U, edges add first order in b/a.
TEST(TheoryStickingContact, ThinLayersShear) {
    for (const double nu : {0., .3, .5})
        for (const auto tractions :
             {StickTractions::radial, StickTractions::in_plane, StickTractions::all}) {
            auto excess = [&](double a_over_b) {
                return stiffening(a_over_b, nu, tractions) * 8 / (2 - nu) / (pi * a_over_b) - 1;
            };
            const double coarse = excess(12), fine = excess(24);
            EXPECT_LT(fine, .08) << nu;
            EXPECT_NEAR(std::log2(coarse / fine), 1, .05) << nu;
        }
}

// Each set of tractions holds the one before it, and least complementary energy is never stiffer
// for fewer of them. How much the approximation of mdr-layer leaves out.
TEST(TheoryStickingContact, MoreTractionsAreStiffer) {
    double most = 0, of_coupling = 0;
    for (const double nu : {0., .3, .5})
        for (const double a_over_b : {.1, .55, 1., 3., 10., 32.}) {
            const double radial = stiffening(a_over_b, nu, StickTractions::radial),
                         in_plane = stiffening(a_over_b, nu, StickTractions::in_plane),
                         all = stiffening(a_over_b, nu, StickTractions::all);
            EXPECT_GE(in_plane, radial * (1 - 1e-12));
            EXPECT_GE(all, in_plane * (1 - 1e-6));  // accuracy of `all`
            most = std::max(most, in_plane / radial - 1);
            if (nu == .5) of_coupling = std::max(of_coupling, all / in_plane - 1);
        }
    // docs/explanation/models/mdr-layer.md
    EXPECT_NEAR(most, .0037, 1e-4);
    EXPECT_NEAR(of_coupling, .0310, 1e-4);
}

// The table of docs/explanation/models/mdr-layer.md: the stiffness, what tractions along x that
// depend on r alone lack of it without coupling, and what coupling adds.
TEST(TheoryStickingContact, PrintsTheTable) {
    for (const double a_over_b : {.55, 1., 2., 5., 10.}) {
        fmt::print("| {} |", a_over_b);
        for (const double nu : {.5, .3}) {
            const double radial = stiffening(a_over_b, nu, StickTractions::radial),
                         in_plane = stiffening(a_over_b, nu, StickTractions::in_plane),
                         all = stiffening(a_over_b, nu, StickTractions::all);
            fmt::print(" {:.4f} | {:.3f} % | {:.2f} % |", all, 100 * (radial / in_plane - 1),
                       100 * (all / in_plane - 1));
            EXPECT_LE(radial, in_plane * (1 + 1e-12));
            EXPECT_LE(in_plane, all * (1 + 1e-6));
        }
        fmt::print("\n");
    }
}

TEST(TheoryStickingContact, Rig) {
    const double a_over_b = 4.3638 / 8;
    EXPECT_NEAR(stiffening(a_over_b, .5, StickTractions::radial), 1.278, 1e-3);
    EXPECT_NEAR(stiffening(a_over_b, .5, StickTractions::in_plane) /
                    stiffening(a_over_b, .5, StickTractions::radial),
                1, 5e-5);
    EXPECT_NEAR(stiffening(a_over_b, .5, StickTractions::all) /
                    stiffening(a_over_b, .5, StickTractions::in_plane),
                1.0029, 1e-4);
}

TEST(TheoryStickingContact, RefusesBadInput) {
    auto message = [](const ElasticLayer& layer, double radius) {
        try {
            sticking_stiffness(layer, radius, StickTractions::all);
        } catch (const contact::InputError& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    EXPECT_NE(message({{3e6, .5}, 5e-3}, 0).find("radius must be positive"), std::string::npos);
    EXPECT_NE(message({{3e6, .5}, 5e-3}, .2).find("at most 0.16 m"), std::string::npos);
    EXPECT_NE(message({{3e6, .5}, 5e-3, LayerBase::frictionless}, 1e-3).find("nothing holds"),
              std::string::npos);
    EXPECT_NE(message({{3e6, .5}, 0}, 1e-3).find("thickness"), std::string::npos);
    EXPECT_THROW(sticking_stiffness(contact::MaterialPair({}, {1, .3}), -1), contact::InputError);
}

}  // namespace
}  // namespace tricontact::sticking_contact_test
