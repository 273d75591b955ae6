// Friction that remembers the way of slip on a body that relaxes: the law asks for no time, so that
// very slow loads find the states of the relaxed body, very fast ones those of the unrelaxed.

#include <gtest/gtest.h>

#include <cmath>

#include "bem/model.h"
#include "contact/cells.h"
#include "contact/prescribed_path.h"
#include "contact/run.h"
#include "tests/verification/bem/rig.h"

namespace tricontact::bem::slip_memory_relaxing_test {
namespace {

using contact::Case;
using contact::NormalControl;
using contact::TangentialControl;

/// Pressed by 0.3 mm, then shifted to and fro, a row within each `time` [s].
Case shifted(double time, bool coupled) {
    Case c = rig_case(0, .1, 1);
    c.rolling.reset();
    c.substrate.poisson = .3;
    c.indenter.material.reset();
    c.contact.coupling = coupled;
    c.load = {};
    c.load.indentation = 3e-4;
    c.load.tangential_force = 0;
    c.load.press_time = time;
    c.of<contact::Cells>().spacing = 5e-4;
    c.prescribed_path.emplace();
    double now = 0;
    for (const double shift : {0., 1e-4, 2e-4, 5e-5, -1e-4}) {
        contact::PrescribedPath::Row row;
        row.time = now += time;
        row.normal = {NormalControl::Kind::indentation, 3e-4};
        row.tangential[0] = {TangentialControl::Kind::shift, shift};
        row.tangential[1] = {TangentialControl::Kind::shift, 0};
        row.steps = 2;
        c.prescribed_path->rows.push_back(row);
    }
    return c;
}

void expect_elastic_states(const contact::Friction& friction, bool coupled) {
    for (const bool slow : {false, true}) {
        Case c = shifted(slow ? 1e6 : 1e-9, coupled);
        c.friction = friction;
        Case elastic = c;
        elastic.substrate.young *= slow ? 1 : 3;
        c.relaxation = contact::Relaxation{};
        c.relaxation->branches = {{2, 1}};  // G_0 = 3 G, within a second
        const auto relaxing = run_bem(c), same = run_bem(elastic);
        const double scale = same.friction_limit, length = 1e-4;
        constexpr std::size_t n_shifted = 8;  // after pressing, whose steps may differ
        for (std::size_t k = 1; k <= n_shifted; ++k) {
            const auto& one = relaxing.steps[relaxing.steps.size() - k];
            const auto& other = same.steps[same.steps.size() - k];
            // What creeps is 1e-6 or less; coupled contact is interpolated over the moduli.
            EXPECT_NEAR((one.tangential_force[0] - other.tangential_force[0]) / scale, 0, 1e-4)
                << k << ' ' << slow << ' ' << coupled;
            EXPECT_NEAR((one.dissipation - other.dissipation) / (scale * length), 0, 1e-4)
                << k << ' ' << slow << ' ' << coupled;
        }
        EXPECT_GT(same.steps.back().dissipation, .01 * scale * length);
    }
}

TEST(BemSlipMemoryRelaxing, SlowIsRelaxedAndFastIsUnrelaxed) {
    for (const bool coupled : {false, true}) {
        contact::Friction hard, falling;
        hard.coefficient = falling.coefficient = .5;
        hard.yield = contact::InterfaceYield{5e4, 2e9};
        falling.weakening = {contact::FrictionWeakening::Law::exponential, .2, 4e-5};
        expect_elastic_states(hard, coupled);
        expect_elastic_states(falling, coupled);
    }
}

// Held at its shift a stuck contact loses traction with its modulus; what has flowed stays.
TEST(BemSlipMemoryRelaxing, TractionsOfALayerRelaxAndItsFlowStays) {
    Case c = shifted(1e-9, false);
    c.friction.yield = contact::InterfaceYield{5e4, 2e9};
    c.prescribed_path->rows.resize(3);
    auto row = c.prescribed_path->rows.back();
    row.time += 1e6;
    c.prescribed_path->rows.push_back(row);
    c.relaxation = contact::Relaxation{};
    c.relaxation->branches = {{2, 1}};
    const auto h = run_bem(c);
    const auto& loaded = h.steps[h.steps.size() - 3];
    const auto& held = h.steps.back();
    EXPECT_LT(held.tangential_force[0], .8 * loaded.tangential_force[0]);
    EXPECT_GT(held.tangential_force[0], .1 * loaded.tangential_force[0]);
}

}  // namespace
}  // namespace tricontact::bem::slip_memory_relaxing_test
