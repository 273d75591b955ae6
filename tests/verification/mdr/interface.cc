// MDR of the half-space on an elastic interface, springs k_n, k_t between the surfaces:
//   soft    springs much softer than the bodies, each alone: theory/rolling/soft_interface.h;
//   stiff   what they change of the force falls as 1/k_n, by the envelope theorem;
//   between boundary elements, where nothing couples: pressed exact, along the surface what the
//           mean over the circle leaves out;
//   limit cases: the other laws of friction, a rigid interface.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "bem/model.h"
#include "contact/base/error.h"
#include "contact/base/root.h"
#include "contact/cells.h"
#include "contact/load_path.h"
#include "contact/run.h"
#include "mdr/model.h"
#include "mdr/settings.h"
#include "theory/rolling/soft_interface.h"

namespace tricontact::mdr_interface_test {
namespace {

using std::numbers::pi;

constexpr double depth = 3e-4, radius = 40e-3;

/// A half-space pressed by `depth`, uncoupled, springs of k_n a/E* = `ratio`, k_t = `along` k_n.
contact::Case on_springs(double ratio, double along, double w) {
    contact::Case c;
    c.indenter.radius = radius;
    c.substrate = {5.2e6, 0};
    c.friction.coefficient = .57;
    c.contact.coupling = false;
    c.load.indentation = depth;
    c.load.tangential_ratio = .3;
    c.rolling = contact::Case::Rolling{};
    c.rolling->periods = 40;
    const double a = std::sqrt(2 * radius * depth);
    c.rolling->amplitude = w * a;
    c.interface.normal_stiffness = ratio * c.materials().effective_modulus() / a;
    c.interface.tangential_stiffness = along * *c.interface.normal_stiffness;
    return c;
}

contact::History run(const contact::Case& c, bool by_cells = false) {
    const auto model = by_cells ? bem::make_model(c, 1) : mdr::make_model(c);
    EXPECT_EQ(model->name(), by_cells ? "bem" : "mdr");
    contact::History h = contact::run(c, *model);
    EXPECT_TRUE(model->audit().passed());
    return h;
}

double settled(double w, double f) {
    return contact::bracketed_root(
        [&](double u) { return theory::soft_interface_settled_force(w, u) - f; }, 0., .999);
}

// On the line each spring of the surface is coupled to all: that springs alone come out of it tells
// both apart. Elements of a/100 cut the rim.
TEST(MdrInterface, SoftSpringsStandAlone) {
    constexpr double w = .2, allowed = 2e-3;
    const contact::Case c = on_springs(1e-4, .7, w);
    const contact::History h = run(c);
    const double k_n = *c.interface.normal_stiffness, k_t = *c.interface.tangential_stiffness;
    EXPECT_NEAR(h.scales.normal_force / (pi * k_n * radius * depth * depth), 1, allowed);
    EXPECT_NEAR(h.scales.peak_pressure / (k_n * depth), 1, allowed);
    EXPECT_NEAR(h.static_shift * k_t / (.57 * k_n * depth), 1 - std::sqrt(1 - .3), allowed);
    EXPECT_NEAR(h.limit_tangential_ratio / theory::soft_interface_limit(w), 1, allowed);
    const double u = h.shift_per_period.back() * k_t / (.57 * k_n * depth);
    // What settles is the line's: rolling counts for more, here as in all of MDR.
    EXPECT_GT(u, settled(w, .3));
    EXPECT_LT(u, 1.25 * settled(w, .3));
}

// dF = -(1/(2 k_n)) d/dd of the integral of p^2 dA, of Hertz' pressure -(pi/2) p0^2 a^2/(k_n d).
TEST(MdrInterface, StiffSpringsLeaveTheRigidInterfaceAtFirstOrder) {
    contact::Case rigid = on_springs(1, 1, .2);
    rigid.interface = {};
    const contact::HalfSpaceScales hertz = contact::half_space_scales(rigid);
    const double p0 = hertz.peak_pressure, a = hertz.contact_radius;
    std::vector<double> force;
    for (const double ratio : {200., 400.}) {
        const contact::Case c = on_springs(ratio, 1, .2);
        const double first = -pi / 2 * p0 * p0 * a * a / (*c.interface.normal_stiffness * depth);
        force.push_back((run(c).scales.normal_force - hertz.normal_force) / first);
    }
    // The second order of springs, and elements of a/100 at the edge: 1 % of the difference.
    for (const double share : force) EXPECT_NEAR(share, 1, .01);
}

// With k_t/k_n = G*/E* shifts at rest are depths times mu (Jaeger, Ciavarella), exactly on both;
// else what the line leaves out is seen.
TEST(MdrInterface, PressesAndShiftsAsBoundaryElements) {
    for (const double along : {1., .4}) {
        contact::Case c = on_springs(1, along, .2);
        c.of<contact::Cells>().spacing = std::sqrt(2 * radius * depth) / 40;
        const contact::History line = run(c), cells = run(c, true);
        EXPECT_NEAR(line.scales.normal_force / cells.scales.normal_force, 1, 2e-3);
        EXPECT_NEAR(line.scales.peak_pressure / cells.scales.peak_pressure, 1, 2e-3);
        EXPECT_NEAR(line.scales.contact_radius / cells.scales.contact_radius, 1, 2e-2);  // counted
        EXPECT_NEAR(line.static_shift / cells.static_shift, 1, along == 1 ? 2e-3 : 1e-2) << along;
        EXPECT_NEAR(line.limit_tangential_ratio, cells.limit_tangential_ratio, 3e-3);
    }
}

TEST(MdrInterface, KnowsOtherLawsAndForces) {
    contact::Case c = on_springs(1, 1, .2);
    c.load.indentation.reset();
    c.load.normal_force = 20;
    c.friction = {.shear_strength = 1e5};
    c.of<contact::Cells>().spacing = 2e-4;
    const contact::History line = run(c), cells = run(c, true);
    EXPECT_NEAR(line.friction_limit / cells.friction_limit, 1, .02);  // an area, of cells counted
    EXPECT_NEAR(line.static_shift / cells.static_shift, 1, .03);
}

TEST(MdrInterface, RefusesWhatItCannotDo) {
    contact::Case c = on_springs(1, 1, .2);
    c.relaxation = contact::Relaxation{{{1, 1}}, {}};
    EXPECT_THROW(mdr::make_model(c), contact::InputError);
    c.relaxation.reset();
    c.rolling->amplitude = 1;
    EXPECT_THROW(mdr::make_model(c), contact::InputError);  // too many elements
}

}  // namespace
}  // namespace tricontact::mdr_interface_test
