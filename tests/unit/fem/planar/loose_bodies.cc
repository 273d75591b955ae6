// Bodies that nothing holds but the contact.

#include <gtest/gtest.h>

#include "tests/unit/fem/planar/two_bodies.h"

namespace tricontact::loose_bodies_test {
namespace {

using namespace planar_test;

constexpr double young = 3, poisson = .3, height = 2, width = 1.5;

CondensedSection block(Solid solid, Support support, bool whole = false) {
    const Sizes sizes{6, width / 6, 1.3, 2};
    Mesh half = block_section(sizes, width, height, [](double) { return 0.; });
    return body_of(whole ? with_mirror_image(half) : std::move(half), solid, {young, poisson},
                   support);
}

/// Into the substrate, under forces of the unit pressure all over the contact [m].
std::vector<double> under_unit_pressure(const CondensedSection& body) {
    const std::size_t n = body.size();
    const ContactGrid grid = points_on_nodes({body});
    std::vector<double> u(n, 0);
    for (const auto& [node, point, value] : grid.transfer.front())
        for (std::size_t i = 0; i < n; ++i)
            u[i] += body.compliance[(n + node) * 2 * n + n + i] * value;
    return u;
}

// The same pressure on both faces: h sigma/E (times 1 - nu^2 in plane strain) from one to the
// other. Quadratic elements hold it exactly.
TEST(FemPlanarLooseBodies, EvenPressureCompressesEvenly) {
    for (const Solid solid : {Solid::plane_strain, Solid::of_revolution}) {
        const double exact =
            height / young * (solid == Solid::plane_strain ? 1 - poisson * poisson : 1);
        for (const double u : under_unit_pressure(block(solid, Support::even)))
            EXPECT_NEAR(u / exact, 1, 1e-9);
    }
}

TEST(FemPlanarLooseBodies, AWholeSectionIsBothHalves) {
    for (const Support support : {Support::even, Support::point}) {
        const std::vector<double> half = under_unit_pressure(block(Solid::plane_strain, support));
        const std::vector<double> whole =
            under_unit_pressure(block(Solid::plane_strain, support, true));
        ASSERT_EQ(whole.size(), 2 * half.size() - 1);
        for (std::size_t i = 0; i < half.size(); ++i) {
            EXPECT_NEAR(whole[half.size() - 1 + i] / half[i], 1, 1e-9);
            EXPECT_NEAR(whole[half.size() - 1 - i] / half[i], 1, 1e-9);
        }
    }
}

// Forces on the contact and what balances them do no work in a rigid displacement: the compliance
// stays symmetric, and nothing is held.
TEST(FemPlanarLooseBodies, ComplianceIsSymmetricAndForcesBalance) {
    const CondensedSection body = block(Solid::plane_strain, Support::even, true);
    const std::size_t n = 2 * body.size();
    double largest = 0;
    for (const double c : body.compliance) largest = std::max(largest, std::abs(c));
    for (std::size_t k = 0; k < n; ++k)
        for (std::size_t i = 0; i < n; ++i)
            EXPECT_NEAR(body.compliance[k * n + i], body.compliance[i * n + k], 1e-10 * largest);
    for (const double missing : body.missing_reaction) EXPECT_NEAR(missing, 0, 1e-8);
}

}  // namespace
}  // namespace tricontact::loose_bodies_test
