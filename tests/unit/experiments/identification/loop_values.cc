#include "experiments/identification/loop_values.h"

#include <gtest/gtest.h>

#include <string>

#include "io/case/case_reader.h"
#include "mdr/layer_model.h"

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

}  // namespace tricontact::experiments::loop_values_test
