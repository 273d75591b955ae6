// MDR of the layer: its normal contact against the one-dimensional exact solution, its approximate
// tangential contact against boundary elements.

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "bem/model.h"
#include "contact/cells.h"
#include "contact/run.h"
#include "contact/solvers/normal_solver.h"
#include "mdr/layer_model.h"
#include "mdr/line_surface.h"
#include "mdr/model.h"
#include "theory/layer/elastic_layer.h"

namespace tricontact::mdr_layer_test {
namespace {

using contact::Case;
using contact::NormalControl;
using mdr::LayerSprings;
using theory::LayerBase;

struct Errors {
    double radius, indentation, peak;
};

// A paraboloid pressed by the force whose exact contact has `n` elements in the radius.
Errors press(const theory::ElasticLayer& layer, double indenter_radius, double force, int n) {
    const auto exact = theory::solve_layer_contact(layer, contact::Paraboloid(indenter_radius),
                                                   {NormalControl::Kind::force, force});
    // Any place of the edge between two elements will do, the same for all n.
    const double spacing = exact.contact_radius / (n + .2);
    const LayerSprings springs({{{layer.material, layer.thickness}}, layer.base, {}}, {}, n + 8,
                               spacing);
    std::vector<double> height;
    for (const double x : springs.points().x) height.push_back(x * x / indenter_radius);
    const auto found =
        contact::NormalSolver(springs, 1e-10).solve(height, {NormalControl::Kind::force, force});
    const auto even = even_load(springs.row(), found.pressure, 0, 2 * n);
    return {even.half_width() / exact.contact_radius - 1, found.indentation / exact.indentation - 1,
            even.centre_pressure() / exact.centre_pressure - 1};
}

TEST(MdrLayer, NormalContactIsExactToTheSecondOrder) {
    const contact::Paraboloid indenter(40e-3);
    for (const double nu : {.3, .5})
        for (const auto base : {LayerBase::bonded, LayerBase::frictionless})
            for (const double thickness_over_radius : {.5, 1., 3., 10.}) {
                const double b = 5e-3;
                const theory::ElasticLayer layer{{5.2e6, nu}, b, base};
                // A force that makes about this contact.
                double force = 1;
                for (int k = 0; k < 5; ++k) {
                    const double a = theory::solve_layer_contact(
                                         layer, indenter, {NormalControl::Kind::force, force})
                                         .contact_radius;
                    force *= std::pow(b / thickness_over_radius / a, 3);
                }
                const Errors coarse = press(layer, 40e-3, force, 40),
                             middle = press(layer, 40e-3, force, 80),
                             fine = press(layer, 40e-3, force, 161);
                SCOPED_TRACE(::testing::Message()
                             << "nu " << nu << ", b/a " << thickness_over_radius << ", base "
                             << static_cast<int>(base));
                for (double Errors::*e : {&Errors::radius, &Errors::indentation, &Errors::peak}) {
                    EXPECT_NEAR(std::log2(coarse.*e / (middle.*e)), 2, .2);
                    EXPECT_NEAR(std::log(middle.*e / (fine.*e)) / std::log(2.0125), 2, .2);
                    EXPECT_LT(std::abs(fine.*e), 1e-4);
                }
            }
}

Case rig() {
    Case c;
    c.indenter.radius = 40e-3;
    c.substrate = {5.2e6, 0.5};
    c.layer.thickness = 8e-3;
    c.friction.coefficient = 0.57;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = .56;
    return c;
}

// Table 5.1.1 on its real layer, by theory::solve_layer_contact.
TEST(MdrLayer, Rig) {
    const Case c = rig();
    const auto model = mdr::make_layer_model(c);
    const auto history = contact::run(c, *model);
    const auto& s = history.scales;
    // 100 elements in the radius: 1e-5 to 3e-5; the values have four digits
    EXPECT_NEAR(s.contact_radius * 1e3, 4.3638, 1e-4);
    EXPECT_NEAR(s.indentation * 1e3, .3229, 1e-4);
    EXPECT_NEAR(s.peak_pressure * 1e-6, .5330, 1e-4);
    EXPECT_NEAR(s.unit_shift / c.friction_coefficient() * 1e3, .6651, 1e-4);
    // The approximation: boundary elements, uncoupled, have .15108 mm. As on the half-space, what
    // is left out is the traction across, 0.2 % here.
    EXPECT_NEAR(history.static_shift * 1e3 / .15108, 1.0019, 2e-4);
    // A Cattaneo-Mindlin contact of the same U_max is 5 % off.
    const double mapped = s.unit_shift * (1 - std::pow(1 - .56, 2. / 3));
    EXPECT_GT(mapped * 1e3 / .15108, 1.05);
}

// Without coupling, on a thin layer too: the static shift is 0.1 % off or less, boundary elements
// of 0.2 mm included, and 0.3 % near full sliding.
TEST(MdrLayer, StaticShiftIsThatOfBoundaryElements) {
    Case c = rig();
    c.contact.coupling = false;
    c.of<contact::Cells>().spacing = .2e-3;
    for (const double thickness : {8e-3, 4e-3})
        for (const auto& [f, allowed] : {std::pair{.09, 1e-3}, {.24, 1.5e-3}, {.56, 3e-3}}) {
            c.layer.thickness = thickness;
            c.load.tangential_ratio = f;
            const auto line = contact::run(c, *mdr::make_layer_model(c));
            const auto cells = contact::run(c, *bem::make_model(c, 1, bem::Body::layer));
            SCOPED_TRACE(::testing::Message() << "b " << thickness << ", f_T " << f);
            EXPECT_NEAR(line.scales.unit_shift / cells.scales.unit_shift, 1, 2e-4);  // of the cells
            EXPECT_NEAR(line.static_shift / cells.static_shift, 1, allowed);
        }
}

// Rolling: MDR forgets that points come back from beside; u_sd is 20 % too large at this point, on
// the half-space 17 %, and more for longer paths.
TEST(MdrLayer, RollingOverestimatesTheShift) {
    Case c = rig();
    c.contact.coupling = false;
    c.of<contact::Cells>().spacing = .2e-3;
    c.rolling.emplace();
    c.rolling->amplitude_ratio = .24;
    c.rolling->amplitude_reference = Case::AmplitudeReference::model;
    c.rolling->steps = Case::Steps::turning_points;
    c.rolling->periods = 30;
    const auto line = contact::run(c, *mdr::make_layer_model(c));
    const auto cells = contact::run(c, *bem::make_model(c, 1, bem::Body::layer));
    EXPECT_NEAR(line.shift_per_period.back() / cells.shift_per_period.back(), 1.196, 3e-3);
    EXPECT_NEAR(line.limit_tangential_ratio / cells.limit_tangential_ratio, 1, 1e-3);
}

TEST(MdrLayer, ThickLayerIsMdr) {
    Case c = rig();
    c.indenter.material = contact::Material{60e6, .3};
    c.rolling.emplace();
    c.rolling->amplitude_ratio = .4;
    c.rolling->periods = 3;
    c.load.tangential_ratio = .3;
    const auto plain = contact::run(c, *mdr::make_model(c));
    c.layer.thickness = 200;  // 1/b: 2e-5 less deep
    const auto layer = contact::run(c, *mdr::make_layer_model(c, 60));
    // 60 elements in the radius: 7e-5 of d
    EXPECT_NEAR(layer.scales.indentation / plain.scales.indentation, 1, 2e-4);
    EXPECT_NEAR(layer.scales.contact_radius / plain.scales.contact_radius, 1, 1e-4);
    EXPECT_NEAR(layer.scales.peak_pressure / plain.scales.peak_pressure, 1, 1e-4);
    EXPECT_NEAR(layer.scales.unit_shift / plain.scales.unit_shift, 1, 2e-4);
    // Edges of slip zones, too, lie between elements: h^2 = 3e-4 in multiples
    EXPECT_NEAR(layer.static_shift / plain.static_shift, 1, 4e-4);
    EXPECT_NEAR(layer.shift_per_period.back() / plain.shift_per_period.back(), 1, 1e-3);
    EXPECT_NEAR(layer.limit_tangential_ratio / plain.limit_tangential_ratio, 1, 4e-4);
}

}  // namespace
}  // namespace tricontact::mdr_layer_test
