#include "experiments/identification/loop_values.h"

#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include "contact/base/special_values.h"
#include "contact/half_space_scales.h"
#include "io/case/case_reader.h"
#include "mdr/layer_model.h"
#include "theory/oscillating_cylinder.h"

namespace tricontact::experiments::loop_values_test {

namespace {

/// A rigid ball on bonded rubber under 60 N.
IdentifiedRig rig(const std::string& thickness, bool on_layer) {
    IdentifiedRig rig{.as_case = io::parse_case(R"(
models = ["mdr-layer"]
indenter.radius = "40 mm"
substrate = {young = "5.2 MPa", poisson = 0.5, thickness = ")" +
                                                    thickness +
                                                    R"("}
friction.coefficient = 0.6
load = {normal_force = "60 N", tangential_ratio = 0.5}
rolling.amplitude = "1 um"
rolling.periods = 1
)",
                                                "ball.toml", {})};
    rig.loops_on_layer = on_layer;
    return rig;
}

constexpr double force = 60, limit = .6 * force;

}  // namespace

// Of a layer a thousand radii thick Mindlin's closed form holds, to what its tables leave, 1e-4.
TEST(LoopValues, OfAThickLayerAreThoseOfTheHalfSpace) {
    const LoopCurve layer = loop_curve(rig("5 m", true), force),
                    half_space = loop_curve(rig("5 m", false), force);
    const double slid = half_space.sliding_shift();
    EXPECT_NEAR(layer.sliding_shift(), slid, 1e-3 * slid);
    for (const double share : {.1, .4, .8, 1.2}) {
        EXPECT_NEAR(layer.at(share * slid, 1).force, half_space.at(share * slid, 1).force,
                    1e-3 * limit);
        const double energy = half_space.energy(share * slid, 1);
        EXPECT_NEAR(layer.energy(share * slid, 1), energy, 2e-3 * limit * slid);
    }
}

// On 8 mm against the line of springs that takes the cycle step by step: Masing's rule holds for
// springs that a layer couples as well.
TEST(LoopValues, OfALayerAreThoseOfItsCoupledSprings) {
    const IdentifiedRig on_layer = rig("8 mm", true);
    const LoopCurve curve = loop_curve(on_layer, force);
    const auto model = mdr::make_layer_model(on_layer.as_case, 60);
    const auto force_at = [&](double shift, double& work) {
        contact::LoadStep step;
        step.normal = {contact::NormalControl::Kind::force, force};
        step.tangential[0] = {contact::TangentialControl::Kind::shift, shift};
        const contact::StepRecord found = model->advance(step);
        work += found.dissipation;
        return found.tangential_force[0];
    };
    const double amplitude = .6 * curve.sliding_shift();
    double before = 0, cycle = 0;
    // Elements of a sixtieth of the radius.
    EXPECT_NEAR(force_at(amplitude, before), curve.at(amplitude, 1).force, 2e-3 * limit);
    EXPECT_NEAR(force_at(.2 * amplitude, cycle),
                curve.at(amplitude, 1).force - 2 * curve.at(.4 * amplitude, 1).force, 2e-3 * limit);
    force_at(-amplitude, cycle);
    force_at(amplitude, cycle);
    EXPECT_NEAR(cycle, curve.energy(amplitude, 1), 5e-3 * cycle);
}

// A line contact's loop has the closed work of a cycle in partial slip, whatever the datum of its
// shift, and with the rig in series; of gross slip 4 mu F_N dU more. What the tables of the curve
// leave is 1e-4 of the force.
TEST(LoopValues, OfACylinderHaveTheClosedWorkOfACycle) {
    IdentifiedRig line{.as_case = io::parse_case(R"(
models = ["bem"]
indenter = {shape = "cylinder", radius = "20 mm", length = "10 mm", young = "206 GPa", poisson = 0.3}
substrate = {young = "206 GPa", poisson = 0.3}
friction.coefficient = 0.6
load = {normal_force = "2 kN", tangential_ratio = 0.5}
)",
                                                 "cylinder.toml", {})};
    const double load = 2000, sliding = .6 * load;
    const double scale = 2 * sliding * sliding /
                         (std::numbers::pi * line.as_case.materials().effective_modulus() * 10e-3);
    for (const double rig_stiffness : {contact::infinity, 40e6}) {
        line.rig_compliance = 1 / rig_stiffness;
        const LoopCurve curve = loop_curve(line, load);
        for (const double f : {.3, .6, .9, .99}) {
            const double lambda = contact::line_shift_factor(line.as_case);
            const double shift = contact::half_space_scales(line.as_case).unit_shift *
                                     theory::line_static_shift_ratio(f, lambda) +
                                 f * sliding / rig_stiffness;
            EXPECT_NEAR(curve.at(shift, 1).force, f * sliding, 1e-4 * sliding) << f;
            EXPECT_NEAR(curve.energy(shift, 1), scale * theory::line_cycle_dissipation(f),
                        1e-4 * sliding * shift)
                << f;
        }
        const double slide = curve.sliding_shift();
        EXPECT_NEAR(curve.energy(2 * slide, 1), scale + 4 * sliding * slide,
                    1e-4 * sliding * slide);
    }
}

}  // namespace tricontact::experiments::loop_values_test
