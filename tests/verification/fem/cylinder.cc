// Normal contact of a cylinder on the finite element layer in plane strain, against the exact one
// (theory/layer/line_contact).

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <numbers>

#include "tests/verification/fem/line_rig.h"

namespace tricontact::fem::fem_cylinder_test {
namespace {

using contact::Case;

constexpr double pi = std::numbers::pi;

TEST(FemCylinder, TheRigsNumbers) {
    const Case c = line_case(.2e-3);
    const auto model = make_layer_model(c);
    press(*model, c);
    const contact::Scales s = model->scales();
    // layer.md, cylinder rig; tolerances as of the sphere's (fem_layer_normal.cc),
    // but of the width, whose edge lies between two nodes across the whole length
    EXPECT_NEAR(2 * s.contact_radius, 3.861e-3, 5e-3 * 3.861e-3);
    EXPECT_NEAR(s.indentation, .0647e-3, 1e-3 * .0647e-3);
    EXPECT_NEAR(s.peak_pressure, .1336e6, 5e-3 * .1336e6);
}

class FemCylinderOf : public testing::TestWithParam<double> {};

// Indentation at the given force. The square root at the contact's edge limits the order, and whole
// elements enter one after the other: no clean power, as under the sphere.
TEST_P(FemCylinderOf, IndentationConverges) {
    const auto error = [](double size) {
        const Case c = line_case(size, GetParam());
        return press(*make_layer_model(c), c).indentation / exact_line(c).indentation - 1;
    };
    const double coarse = error(.8e-3), middle = error(.4e-3), fine = error(.2e-3);
    EXPECT_GT(order(coarse, fine, 4), 1.3) << coarse << ' ' << middle << ' ' << fine;
    EXPECT_LT(std::abs(fine), 1e-3);
    EXPECT_LT(std::abs(middle), std::abs(coarse));
}

TEST_P(FemCylinderOf, PressureIsTheExactOneAllAlong) {
    const Case c = line_case(.2e-3, GetParam());
    const auto model = make_layer_model(c);
    press(*model, c);
    const theory::LineContact exact = exact_line(c);
    const contact::Surface s = model->surface();
    double worst = 0;
    for (int i = 0; i < s.n_x; ++i)
        if (const double x = s.x(i); std::abs(x) < .8 * exact.half_width)
            worst = std::max(worst, std::abs(s.normal_traction[i] - exact.pressure(x)));
    EXPECT_LT(worst, 1e-2 * exact.centre_pressure);  // row sums, the steep end some nodes away
}

INSTANTIATE_TEST_SUITE_P(Rig, FemCylinderOf, testing::Values(.3, .5), [](const auto& test) {
    return test.param == .5 ? "Incompressible" : "Compressible";
});

/// u_x in the middle under the exact pressure times mu, from the layer's compliance C11:
/// (mu/pi) ∫ C11(k) p^(k) dk, p^(k) = pi sum of c_m (-1)^m J_2m(k a).
double exact_unit_shift(const Case& c) {
    const theory::LineContact line = exact_line(c);
    const theory::ElasticLayer layer{c.substrate, *c.layer.thickness, theory::LayerBase::bonded};
    const auto integrand = [&](double k) {
        double transform = 0;
        for (std::size_t m = 0; m < line.edge_load_modes.size(); ++m)
            transform += (m % 2 == 0 ? 1 : -1) * line.edge_load_modes[m] *
                         std::cyl_bessel_j(2. * static_cast<double>(m), k * line.half_width);
        return pi * transform * theory::layer_compliance(layer, k).along;
    };
    // Panels of half a wave of the contact; C11 p^ falls as k^-2.5: 1e-5 is left of the tail.
    double sum = 0;
    const double panel = pi / line.half_width;
    for (int i = 0; i < 400; ++i)
        sum += boost::math::quadrature::gauss<double, 20>::integrate(integrand, i * panel,
                                                                     (i + 1) * panel);
    return c.friction_coefficient() * sum / pi;
}

TEST(FemCylinder, UnitOfShiftIsThatOfTheLayersCompliance) {
    const Case c = line_case(.25e-3);
    const auto model = make_layer_model(c);
    press(*model, c);
    EXPECT_NEAR(model->scales().unit_shift / exact_unit_shift(c), 1, 1e-3);
}

}  // namespace
}  // namespace tricontact::fem::fem_cylinder_test
