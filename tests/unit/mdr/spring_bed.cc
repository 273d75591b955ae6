#include "mdr/spring_bed.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "contact/base/error.h"
#include "contact/friction/friction.h"
#include "mdr/plane_profile.h"

namespace tricontact::spring_bed_test {
namespace {

using contact::LoadStep;
using contact::NormalControl;
using contact::TangentialControl;
using mdr::SpringBed;

// Scales of a bed; the paraboloid of radius R = length.
struct Units {
    double length = 4.5e-3, modulus = 7e6, shear_modulus = 5e6, friction = .57;
    double force() const { return 4. / 3 * modulus * length * length; }  // a = d = length
    double shift() const { return friction * modulus / shear_modulus * length; }
};

mdr::BedData bed_data(const Units& units, int springs = 400, double half_length = 2) {
    mdr::BedData data;
    data.profile = std::make_unique<mdr::PowerLawProfile>(1 / (2 * units.length), 2);
    data.effective_modulus = units.modulus;
    data.effective_shear_modulus = units.shear_modulus;
    data.friction = contact::Friction{units.friction}.law();
    data.n_springs = springs;
    data.half_length = half_length * units.length;
    return data;
}

// Offset x, normal force and tangential force in units of a, F_N and mu F_N.
LoadStep step(const Units& units, double x, double normal, double tangential) {
    LoadStep s;
    s.offset = {x * units.length, 0};
    s.normal = {NormalControl::Kind::force, normal * units.force()};
    s.tangential[0] = {TangentialControl::Kind::force, tangential * units.friction * units.force()};
    return s;
}

std::string message(const std::function<void()>& action) {
    try {
        action();
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "no error";
}

// Rounding of a plain sum grows with the number of terms: of these it fails the audit's 1e-12,
// which holds for whatever number.
TEST(MdrSpringBed, BalancesAreThoseOfFewSpringsWithAMillion) {
    const Units units;
    SpringBed bed(bed_data(units, 1'000'000));
    bed.advance(step(units, 0, 1, 0));
    for (const double x : {0., .3, .6, .3, 0., -.6, 0.}) bed.advance(step(units, x, 1, .56));
    bed.advance(step(units, 0, .1, .099));  // what was stored before is many times more than now
    EXPECT_TRUE(bed.audit().passed());
    for (const auto& check : bed.audit().checks()) EXPECT_LE(check.worst, 1e-13) << check.name;
}

TEST(MdrSpringBed, RefusesDataOutOfRange) {
    auto with = [](auto change) {
        mdr::BedData data = bed_data(Units{});
        change(data);
        return message([&] { SpringBed bed(std::move(data)); });
    };
    EXPECT_EQ(with([](auto& d) { d.profile.reset(); }), "mdr: no indenter profile");
    EXPECT_EQ(with([](auto& d) { d.effective_modulus = 0; }),
              "mdr: effective modulus E* = 0 must be positive");
    EXPECT_EQ(with([](auto& d) { d.effective_shear_modulus = std::nan(""); }),
              "mdr: effective shear modulus G* = nan must be positive");
    EXPECT_EQ(with([](auto& d) { d.friction.reset(); }), "mdr: no law of friction");
    EXPECT_EQ(with([](auto& d) { d.friction = contact::Friction{-.5}.law(); }),
              "mdr: friction coefficient = -0.5 must be positive");
    EXPECT_EQ(with([](auto& d) { d.half_length = std::numeric_limits<double>::infinity(); }),
              "mdr: half length of the bed = inf must be positive");
    EXPECT_EQ(with([](auto& d) { d.n_springs = 9; }),
              "mdr: 9 springs are too few, give at least 10 (mdr.springs)");
}

TEST(MdrSpringBed, RefusesStepsThatItCannotTake) {
    const Units units{1, 1, 1, .5};
    auto with = [&](auto change) {
        SpringBed bed(bed_data(units));
        LoadStep s = step(units, 0, 1, .5);
        change(s);
        return message([&] { bed.advance(s); });
    };
    EXPECT_EQ(with([](LoadStep& s) { s.normal.value = 0; }),
              "mdr: the normal force = 0 must be positive: contact is lost");
    EXPECT_EQ(with([](LoadStep& s) {
                  s.normal = {NormalControl::Kind::indentation, -1e-3};
              }),
              "mdr: the indentation = -0.001 must be positive: contact is lost");
    EXPECT_EQ(with([](LoadStep& s) { s.tangential[1].value = 1e-3; }),
              "mdr: a tangential force or shift across the load (y) is not possible in a spring "
              "bed, which has one direction; set it to zero");
    EXPECT_EQ(with([](LoadStep& s) {
                  s.offset = {.1, .1};
              }),
              "mdr: the rolling offset (0.1, 0.1) m lies off the line of rolling, along which "
              "alone a spring bed extends");
    EXPECT_EQ(with([](LoadStep& s) { s.tangential[0].value = .7; }),
              "mdr: the tangential force 0.7 N reaches the friction limit mu F_N = 0.666667 N: the "
              "indenter slides; lower tangential_force or tangential_ratio");
}

TEST(MdrSpringBed, SaysWhenTheRimIsReached) {
    mdr::BedData data = bed_data(Units{1, 1, 1, .5});
    data.profile = std::make_unique<mdr::TabulatedProfile>(contact::Sphere(1), .3);
    SpringBed bed(std::move(data));
    LoadStep s;
    s.normal.value = 1;
    EXPECT_NE(message([&] { bed.advance(s); }).find("reaches the rim of its profile at 0.3 m"),
              std::string::npos);
}

TEST(MdrSpringBed, AShortBedGrows) {
    const Units units;
    // same spacing: 2/400 and .3/60
    SpringBed longer(bed_data(units, 400, 2)), shorter(bed_data(units, 60, .3));
    for (const auto& [x, f] : std::vector<std::pair<double, double>>{
             {0, 0}, {0, .4}, {.5, .4}, {-.9, .4}, {-.2, -.1}, {.7, .3}}) {
        const auto expected = longer.advance(step(units, x, 1, f));
        const auto found = shorter.advance(step(units, x, 1, f));
        EXPECT_NEAR(found.shift[0] / units.shift(), expected.shift[0] / units.shift(), 1e-12);
        EXPECT_NEAR(found.dissipation, expected.dissipation, 1e-12 * units.force() * units.shift());
        EXPECT_NEAR(found.contact_area / expected.contact_area, 1, 1e-12);
    }
    EXPECT_GT(shorter.normal().size(), 200);
    EXPECT_EQ(longer.normal().size(), 400);
    EXPECT_TRUE(shorter.audit().passed());
}

TEST(MdrSpringBed, ForceAndShiftControlAgree) {
    const Units units;
    SpringBed forced(bed_data(units)), shifted(bed_data(units));
    for (const auto& [x, f] :
         std::vector<std::pair<double, double>>{{0, 0}, {0, .4}, {.3, .4}, {-.3, .2}, {.1, -.5}}) {
        LoadStep s = step(units, x, 1, f);
        const auto by_force = forced.advance(s);
        s.normal = {NormalControl::Kind::indentation, by_force.indentation};
        s.tangential[0] = {TangentialControl::Kind::shift, by_force.shift[0]};
        const auto by_shift = shifted.advance(s);
        EXPECT_NEAR(by_shift.tangential_force[0] / (units.friction * units.force()), f, 1e-12);
        EXPECT_NEAR(by_shift.normal_force / units.force(), 1, 1e-12);
    }
    // Under shift control it may slide as a whole.
    LoadStep slide = step(units, 0, 1, 0);
    slide.tangential[0] = {TangentialControl::Kind::shift, 9 * units.shift()};
    const auto r = shifted.advance(slide);
    EXPECT_NEAR(r.tangential_force[0] / (units.friction * units.force()), 1, 1e-12);
    EXPECT_EQ(r.stick_area, 0);
}

TEST(MdrSpringBed, LimitCountsFromItsStart) {
    const Units units;
    SpringBed bed(bed_data(units));
    bed.advance(step(units, -.5, 1, 0));
    bed.advance(step(units, 0, 1, 0));
    bed.start_limit();
    EXPECT_NEAR(bed.limit_tangential_ratio(), 1, 1e-13);
    bed.advance(step(units, .3, 1, 0));
    // Overlap of two parabolas .3 apart: (1 - .15)^2 (2 + .15)/2
    EXPECT_NEAR(bed.limit_tangential_ratio(), .85 * .85 * 2.15 / 2, 1e-4);  // dx = .01: dx^2
    bed.advance(step(units, 0, 1, 0));
    EXPECT_NEAR(bed.limit_tangential_ratio(), .85 * .85 * 2.15 / 2, 1e-4);
}

TEST(MdrSpringBed, SurfaceShowsTheSprings) {
    const Units units;
    SpringBed bed(bed_data(units, 499, 1.5));
    bed.advance(step(units, .1, 1, 0));
    const auto r = bed.advance(step(units, .1, 1, .6));
    const contact::Surface s = bed.surface();
    ASSERT_EQ(s.n_x, 499);
    EXPECT_EQ(s.offset[0], .1 * units.length);
    double normal = 0, tangential = 0;
    int n_stick = 0;
    for (int i = 0; i < s.n_x; ++i) {
        normal += s.normal_line_load[i] * s.spacing[0];
        tangential += s.tangential_line_load[i] * s.spacing[0];
        n_stick += s.contact_state[i] == contact::ContactState::stick;
        const bool open = s.contact_state[i] == contact::ContactState::open;
        EXPECT_EQ(open, s.normal_line_load[i] == 0);
        EXPECT_EQ(open, s.gap[i] > 0);
        EXPECT_EQ(s.contact_state[i] == contact::ContactState::slip, s.slip_x[i] > 0);
        EXPECT_EQ(s.displacement_x[i], bed.deflection(i));
    }
    EXPECT_NEAR(normal / r.normal_force, 1, 1e-12);
    EXPECT_NEAR(tangential / r.tangential_force[0], 1, 1e-12);
    EXPECT_NEAR(std::sqrt(r.stick_area / std::acos(-1.)) * 2 / s.spacing[0], n_stick, 1e-9);
}

TEST(MdrSpringBed, LeavingTheContactReleasesTheSpring) {
    const Units units;
    SpringBed bed(bed_data(units));
    bed.advance(step(units, 0, 1, .5));
    bed.advance(step(units, .8, 1, .5));
    for (int i = 0; i < bed.normal().size(); ++i)
        if (std::abs(bed.normal().spring_position(i) / units.length - .8) > 1.01) {
            EXPECT_EQ(bed.deflection(i), 0) << i;
        }
    EXPECT_TRUE(bed.audit().passed());
}

// A random walk of the contact under random loads, in the units of the bed.
struct Walk {
    std::vector<std::array<double, 3>> steps;
};

Walk random_walk() {
    Walk walk;
    const int n = *rc::gen::inRange(2, 30);
    for (int k = 0; k < n; ++k) {
        const double normal = *rc::gen::inRange(300, 1500) * 1e-3;
        walk.steps.push_back({*rc::gen::inRange(-800, 801) * 1e-3, normal,
                              *rc::gen::inRange(-999, 1000) * 1e-3 * normal});
    }
    return walk;
}

std::vector<contact::StepRecord> take(const Walk& walk, const Units& units, double sign = 1) {
    SpringBed bed(bed_data(units, 300, 2.1));
    std::vector<contact::StepRecord> records;
    for (const auto& [x, normal, tangential] : walk.steps)
        records.push_back(bed.advance(step(units, sign * x, normal, sign * tangential)));
    for (const auto& check : bed.audit().checks()) RC_ASSERT(check.passed());
    return records;
}

RC_GTEST_PROP(MdrSpringBed, EveryWalkPassesItsAudit, ()) {
    const Units units;
    for (const auto& r : take(random_walk(), units)) {
        RC_ASSERT(r.force_residual <= 1e-12);
        RC_ASSERT(r.dissipation >= 0);
        RC_ASSERT(r.stick_area + r.slip_area <= r.contact_area * (1 + 1e-12));
    }
}

RC_GTEST_PROP(MdrSpringBed, MirrorSymmetry, ()) {
    const Walk walk = random_walk();
    const Units units;
    const auto straight = take(walk, units), mirrored = take(walk, units, -1);
    for (std::size_t k = 0; k < straight.size(); ++k) {
        // Springs are summed from the other end: rounding, which near gross slip is magnified.
        RC_ASSERT(std::abs(straight[k].shift[0] + mirrored[k].shift[0]) < 1e-9 * units.shift());
        RC_ASSERT(std::abs(straight[k].dissipation - mirrored[k].dissipation) <
                  1e-9 * units.force() * units.shift());
    }
}

RC_GTEST_PROP(MdrSpringBed, UnitsAndScalesDropOut, ()) {
    const Walk walk = random_walk();
    const Units one{1, 1, 1, 1};
    const Units other{*rc::gen::inRange(1, 1000) * 1e-5, *rc::gen::inRange(1, 1000) * 1e5,
                      *rc::gen::inRange(1, 1000) * 1e5, *rc::gen::inRange(1, 200) * 1e-2};
    const auto plain = take(walk, one), scaled = take(walk, other);
    for (std::size_t k = 0; k < plain.size(); ++k) {
        RC_ASSERT(std::abs(plain[k].shift[0] - scaled[k].shift[0] / other.shift()) < 1e-9);
        RC_ASSERT(std::abs(plain[k].indentation - scaled[k].indentation / other.length) < 1e-12);
        auto work_unit = [](const Units& u) { return u.friction * u.force() * u.shift(); };
        RC_ASSERT(std::abs(plain[k].dissipation / work_unit(one) -
                           scaled[k].dissipation / work_unit(other)) < 1e-9);
    }
}

}  // namespace
}  // namespace tricontact::spring_bed_test
