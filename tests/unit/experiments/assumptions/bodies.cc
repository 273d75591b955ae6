// A rig whose body is neither sphere nor cylinder; its contacts come from models that the caller
// has.
#include <cmath>

#include "tests/unit/experiments/assumptions/rig_reports.h"

namespace tricontact::body_test {
namespace {

using experiments::BodyContact;
using experiments::Rig;

/// On the layer all is `by` smaller; coupling takes the same off again.
Rig body_rig(double by) {
    const BodyContact half_space{{1e-3, 1e-6}, {5e-3, 1e-5}, {3e5, 1e3}, {8e-5, 1e-7}};
    BodyContact layer = half_space;
    for (auto* one :
         {&layer.indentation, &layer.contact_radius, &layer.peak_pressure, &layer.static_shift})
        one->value *= 1 - by;
    Rig rig = rig_file("sphere_parallel");
    rig.kind = Rig::Kind::body;
    rig.R = rig.a_reference = rig.D_c = {};
    rig.measured.clear();
    rig.printed.clear();
    rig.body = {half_space, layer, {layer.static_shift.value * (1 - by)}};
    return rig;
}

TEST(RigOfABody, HasBothSidesOfEachThreshold) {
    const auto near = experiments::check_rig(body_rig(.01)),
               far = experiments::check_rig(body_rig(.2));
    for (const char* name : {"half_space", "uncoupled"}) {
        EXPECT_FALSE(assumption_of(near, name).criteria.empty());
        for (const auto& criterion : assumption_of(near, name).criteria)
            EXPECT_EQ(criterion.standing(), experiments::Standing::holds);
        for (const auto& criterion : assumption_of(far, name).criteria)
            EXPECT_EQ(criterion.standing(), experiments::Standing::violated);
    }
}

TEST(RigOfABody, TellsWhatTheHalfSpaceDoesToEachMeasuredQuantity) {
    const auto report = experiments::check_rig(body_rig(.2));
    int n_half_space = 0;
    for (const auto& effect : report.effects) {
        if (effect.assumption != "half_space") continue;
        EXPECT_NEAR(effect.relative.value, 1 / .8 - 1, 1e-12);
        ++n_half_space;
    }
    EXPECT_EQ(n_half_space, 3);  // static shift, indentation, contact radius
}

// Infinite under a conical tip: no criterion, no sentence.
TEST(RigOfABody, LeavesThePressureUnderATipOut) {
    Rig rig = body_rig(.2);
    rig.body->half_space.peak_pressure = rig.body->layer.peak_pressure = {std::nan("")};
    const auto report = experiments::check_rig(rig);
    const auto& half_space = assumption_of(report, "half_space");
    EXPECT_EQ(half_space.criteria.size(), 3u);
    EXPECT_EQ(half_space.consequence.find("pressure"), std::string::npos);
}

}  // namespace
}  // namespace tricontact::body_test
