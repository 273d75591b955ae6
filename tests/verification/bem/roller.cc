// A roller with its ends by boundary elements: the middle beside the exact line contact, the ends
// beside the singularity of a sharp edge.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "bem/model.h"
#include "comparisons/quantities/roller_ends.h"
#include "contact/cells.h"
#include "contact/load_path.h"
#include "contact/run.h"
#include "theory/layer/line_contact.h"

namespace tricontact::bem_roller_test {
namespace {

using contact::Case;

/// A piece of the thesis' rig on its layer of 5 mm, under its load per length.
Case roller(double length, double cells, double chamfer = 0) {
    Case c;
    c.indenter.shape = Case::Shape::roller;
    c.indenter.radius = 40e-3;
    c.indenter.length = length;
    c.indenter.chamfer = chamfer;
    c.substrate = {3.6e6, .5};
    c.layer.thickness = 5e-3;
    c.friction.coefficient = .79;
    c.load.normal_force = 32.3 * length / 80e-3;
    c.contact.coupling = false;
    c.of<contact::Cells>().per_radius = cells;
    return c;
}

std::unique_ptr<contact::Model> pressed(const Case& c, bem::Body body) {
    auto model = bem::make_model(c, 1, body);
    contact::LoadStep step = contact::press_step(c);
    step.friction = false;
    model->advance(step);
    return model;
}

std::vector<comparisons::RollerSection> pressed_sections(const Case& c, bem::Body body) {
    return comparisons::roller_sections(pressed(c, body)->surface(), c.indenter.length);
}

// Six thicknesses from the ends the middle of a roller on a bonded layer does not know of them.
TEST(BemRoller, MiddleIsTheLineContactOfItsIndentation) {
    for (const double chamfer : {0., 1e-3}) {
        const Case c = roller(60e-3, 8, chamfer);
        const auto model = pressed(c, bem::Body::layer);
        const auto middle =
            comparisons::roller_sections(model->surface(), c.indenter.length).back();
        const auto exact = theory::solve_line_contact(
            {c.substrate, *c.layer.thickness, theory::LayerBase::bonded}, c.indenter.radius,
            {theory::LineControl::Kind::indentation, model->scales().indentation});
        // The edge between cells of a/8: (1/8)^2; within the contact the pressure is smoother.
        EXPECT_NEAR(middle.half_width / exact.half_width, 1, .015) << chamfer;
        EXPECT_NEAR(middle.pressure / exact.centre_pressure, 1, 3e-3) << chamfer;
    }
}

// p ~ y^(-1/2) under a sharp rigid edge: the mean of the second row over that of the outermost is
// 2^(1/2) - 1; y^(-0.23) of two equal materials would make it 0.71. The regular part takes some of
// it, less in smaller cells.
TEST(BemRoller, SharpEndsAreSingular) {
    for (const auto body : {bem::Body::half_space, bem::Body::layer}) {
        double before = 1;
        for (const double cells : {8., 16., 32.}) {
            const auto sections = pressed_sections(roller(20e-3, cells), body);
            const double excess = sections[1].pressure / sections[0].pressure - (std::sqrt(2.) - 1);
            EXPECT_GT(excess, 0) << cells;
            EXPECT_LT(excess, .7 * before) << cells;
            before = excess;
        }
        EXPECT_LT(before, .04);
    }
}

// On a substrate that goes on, rounded ends bear it like sharp ones but for their tip: the contact
// is widest next to where the rounding begins, and closes on it.
TEST(BemRoller, RoundedEndsMakeADogBone) {
    const double chamfer = 1e-3;
    for (const auto& [body, widest] :
         {std::pair(bem::Body::half_space, 1.2), {bem::Body::layer, 1.04}}) {
        const Case c = roller(20e-3, 16, chamfer);
        const auto sections = pressed_sections(c, body);
        const auto knuckle = std::max_element(
            sections.begin(), sections.end(),
            [](const auto& a, const auto& b) { return a.half_width < b.half_width; });
        EXPECT_GT(sections.front().distance, .5 * chamfer);
        EXPECT_NEAR(knuckle->distance, chamfer, .2 * chamfer);  // a cell and a half
        EXPECT_GT(knuckle->half_width / sections.back().half_width, widest);
    }
}

// On the layer the knuckle is followed by a neck, which reaches farther; the half-space has none.
TEST(BemRoller, LayerHasANeckBehindTheKnuckle) {
    for (const auto body : {bem::Body::half_space, bem::Body::layer}) {
        const Case c = roller(40e-3, 8);
        contact::History history;
        history.snapshots.push_back({0, pressed(c, body)->surface()});
        const auto ends = comparisons::roller_ends(c, history).value();
        if (body == bem::Body::half_space) {
            EXPECT_EQ(ends.knuckle, ends.reach);
        } else {
            EXPECT_LT(ends.knuckle, 1e-3);
            EXPECT_GT(ends.reach, 4e-3);
        }
    }
}

// What the ends change belongs to them: it is a third as much of a roller three times as long.
TEST(BemRoller, RollsAsTheLineContactButForItsEnds) {
    const auto rolled = [](Case c) {
        c.load.tangential_ratio = .5;
        c.rolling.emplace();
        c.rolling->amplitude_ratio = .26;
        c.rolling->amplitude_reference = Case::AmplitudeReference::model;
        c.rolling->steps = Case::Steps::turning_points;
        c.rolling->periods = 8;
        return contact::run(c, *bem::make_model(c, 1, bem::Body::layer));
    };
    std::vector<double> missing, limits;
    for (const double length : {20e-3, 60e-3}) {
        Case c = roller(length, 8);
        const auto ended = rolled(c);
        c.indenter.shape = Case::Shape::cylinder;
        const auto plane = rolled(c);
        EXPECT_EQ(ended.verdict.state, contact::State::shakedown);
        missing.push_back(1 - ended.shift_per_period.back() / plane.shift_per_period.back());
        limits.push_back(1 - ended.limit_tangential_ratio / plane.limit_tangential_ratio);
    }
    EXPECT_NEAR(missing[0] / missing[1], 3, .3);
    EXPECT_LT(std::abs(missing[1]), .02);
    EXPECT_LT(std::abs(limits[1]), 2e-3);  // of the size of the grid's own error
}

}  // namespace
}  // namespace tricontact::bem_roller_test
