#include "fem/finite_strain/step_slip.h"

#include <gtest/gtest.h>

#include <numbers>

#include "contact/bodies/shapes_of_revolution.h"

namespace tricontact::step_slip_test {
namespace {

using contact::Paraboloid;
using contact::Sphere;
using contact::Vector2;
using contact::operator+, contact::operator-;
using fem::ContactFrames;
using fem::IndenterMotion;
using fem::Pose;
using fem::StepSlip;
using fem::Vector3;

constexpr double radius = .04;      // [m]
constexpr double depth = .3e-3;     // [m]
constexpr double rounding = 1e-16;  // of lengths of a radius, in a few operations [m]: 10 eps R

/// A point of the indenter's surface.
Vector3 on_surface(const contact::Indenter& indenter, const Pose& pose,
                   const Vector2& from_lowest) {
    const Vector2 x = pose.lowest_point() + from_lowest;
    return {x[0], x[1], pose.indentation - indenter.height(from_lowest[0], from_lowest[1])};
}

Pose pose_at(Vector2 offset, Vector2 shift = {}, double indentation = depth) {
    return {offset, shift, indentation};
}

constexpr std::array<Vector2, 4> places{{{0, 0}, {2e-3, 0}, {-1e-3, 3e-3}, {.5e-3, -4e-3}}};

/// Slip of substrate points that were at `before`, in contact or not, and are at `after`.
Vector2 slip_of(const contact::Indenter& indenter, const Pose& from, const Pose& to,
                const Vector3& before, const Vector3& after, bool touched = true) {
    const std::vector<Vector3> start{before};
    const StepSlip slip(indenter, radius, {from, start, {touched ? 1. : 0.}}, to);
    return slip.at(0, ContactFrames(indenter, {after}, to.lowest_point()), after);
}

TEST(IndenterMotion, RollingIsARotationAboutTheAxis) {
    const Vector2 way{2e-3, -1.5e-3};
    const IndenterMotion motion(pose_at({1e-3, 0}), pose_at(Vector2{1e-3, 0} + way), radius);
    // A point on the axis moves with it, the lowest one up by R (1 - cos) and back from it by R
    // sin.
    const Vector3 axis = motion.after({1e-3, 0, depth - radius});
    EXPECT_NEAR(axis[0], 3e-3, rounding);
    EXPECT_NEAR(axis[1], -1.5e-3, rounding);
    EXPECT_NEAR(axis[2], depth - radius, rounding);
    const double angle = contact::norm(way) / radius;
    const Vector3 lowest = motion.after({1e-3, 0, depth});
    const double behind = radius * (angle - std::sin(angle));
    EXPECT_NEAR(lowest[0], 1e-3 + behind * .8, rounding);
    EXPECT_NEAR(lowest[1], -behind * .6, rounding);
    EXPECT_NEAR(lowest[2], depth - radius * (1 - std::cos(angle)), rounding);
}

TEST(IndenterMotion, ForthAndBackIsNothing) {
    const Pose here = pose_at({.2e-3, .1e-3}, {.3e-3, 0}, depth);
    const Pose there = pose_at({1.9e-3, -.7e-3}, {.4e-3, -.1e-3}, 1.1 * depth);
    const IndenterMotion forth(here, there, radius), back(there, here, radius);
    for (const Vector2& place : places) {
        const Vector3 x{place[0], place[1], 1e-4};
        const Vector3 again = back.after(forth.after(x));
        for (int a = 0; a < 3; ++a) EXPECT_NEAR(again[a], x[a], rounding);
        const Vector3 normal = back.turned(forth.turned({.6, 0, .8}));
        for (int a = 0; a < 3; ++a)
            EXPECT_NEAR(normal[a], (Vector3{.6, 0, .8})[a], rounding / radius);
    }
}

TEST(IndenterMotion, WithoutRadiusItDoesNotRotate) {
    const IndenterMotion motion(pose_at({0, 0}), pose_at({1e-3, 0}, {2e-4, 1e-4}, 2 * depth),
                                std::numeric_limits<double>::infinity());
    const Vector3 x = motion.after({1e-3, 2e-3, 1e-4});
    EXPECT_NEAR(x[0], 2.2e-3, rounding);
    EXPECT_NEAR(x[1], 2.1e-3, rounding);
    EXPECT_NEAR(x[2], 1e-4 + depth, rounding);
}

// What rides on the indenter does not slip, wherever it goes.
TEST(StepSlip, WhatMovesWithTheIndenterDoesNotSlip) {
    const Sphere sphere(radius);
    const Pose from = pose_at({.2e-3, 0}, {.1e-3, 0}),
               to = pose_at({1e-3, .5e-3}, {.3e-3, 1e-4}, 1.2 * depth);
    const IndenterMotion motion(from, to, radius);
    for (const Vector2& place : places) {
        const Vector3 x = on_surface(sphere, from, place);
        const Vector2 slip = slip_of(sphere, from, to, x, motion.after(x));
        EXPECT_NEAR(slip[0], 0, rounding);
        EXPECT_NEAR(slip[1], 0, rounding);
    }
}

// A paraboloid that has turned is another body: what was on it is beside it now, along the normal.
// Left over is the curvature's change from place to place: of third order in angle and slope.
TEST(StepSlip, APointOnARolledParaboloidSlipsByThirdOrder) {
    const Paraboloid paraboloid(radius);
    std::vector<double> slips;
    for (const double way : {2e-3, 1e-3}) {
        const Pose from = pose_at({0, 0}), to = pose_at({way, 0});
        const IndenterMotion motion(from, to, radius);
        const Vector3 x = on_surface(paraboloid, from, {way, way});
        Vector3 after = motion.after(x);
        // Into the surface as it is now.
        after[2] = to.indentation - paraboloid.height(after[0] - way, after[1]);
        const Vector2 slip = slip_of(paraboloid, from, to, x, after);
        slips.push_back(contact::norm(slip));
    }
    EXPECT_LT(slips[0], 1e-5 * 2e-3);  // of the way
    EXPECT_GT(std::log2(slips[0] / slips[1]), 3);
}

// Sliding by U along the surface: a point that stays lags by its component in the tangent plane.
TEST(StepSlip, SlidingByAShiftSlipsAlongTheTangent) {
    const Sphere sphere(radius);
    const double shift = 1e-7;  // so small that the normals before and after are the same
    for (const Vector2& place : places) {
        const Pose from = pose_at({0, 0}), to = pose_at({0, 0}, {shift, 0});
        const Vector3 x = on_surface(sphere, from, place);
        const Vector2 slip = slip_of(sphere, from, to, x, x);
        const ContactFrames frames(sphere, {x}, to.lowest_point());
        const Vector2 exact = frames.along_surface(0, {shift, 0, 0});
        // The surface bends by shift/R on the way, over a slope of at most .1.
        EXPECT_NEAR(slip[0], exact[0], 2 * shift * shift / radius);
        EXPECT_NEAR(slip[1], exact[1], 2 * shift * shift / radius);
    }
}

// A change of the indentation alone moves points along the flank.
TEST(StepSlip, SinkingSlipsAlongTheFlank) {
    const Sphere sphere(radius);
    const double sinking = 1e-7;
    const Vector3 x = on_surface(sphere, pose_at({0, 0}), {4e-3, 0});
    const Vector2 slip =
        slip_of(sphere, pose_at({0, 0}), pose_at({0, 0}, {}, depth + sinking), x, x);
    const double sine = 4e-3 / radius;  // of the slope's angle
    EXPECT_NEAR(slip[0] / sinking, -sine, 1e-4);
    EXPECT_NEAR(slip[1], 0, rounding);
}

// A point that was open slips from when the indenter touched it: half the way here.
TEST(StepSlip, CountsFromTouching) {
    const Sphere sphere(radius);
    const Pose from = pose_at({0, 0}, {}, 0), half = pose_at({0, 0}, {}, .5e-4),
               to = pose_at({0, 0}, {}, 1e-4);
    const Vector3 x = on_surface(sphere, half, {2e-3, 1e-3});
    const Vector2 of_open = slip_of(sphere, from, to, x, x, false);
    const Vector2 from_half = slip_of(sphere, half, to, x, x);
    const Vector2 of_all = slip_of(sphere, from, to, x, x);
    // The way's share is found to 40 bits.
    EXPECT_NEAR(of_open[0] / from_half[0], 1, 1e-9);
    EXPECT_NEAR(of_open[1] / from_half[1], 1, 1e-9);
    EXPECT_GT(contact::norm(of_all), 1.9 * contact::norm(of_open));
}

// Nothing is touched on the way: no slip but that of the end.
TEST(StepSlip, WhatStaysOpenDoesNotSlip) {
    const Sphere sphere(radius);
    const Vector3 x{6e-3, 0, 0};
    const Vector2 slip =
        slip_of(sphere, pose_at({0, 0}, {}, 0), pose_at({0, 0}, {}, 1e-4), x, x, false);
    EXPECT_NEAR(contact::norm(slip), 0, rounding);
}

// A material point that rides forth and back on the surface, as friction would move it, comes back
// without slip, on a paraboloid too, whatever the step: what the settled shift's standing rests on.
TEST(StepSlip, ForthAndBackCloses) {
    for (const bool is_sphere : {true, false}) {
        const Sphere sphere(radius);
        const Paraboloid paraboloid(radius);
        const contact::Indenter& indenter =
            is_sphere ? static_cast<const contact::Indenter&>(sphere) : paraboloid;
        const Pose here = pose_at({0, 0}, {1e-4, 0}), there = pose_at({1.5e-3, .4e-3}, {1e-4, 0});
        for (const Vector2& place : places) {
            const Vector3 start = on_surface(indenter, here, place);
            // Where it does not slip, in the plane: by Newton's iteration on the surface.
            const auto stuck = [&](const Pose& from, const Pose& to, const Vector3& x) {
                Vector2 at = Vector2{x[0], x[1]} - to.lowest_point();
                Vector3 now{};
                for (int k = 0; k < 50; ++k) {
                    now = on_surface(indenter, to, at);
                    at = at + slip_of(indenter, from, to, x, now);
                }
                return on_surface(indenter, to, at);
            };
            const Vector3 far = stuck(here, there, start), back = stuck(there, here, far);
            for (int a = 0; a < 3; ++a) EXPECT_NEAR(back[a], start[a], 10 * rounding) << is_sphere;
        }
    }
}

}  // namespace
}  // namespace tricontact::step_slip_test
