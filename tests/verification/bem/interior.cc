// Below contacts of boundary elements: Hertz, sliding spheres, line contact, and what passes
// through a layer.

#include "contact/compliances/interior.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bem/grid_interior.h"
#include "contact/cells.h"
#include "tests/verification/bem/rig.h"
#include "theory/half_space_interior.h"

namespace tricontact::bem::bem_interior_test {
namespace {

using contact::Case;
using contact::Interior;
using contact::Material;
using contact::TangentialField;

constexpr double pi = std::numbers::pi;

Case pressed_case(double cells_per_radius) {
    Case c = rig_case(.2, 0, 1);
    c.substrate = {5.2e6, .3};
    c.rolling.reset();
    c.contact.coupling = false;  // Hertz' theory has no friction
    c.of<contact::Cells>().spacing.reset();
    c.of<contact::Cells>().per_radius = cells_per_radius;
    return c;
}

struct Fields {
    Interior interior;
    contact::HalfSpaceScales hertz;
    Material substrate;
};

Fields fields_of(const Case& c) {
    const auto model = make_model(c, 1);
    contact::run(c, *model);
    return {*model->interior(), contact::half_space_scales(c), c.substrate};
}

/// Largest deviation of any stress over p0 from the exact one under Hertz' pressure and `friction`
/// times it along x, among points deeper than 0.2 a.
double worst_stress(const Fields& fields, double friction) {
    const double a = fields.hertz.contact_radius, p0 = fields.hertz.peak_pressure;
    const auto line_load = [&](double t) { return pi / 2 * p0 * (a - t) * (a + t) / a; };
    double worst = 0;
    const std::size_t stride = fields.interior.size() / 3000;
    for (std::size_t k = 0; k < fields.interior.size(); k += stride) {
        const auto [x, y, z] = fields.interior.position(k);
        if (z > -.2 * a) continue;
        const auto due =
            theory::axisymmetric_interior(fields.substrate, line_load, a, x, y, -z).stress;
        for (int c = 0; c < 6; ++c) {
            const double sign = c >= 4 ? -1 : 1;  // z out of the substrate here
            worst = std::max(worst, std::abs(fields.interior.stress[k][c] -
                                             sign * (due[c][2] + friction * due[c][0])));
        }
    }
    return worst / p0;
}

// Cells of constant traction: second order but for the edge of the contact between them.
TEST(BemInterior, BelowHertzContactOfSecondOrder) {
    std::vector<double> errors;
    for (const double cells : {8., 16.5, 33.})
        errors.push_back(worst_stress(fields_of(pressed_case(cells)), 0));
    EXPECT_LT(errors.back(), 1e-3);
    EXPECT_GT(std::log(errors.front() / errors.back()) / std::log(33. / 8), 1.5);
}

// Johnson (1985), section 4.2, to the printed digits; 0.04 a between depths.
TEST(BemInterior, PeaksWhereHertzContactDoes) {
    const Fields fields = fields_of(pressed_case(33));
    const auto s = contact::subsurface_of(fields.interior, 0, {0, 0});
    EXPECT_NEAR(s.peak_von_mises / fields.hertz.peak_pressure, .62, .005);
    EXPECT_NEAR(s.peak_position[2] / fields.hertz.contact_radius, -.48, .02);
    EXPECT_EQ(s.peak_position[0], 0);
    EXPECT_EQ(s.peak_position[1], 0);
}

// Under full slip all tractions are mu p: Hamilton and Goodman (1966).
TEST(BemInterior, BelowASlidingSphere) {
    for (const double mu : {.25, .5}) {
        Case c = pressed_case(20);
        c.friction.coefficient = mu;
        c.load.tangential_ratio = 1 - 1e-9;
        EXPECT_LT(worst_stress(fields_of(c), mu), 2.5e-3);
    }
}

// McEwen (1949), Johnson (1985), eq. 4.49: one row of cells as long as 40 000 a, looked at in its
// middle; sigma_y lacks about a over that length.
double line_contact_error(int cells) {
    const double a = 2e-3, p0 = 3e5, nu = .3, h = a / cells;
    const int n = 2 * cells + 5;
    const auto grid = contact::ContactPoints::grid(n, 1, {-(n / 2) * h, 0}, {h, 40000 * a});
    std::vector<double> p(n);
    const auto integral = [&](double x) {  // of sqrt(1 - x^2)
        x = std::clamp(x, -1., 1.);
        return (x * std::sqrt(1 - x * x) + std::asin(x)) / 2;
    };
    for (int i = 0; i < n; ++i)
        p[i] = p0 * a / h * (integral((grid.x[i] + h / 2) / a) - integral((grid.x[i] - h / 2) / a));
    const Interior fields = grid_interior({InteriorBody({5e6, nu}), {0, .3 * a, a, 2 * a}, 1}, grid,
                                          p, TangentialField(n));
    double worst = 0;
    for (std::size_t k = 0; k < fields.size(); ++k) {
        const auto [x, y, z] = fields.position(k);
        if (z == 0 || y != 0) continue;
        const double X = x / a, Z = -z / a, s = 1 - X * X + Z * Z;
        const double root = std::sqrt(s * s + 4 * X * X * Z * Z);
        const double m2 = (root + s) / 2, n2 = (root - s) / 2, m = std::sqrt(m2);
        const double ratio = (Z * Z + n2) / (m2 + n2);
        const double sigma_x = -(m * (1 + ratio) - 2 * Z), sigma_z = -m * (1 - ratio);
        for (const auto& [component, due] :
             {std::pair(0, sigma_x), std::pair(2, sigma_z), std::pair(1, nu * (sigma_x + sigma_z))})
            worst = std::max(worst, std::abs(fields.stress[k][component] / p0 - due));
    }
    return worst;
}

TEST(BemInterior, BelowALineContactOfOneRow) {
    const double coarse = line_contact_error(10), fine = line_contact_error(41);
    EXPECT_LT(fine, 5e-4);
    EXPECT_GT(std::log(coarse / fine) / std::log(4.1), 1.8);
    // More than 256 cells are taken by three, as long as the row.
    EXPECT_LT(line_contact_error(130), 5e-4);
}

// What is pressed and pushed on top arrives at every depth of a bonded layer, down to its base: the
// stress over a plane 20 b wide, beyond which exp(-10 b/b) of it is left.
TEST(BemInterior, ForcePassesThroughEveryDepthOfALayer) {
    const double b = 2e-3, h = b / 6;
    const int n = 121;
    const auto grid = contact::ContactPoints::grid(n, n, {-60 * h, -60 * h}, {h, h});
    std::vector<double> p(grid.size());
    TangentialField t(grid.size());
    for (std::size_t i = 0; i < p.size(); ++i)
        if (std::hypot(grid.x[i], grid.y[i]) < 4 * h) {
            p[i] = 2e5;
            t.x[i] = 7e4;
            t.y[i] = -3e4;
        }
    for (const double nu : {.3, .5}) {
        const Material material{5e6, nu};
        const InteriorBody body(theory::LayerStack{{{material, b}}, theory::LayerBase::bonded, {}});
        const Interior fields = grid_interior({body, {0, b / 2, b}, 1}, grid, p, t);
        std::array<std::array<double, 3>, 3> force{};  // per level from below
        for (std::size_t k = 0; k < fields.size(); ++k) {
            const auto [x, y, z] = fields.position(k);
            if (std::abs(x) > 60.5 * h || std::abs(y) > 60.5 * h) continue;
            auto& at = force[z == 0 ? 2 : z > -.9 * b ? 1 : 0];
            for (const auto& [d, component] : {std::pair(0, 5), std::pair(1, 4), std::pair(2, 2)})
                at[d] += h * h * fields.stress[k][component];
        }
        for (const auto& at : force)
            for (int d = 0; d < 3; ++d)
                EXPECT_NEAR(at[d], fields.applied[d], 2e-3 * std::abs(fields.applied[2]));
    }
}

}  // namespace
}  // namespace tricontact::bem::bem_interior_test
