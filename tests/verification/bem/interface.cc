// An elastic interface: springs k_n, k_t between the surfaces.
//   soft    springs much softer than the bodies, each alone: theory/rolling/soft_interface.h;
//   stiff   what they change falls as 1/k;
//   layer   boundary and finite elements beside each other;
//   relaxing bodies: at once and after long the elastic ones of these moduli, springs as they are.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bem/model.h"
#include "contact/base/root.h"
#include "contact/cells.h"
#include "contact/load_path.h"
#include "contact/run.h"
#include "tests/verification/bem/rig.h"
#include "theory/rolling/soft_interface.h"

namespace tricontact::bem::interface_test {
namespace {

using std::numbers::pi;

constexpr double depth = 3e-4, softness = 1e-4;

/// A half-space pressed by `depth`, uncoupled, springs of k_n a/E* = `ratio`, k_t = 0.7 k_n.
contact::Case on_springs(double ratio, double w) {
    contact::Case c = rig_case(0, .3, 8);
    c.substrate.poisson = 0;
    c.load.normal_force.reset();
    c.load.indentation = depth;
    c.contact.coupling = false;
    const double a = std::sqrt(2 * c.indenter.radius * depth);
    c.rolling->amplitude_ratio.reset();
    c.rolling->amplitude = w * a;
    c.of<contact::Cells>().spacing = a / 40;
    c.interface.normal_stiffness = ratio * c.materials().effective_modulus() / a;
    c.interface.tangential_stiffness = .7 * *c.interface.normal_stiffness;
    return c;
}

/// u of a shift on soft springs.
double reduced(const contact::Case& c, double shift) {
    return shift * *c.interface.tangential_stiffness /
           (*c.friction.coefficient * *c.interface.normal_stiffness * depth);
}

double settled(double w, double f) {
    return contact::bracketed_root(
        [&](double u) { return theory::soft_interface_settled_force(w, u) - f; }, 0., .999);
}

// Bodies add about softness to the depth and to the shift; cells of a/40 cut the rim, where p = 0:
// h^2/a^2 of the sums.
TEST(BemInterface, SoftSpringsStandAlone) {
    constexpr double w = .2, allowed = 2e-3;
    const contact::Case c = on_springs(softness, w);
    const contact::History h = run_bem(c);
    const double k_n = *c.interface.normal_stiffness, radius = c.indenter.radius;
    EXPECT_NEAR(h.scales.normal_force / (pi * k_n * radius * depth * depth), 1, allowed);
    EXPECT_NEAR(h.scales.peak_pressure / (k_n * depth), 1, allowed);
    EXPECT_NEAR(h.limit_tangential_ratio / theory::soft_interface_limit(w), 1, allowed);
    EXPECT_NEAR(reduced(c, h.static_shift), 1 - std::sqrt(1 - .3), allowed);
    EXPECT_NEAR(reduced(c, h.shift_per_period.back()) / settled(w, .3), 1, allowed);
    EXPECT_GT(settled(w, .3), 1.2 * (1 - std::sqrt(1 - .3)));  // rolling matters
}

TEST(BemInterface, StiffSpringsLeaveTheRigidInterfaceAtFirstOrder) {
    contact::Case rigid = on_springs(1, .2);
    rigid.interface = {};
    const contact::History none = run_bem(rigid);
    std::vector<double> force, shift;
    for (const double ratio : {200., 400., 800.}) {
        contact::Case normal = on_springs(ratio, .2), tangential = normal;
        normal.interface.tangential_stiffness.reset();
        tangential.interface.normal_stiffness.reset();
        force.push_back(run_bem(normal).scales.normal_force / none.scales.normal_force - 1);
        shift.push_back(run_bem(tangential).static_shift / none.static_shift - 1);
    }
    for (const auto& differences : {force, shift})
        for (int i : {0, 1})  // order 1 but for its second term, 1/200 of it
            EXPECT_NEAR(std::log2(differences[i] / differences[i + 1]), 1, .02);
    // The envelope theorem: dF = -(1/(2 k_n)) d/dd of the integral of p^2 dA, of Hertz' pressure
    // (pi/2) p0^2 a^2 ~ d^2: -(pi/2) p0^2 a^2/(k_n d). The second order and cells leave 2 %.
    const contact::HalfSpaceScales hertz = contact::half_space_scales(rigid);
    const double p0 = hertz.peak_pressure, a = hertz.contact_radius,
                 k_n = 800 * rigid.materials().effective_modulus() / std::sqrt(2 * .04 * depth);
    EXPECT_NEAR(force[2] / (-pi / 2 * p0 * p0 * a * a / (k_n * depth) / hertz.normal_force), 1,
                .02);
}

// What relaxes and what does not are no common factor of the stiffness.
TEST(BemInterface, SpringsDoNotRelax) {
    contact::Case c = on_springs(2, 0);
    c.rolling.reset();
    c.load.tangential_ratio = 0;
    c.of<contact::Cells>().spacing = std::sqrt(2 * .04 * depth) / 20;
    const auto force = [](const contact::Case& one) {
        const auto model = make_model(one, 1);
        return contact::run(one, *model).steps.back().normal_force;
    };
    const double relaxed = force(c);
    contact::Case stiff = c;
    stiff.substrate.young *= 3;
    const double unrelaxed = force(stiff);
    c.relaxation = contact::Relaxation{};
    c.relaxation->branches = {{2, 1}};  // G_0 = 3 G, within a second
    c.load.press_steps = 1;
    c.load.press_time = 1e-9;
    // Interpolated over the moduli to 1e-6 or so; the rest is what creeps in 1e-9 s.
    EXPECT_NEAR(force(c) / unrelaxed, 1, 1e-5);
    c.load.hold = 100;
    EXPECT_NEAR(force(c) / relaxed, 1, 1e-5);
    EXPECT_LT(relaxed, .9 * unrelaxed);
}

}  // namespace
}  // namespace tricontact::bem::interface_test
