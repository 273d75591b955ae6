#include "mdr/relaxing_bed.h"

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
#include "mdr/model.h"
#include "mdr/spring_bed.h"
#include "tests/verification/mdr/roller.h"

namespace tricontact::relaxing_bed_test {
namespace {

using contact::LoadStep;
using contact::NormalControl;
using contact::Relaxation;
using contact::TangentialControl;
using mdr::RelaxingBed;
using mdr::SpringBed;

constexpr double forever = std::numeric_limits<double>::infinity();

// a, E*, G*, mu; a paraboloid of radius a: F = 4/3 E* a^2 at d = a.
struct Units {
    double length = 4.5e-3, modulus = 7e6, shear_modulus = 5e6, friction = .57;
    double force() const { return 4. / 3 * modulus * length * length; }
    double shift() const { return friction * modulus / shear_modulus * length; }
};

mdr::BedData bed_data(const Units& units, const std::optional<Relaxation>& relaxation,
                      int springs = 400, double half_length = 2) {
    mdr::BedData data;
    data.profile = std::make_unique<mdr::PowerLawProfile>(1 / (2 * units.length), 2);
    data.effective_modulus = units.modulus;
    data.effective_shear_modulus = units.shear_modulus;
    data.friction = contact::Friction{units.friction}.law();
    data.n_springs = springs;
    data.half_length = half_length * units.length;
    data.relaxation = relaxation;
    return data;
}

const Relaxation solid{{{.8, 2.}, {.3, .1}}, {}};

// Duration, offset, normal and tangential force in units of s, a, F and mu F.
LoadStep step(const Units& units, double duration, double x, double normal, double tangential) {
    LoadStep s;
    s.duration = duration;
    s.offset = {x * units.length, 0};
    s.normal = {NormalControl::Kind::force, normal * units.force()};
    s.tangential[0] = {TangentialControl::Kind::force, tangential * units.friction * units.force()};
    return s;
}

LoadStep dip(const Units& units, double duration, double depth) {
    LoadStep s;
    s.duration = duration;
    s.normal = {NormalControl::Kind::indentation, depth * units.length};
    s.tangential[0].kind = TangentialControl::Kind::shift;
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

TEST(MdrRelaxingBed, RefusesWhatItCannotDo) {
    const Units units{1, 1, 1, .5};
    EXPECT_EQ(message([&] { RelaxingBed bed(bed_data(units, {})); }),
              "mdr: a relaxing bed needs a relaxation");
    EXPECT_NE(message([&] {
                  RelaxingBed bed(bed_data(units, Relaxation{{{-.1, 1}}, {}}));
              }).find("moduli of branches must be positive"),
              std::string::npos);
    RelaxingBed bed(bed_data(units, solid));
    EXPECT_EQ(message([&] { bed.advance(step(units, -1, 0, 1, 0)); }),
              "mdr: a step of -1 s; time must not go backwards");
    EXPECT_EQ(message([&] { bed.advance(step(units, 1, 0, 1, 1.5)); }),
              "mdr: the tangential force 1 N reaches the friction limit mu F_N = 0.666667 N: the "
              "indenter slides; lower tangential_force or tangential_ratio");
    EXPECT_EQ(message([&] { bed.advance(dip(units, 1, -.1)); }),
              "mdr: the indentation = -0.1 must be positive: contact is lost");
}

TEST(MdrRelaxingBed, ModelRefusesWhatIsNoCommonFactor) {
    contact::Case c = mdr_test::sphere_rig(.24, .5, 1000, 6);
    c.relaxation = solid;
    EXPECT_EQ(message([&] { mdr::make_model(c); }),
              "no error");  // steel has 2e-5 of the compliance
    contact::Case bulk = c;
    bulk.relaxation->bulk = Relaxation::Bulk::elastic;
    EXPECT_EQ(message([&] { mdr::make_model(bulk); }), "no error");  // nu = 1/2
    bulk.substrate.poisson = .4;
    EXPECT_EQ(message([&] { mdr::make_model(bulk); }),
              "substrate.relaxation: mdr has one relaxation function, which an elastic bulk "
              "below Poisson's ratio 1/2 does not leave; take another model, or bulk = "
              "\"proportional\" if the bulk relaxes alike");
    c.indenter.material = contact::Material{50e6, .5};
    EXPECT_EQ(message([&] { mdr::make_model(c); }),
              "substrate.relaxation: 0.0942 of the compliance is the indenter's, which does not "
              "relax, but mdr lets all of it relax; take another model, or omit young and poisson "
              "of the indenter to take it as rigid");
}

TEST(MdrRelaxingBed, HeldIndentationRelaxesLikeTheModulus) {
    const Units units;
    RelaxingBed bed(bed_data(units, solid));
    SpringBed elastic(bed_data(units, {}));
    const double relaxed = elastic.advance(dip(units, 0, .8)).normal_force;
    EXPECT_NEAR(bed.advance(dip(units, 0, .8)).normal_force / relaxed, 2.1, 1e-13);
    double time = 0;
    for (const double duration : {.01, .3, 2., 9.}) {
        time += duration;
        const double exact = 1 + .8 * std::exp(-time / 2) + .3 * std::exp(-time / .1);
        const auto r = bed.advance(dip(units, duration, .8));
        EXPECT_NEAR(r.normal_force / relaxed, exact, 1e-13) << time;
        EXPECT_EQ(r.contact_area, elastic.advance(dip(units, duration, .8)).contact_area);
    }
    const auto r = bed.advance(dip(units, forever, .8));
    EXPECT_NEAR(r.normal_force / relaxed, 1, 1e-13);
    // Nothing but the relaxed springs holds energy any more: that of the elastic bed.
    EXPECT_NEAR(r.stored_energy / elastic.advance(dip(units, 0, .8)).stored_energy, 1, 1e-13);
}

struct Walk {
    std::vector<std::array<double, 4>> steps;  // duration, x, normal, tangential
};

Walk random_walk(bool any_duration = true) {
    Walk walk;
    const int n = *rc::gen::inRange(2, 25);
    for (int k = 0; k < n; ++k) {
        const double normal = *rc::gen::inRange(300, 1500) * 1e-3;
        const int kind = *rc::gen::inRange(0, 6);
        double duration = *rc::gen::inRange(1, 400) * 1e-2;
        if (any_duration && kind == 0) duration = 0;
        if (any_duration && kind == 1) duration = forever;
        walk.steps.push_back({duration, *rc::gen::inRange(-800, 801) * 1e-3, normal,
                              *rc::gen::inRange(-999, 1000) * 1e-3 * normal});
    }
    return walk;
}

template <class Bed>
std::vector<contact::StepRecord> take(Bed& bed, const Walk& walk, const Units& units,
                                      double sign = 1) {
    std::vector<contact::StepRecord> records;
    for (const auto& [duration, x, normal, tangential] : walk.steps)
        records.push_back(bed.advance(step(units, duration, sign * x, normal, sign * tangential)));
    for (const auto& check : bed.audit().checks())
        if (!check.passed()) RC_FAIL(check.name + " " + std::to_string(check.worst));
    return records;
}

void expect_same(const std::vector<contact::StepRecord>& one,
                 const std::vector<contact::StepRecord>& other, const Units& units,
                 double tolerance) {
    const double work = units.force() * units.shift();
    for (std::size_t k = 0; k < one.size(); ++k) {
        RC_ASSERT(std::abs(one[k].indentation - other[k].indentation) < tolerance * units.length);
        RC_ASSERT(std::abs(one[k].shift[0] - other[k].shift[0]) < tolerance * units.shift());
        RC_ASSERT(std::abs(one[k].dissipation - other[k].dissipation) < tolerance * work);
        RC_ASSERT(std::abs(one[k].stored_energy - other[k].stored_energy) < tolerance * work);
        RC_ASSERT(std::abs(one[k].material_dissipation) < tolerance * work);
    }
}

// G2 -> 0, eta -> 0: the relaxed elastic bed. eta -> infinity: the stiff one. Rounding near gross
// slip is magnified: 1e-8.
RC_GTEST_PROP(MdrRelaxingBed, ElasticLimits, ()) {
    const Walk walk = random_walk(false);
    const Units units;
    SpringBed elastic(bed_data(units, {}, 300, 2.1));
    const auto expected = take(elastic, walk, units);
    for (const Relaxation& relaxation :
         {Relaxation{{{1e-13, 1.}}, {}}, Relaxation{{{.7, 1e-12}}, {}}}) {
        RelaxingBed bed(bed_data(units, relaxation, 300, 2.1));
        expect_same(take(bed, walk, units), expected, units, 1e-8);
    }
    Units stiff = units;
    stiff.modulus *= 1.7;
    stiff.shear_modulus *= 1.7;
    Walk lighter = walk;  // the same forces on stiffer springs
    for (auto& s : lighter.steps)
        for (int k = 2; k < 4; ++k) s[k] /= 1.7;
    SpringBed stiff_bed(bed_data(stiff, {}, 300, 2.1));
    RelaxingBed slow(bed_data(units, Relaxation{{{.7, 1e13}}, {}}, 300, 2.1));
    expect_same(take(slow, walk, units), take(stiff_bed, lighter, stiff), units, 1e-8);
}

RC_GTEST_PROP(MdrRelaxingBed, ForeverIsTheRelaxedBed, ()) {
    Walk walk = random_walk();
    const Units units;
    for (auto& s : walk.steps) s[0] = forever;
    SpringBed elastic(bed_data(units, {}, 300, 2.1));
    RelaxingBed bed(bed_data(units, solid, 300, 2.1));
    expect_same(take(bed, walk, units), take(elastic, walk, units), units, 1e-9);
}

RC_GTEST_PROP(MdrRelaxingBed, EveryWalkPassesItsAudit, ()) {
    const Units units;
    RelaxingBed bed(bed_data(units, solid, 300, 2.1));
    for (const auto& r : take(bed, random_walk(), units)) {
        RC_ASSERT(r.force_residual <= 1e-12);
        RC_ASSERT(r.dissipation >= 0);
        RC_ASSERT(r.material_dissipation >= -1e-15 * units.force() * units.length);
        RC_ASSERT(r.stick_area + r.slip_area <= r.contact_area * (1 + 1e-12));
    }
}

RC_GTEST_PROP(MdrRelaxingBed, MirrorSymmetryAndRelease, ()) {
    const Walk walk = random_walk();
    const Units units;
    RelaxingBed bed(bed_data(units, solid, 300, 2.1));
    const auto straight = take(bed, walk, units);
    bed.release();
    const auto mirrored = take(bed, walk, units, -1);
    for (std::size_t k = 0; k < straight.size(); ++k) {
        RC_ASSERT(std::abs(straight[k].shift[0] + mirrored[k].shift[0]) < 1e-9 * units.shift());
        RC_ASSERT(std::abs(straight[k].indentation - mirrored[k].indentation) <
                  1e-11 * units.length);
        RC_ASSERT(std::abs(straight[k].material_dissipation - mirrored[k].material_dissipation) <
                  1e-9 * units.force() * units.shift());
    }
}

TEST(MdrRelaxingBed, AShortBedGrows) {
    const Units units;
    RelaxingBed longer(bed_data(units, solid, 400, 2)), shorter(bed_data(units, solid, 60, .3));
    for (const auto& [x, f] : std::vector<std::pair<double, double>>{
             {0, 0}, {0, .4}, {.5, .4}, {-.9, .4}, {-.2, -.1}, {.7, .3}}) {
        const auto expected = longer.advance(step(units, .5, x, 1, f));
        const auto found = shorter.advance(step(units, .5, x, 1, f));
        EXPECT_NEAR(found.shift[0] / units.shift(), expected.shift[0] / units.shift(), 1e-12);
        EXPECT_NEAR(found.material_dissipation / expected.material_dissipation, 1, 1e-9);
    }
    EXPECT_GT(shorter.size(), 150);
    EXPECT_EQ(longer.size(), 400);
    EXPECT_TRUE(shorter.audit().passed());
}

// Withdrawn faster than the surface relaxes, the indenter loses contact; met again soon, the dent
// resists less than before; after long it is forgotten.
TEST(MdrRelaxingBed, DentIsMetAgain) {
    const Units units;
    RelaxingBed bed(bed_data(units, Relaxation{{{4., 1.}}, {}}));
    for (int k = 1; k <= 20; ++k) bed.advance(dip(units, .1, .05 * k));
    const auto gone = bed.advance(dip(units, 1e-3, .3));
    EXPECT_EQ(gone.normal_force, 0);
    EXPECT_EQ(gone.contact_area, 0);
    EXPECT_GT(gone.stored_energy, 0);
    LoadStep pulled = dip(units, 1e-3, .3);
    pulled.tangential[0] = {TangentialControl::Kind::force, 0};
    EXPECT_EQ(bed.advance(pulled).shift[0], 0);

    const double soon = bed.advance(dip(units, 1e-3, .7)).normal_force;
    bed.advance(dip(units, 1e-3, .01));
    bed.advance(dip(units, forever, .01));
    const double late = bed.advance(dip(units, 1e-3, .7)).normal_force;
    RelaxingBed fresh(bed_data(units, Relaxation{{{4., 1.}}, {}}));
    fresh.advance(dip(units, forever, .01));
    const double first = fresh.advance(dip(units, 1e-3, .7)).normal_force;
    EXPECT_GT(soon, 0);
    EXPECT_LT(soon, .6 * first);
    EXPECT_NEAR(late / first, 1, 1e-12);
    EXPECT_TRUE(bed.audit().passed());
}

TEST(MdrRelaxingBed, PressingBeyondTheRimIsRefused) {
    contact::Case c = mdr_test::sphere_rig(.24, .5, 1000, 6);
    c.indenter.shape = contact::Case::Shape::sphere;
    c.load.normal_force = 1500;
    c.relaxation = solid;
    const auto model = mdr::make_model(c);
    LoadStep s;
    s.normal = {NormalControl::Kind::force, 1e5};
    EXPECT_NE(message([&] { model->advance(s); }).find("reaches the rim"), std::string::npos);
}

TEST(MdrRelaxingBed, WithoutFrictionNothingIsHeld) {
    const Units units;
    RelaxingBed bed(bed_data(units, solid));
    bed.advance(step(units, 1, 0, 1, .5));
    LoadStep free = step(units, 1, 0, 1, 0);
    free.friction = false;
    const auto r = bed.advance(free);
    EXPECT_EQ(r.tangential_force[0], 0);
    EXPECT_EQ(r.dissipation, 0);
    const auto surface = bed.surface();
    for (const double load : surface.tangential_line_load) EXPECT_EQ(load, 0);
    EXPECT_GT(*std::max_element(surface.displacement_x.begin(), surface.displacement_x.end()), 0);
    EXPECT_TRUE(bed.audit().passed());
}

TEST(MdrRelaxingBed, LimitCountsFromItsStart) {
    const Units units;
    RelaxingBed bed(bed_data(units, solid));
    bed.advance(step(units, forever, 0, 1, 0));
    bed.start_limit();
    EXPECT_NEAR(bed.limit_tangential_ratio(), 1, 1e-13);
    bed.advance(step(units, forever, .3, 1, 0));
    // Overlap of two parabolas .3 apart: (1 - .15)^2 (2 + .15)/2; dx = .01: dx^2
    EXPECT_NEAR(bed.limit_tangential_ratio(), .85 * .85 * 2.15 / 2, 1e-4);
}

TEST(MdrRelaxingBed, ShowsWhatTheElasticBedShows) {
    const Units units;
    RelaxingBed bed(bed_data(units, solid, 499, 1.5));
    SpringBed elastic(bed_data(units, {}, 499, 1.5));
    for (const double f : {0., .6}) {
        bed.advance(step(units, forever, .1, 1, f));
        elastic.advance(step(units, forever, .1, 1, f));
    }
    const auto scales = bed.scales(), expected = elastic.scales();
    EXPECT_NEAR(scales.contact_radius / expected.contact_radius, 1, 1e-5);  // dx^2 = 3.6e-5
    EXPECT_NEAR(scales.peak_pressure / expected.peak_pressure, 1, 1e-5);
    EXPECT_NEAR(scales.indentation / expected.indentation, 1, 1e-13);
    EXPECT_NEAR(scales.unit_shift / expected.unit_shift, 1, 1e-13);
    const auto s = bed.surface(), e = elastic.surface();
    ASSERT_EQ(s.size(), e.size());
    for (std::size_t i = 0; i < s.size(); ++i) {
        EXPECT_EQ(s.contact_state[i], e.contact_state[i]) << i;
        EXPECT_NEAR(s.normal_line_load[i], e.normal_line_load[i],
                    1e-9 * units.modulus * units.length);
        EXPECT_NEAR(s.slip_x[i], e.slip_x[i], 1e-10 * units.shift());
        EXPECT_NEAR(s.gap[i], e.gap[i], 1e-12 * units.length);
        // Pictures transform the profile itself here and springs there: dx over the depth at the
        // rim
        EXPECT_NEAR(s.normal_traction[i] / scales.peak_pressure,
                    e.normal_traction[i] / scales.peak_pressure, 5e-3);
        EXPECT_NEAR(s.tangential_traction_x[i] / scales.peak_pressure,
                    e.tangential_traction_x[i] / scales.peak_pressure, 2e-2);
    }
}

}  // namespace
}  // namespace tricontact::relaxing_bed_test
