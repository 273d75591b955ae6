// What must not matter: the side, the units, the scales, the cells, the day of the week.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "contact/cells.h"
#include "tests/verification/properties/cases.h"

namespace tricontact::properties::properties_symmetry_test {
namespace {

using contact::Case;
using contact::norm;
using contact::Vector2;

// The boundary elements' tangential solver stops at 1e-7 of mu d, where another rounding makes
// another last iteration; errors of some ten steps add up. The spring bed is exact.
double tolerance_of(const std::string& model) {
    return model == "mdr" ? 1e-10 : 1e-5;
}

/// The shifts of both runs are equal, those of `b` times `sign`.
void check_equal(const std::string& model, const contact::History& a, const contact::History& b,
                 const Vector2& sign) {
    const auto u = shift_ratios(a), v = shift_ratios(b);
    RC_ASSERT(u.size() == v.size());
    double size = 1;  // ratcheting goes far
    for (const auto& value : u) size = std::max(size, norm(value));
    for (std::size_t k = 0; k < u.size(); ++k)
        for (int d = 0; d < 2; ++d)
            RC_ASSERT(std::abs(u[k][d] - sign[d] * v[k][d]) <= tolerance_of(model) * size);
    const double energy = a.friction_limit * a.scales.unit_shift;
    const double energy_b = b.friction_limit * b.scales.unit_shift;
    for (std::size_t k = 0; k < a.dissipation_per_period.size(); ++k)
        RC_ASSERT(std::abs(a.dissipation_per_period[k] / energy -
                           b.dissipation_per_period[k] / energy_b) <=
                  10 * tolerance_of(model) * size);
}

void mirrored_across(const std::string& model, const Case& c) {
    Case mirrored = c;
    mirrored.rolling->angle = -c.rolling->angle;
    check_equal(model, run(model, c), run(model, mirrored), {1, -1});
}

void turned_round(const std::string& model, const Case& c) {
    Case turned = c;
    turned.rolling->angle = c.rolling->angle + std::numbers::pi;
    *turned.load.tangential_ratio *= -1;
    check_equal(model, run(model, c), run(model, turned), {-1, -1});
}

RC_GTEST_PROP(PropertiesSymmetry, MirrorImageRollsAlikeBem, ()) {
    mirrored_across("bem", random_richer_case());
}
RC_GTEST_PROP(PropertiesSymmetry, MirrorImageRollsAlikeMdr, ()) {
    mirrored_across("mdr", random_richer_case());
}
RC_GTEST_PROP(PropertiesSymmetry, TurnedRoundGoesBackBem, ()) {
    turned_round("bem", random_richer_case());
}
RC_GTEST_PROP(PropertiesSymmetry, TurnedRoundGoesBackMdr, ()) {
    turned_round("mdr", random_richer_case());
}

/// The same case in other units of length and stress.
Case in_other_units(Case c, double length, double stress) {
    c.indenter.radius *= length;
    c.substrate.young *= stress;
    if (c.indenter.material) c.indenter.material->young *= stress;
    *c.load.normal_force *= stress * length * length;
    return c;
}

void unitless(const std::string& model) {
    Case c = random_richer_case();
    c.contact.coupling = false;  // whose turns end at another digit in other units
    const double length = drawn_scale(1e-6, 1e6), stress = drawn_scale(1e-6, 1e6);
    const auto a = run(model, c), b = run(model, in_other_units(c, length, stress));
    check_equal(model, a, b, {1, 1});
    RC_ASSERT(std::abs(b.scales.unit_shift / a.scales.unit_shift / length - 1) < 1e-7);
    RC_ASSERT(std::abs(b.scales.contact_radius / a.scales.contact_radius / length - 1) < 1e-6);
    RC_ASSERT(std::abs(b.scales.peak_pressure / a.scales.peak_pressure / stress - 1) < 1e-7);
    // An average over the contact of the least pressures, each right to 1e-7 of the peak: where the
    // path leaves next to nothing, or nothing, of the contact unmoved, the ratio is as small.
    RC_ASSERT(std::abs(b.limit_tangential_ratio - a.limit_tangential_ratio) < 1e-6);
    RC_ASSERT(a.verdict.state == b.verdict.state);
}
RC_GTEST_PROP(PropertiesScaling, UnitsDoNotMatterBem, ()) {
    unitless("bem");
}
RC_GTEST_PROP(PropertiesScaling, UnitsDoNotMatterMdr, ()) {
    unitless("mdr");
}

// A paraboloid under constant loads: u depends on w, f_T, nu (and the angle) alone.
void scaleless(const std::string& model) {
    Case c = random_case();
    c.contact.coupling = false;  // else the friction coefficient matters, over Dundurs' beta
    Case other = c;
    draw_scales(other);
    if (model == "mdr") other.substrate.poisson = drawn(0, .5);  // not even nu
    check_equal(model, run(model, c), run(model, other), {1, 1});
}
RC_GTEST_PROP(PropertiesScaling, OnlyRatiosMatterBem, ()) {
    scaleless("bem");
}
RC_GTEST_PROP(PropertiesScaling, OnlyRatiosMatterMdr, ()) {
    scaleless("mdr");
}

// ... and it does depend on them: the properties above could not fail otherwise.
TEST(PropertiesScaling, RatiosDoMatter) {
    Case c;
    c.indenter.radius = .04;
    c.substrate = {5.2e6, .5};
    c.friction.coefficient = .57;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = .4;
    c.rolling.emplace();
    c.rolling->amplitude_ratio = .3;
    c.of<contact::Cells>().per_radius = 8;
    auto last = [](const Case& one) { return shift_ratios(run("bem", one)).back()[0]; };
    const double reference = last(c);
    Case f = c, w = c, nu = c;
    f.load.tangential_ratio = .42;
    w.rolling->amplitude_ratio = .33;
    nu.substrate.poisson = .3;
    for (const Case& one : {f, w, nu}) EXPECT_GT(std::abs(last(one) - reference), 1e-3);
}

RC_GTEST_PROP(PropertiesRepetition, SameInputSameBits, ()) {
    const Case c = random_richer_case();
    for (const char* model : {"bem", "mdr"}) {
        const auto a = run(model, c), b = run(model, c);
        RC_ASSERT(a.steps.size() == b.steps.size());
        for (std::size_t k = 0; k < a.steps.size(); ++k) {
            RC_ASSERT(a.steps[k].shift == b.steps[k].shift);
            RC_ASSERT(a.steps[k].dissipation == b.steps[k].dissipation);
            RC_ASSERT(a.steps[k].indentation == b.steps[k].indentation);
        }
        const auto &s = a.snapshots.back().surface, &t = b.snapshots.back().surface;
        RC_ASSERT(s.tangential_traction_x == t.tangential_traction_x);
        RC_ASSERT(s.slip_x == t.slip_x);
    }
}

/// Shift after two periods over U_max, the whole path moved by parts of a cell.
double shift_moved_by(const Case& c, double x, double y) {
    const auto model = bem::make_model(c, 1);
    const double h = contact::cell_side(c);
    const Vector2 move = {x * h, y * h};
    double shift = 0;
    auto take = [&](contact::LoadStep step) {
        for (int d = 0; d < 2; ++d) step.offset[d] += move[d];
        shift = model->advance(step).shift[0];
    };
    take(contact::press_step(c));
    const auto scales = model->scales();
    const auto path = contact::make_load_path(c, scales.normal_force, scales.contact_radius);
    for (const auto& step : path.loading) take(step);
    for (int n = 0; n < 2; ++n)
        for (const auto& step : path.period) take(step);
    return shift / contact::half_space_scales(c).unit_shift;
}

RC_GTEST_PROP(PropertiesGrid, WhereTheCellsLieHardlyMatters, ()) {
    Case c = random_case();
    c.load.tangential_ratio = drawn(.05, .8);
    const int cells = *rc::gen::element(8, 12, 16);
    c.of<contact::Cells>().per_radius = cells;
    const double here = shift_moved_by(c, 0, 0);
    const double there = shift_moved_by(c, drawn(-.5, .5), drawn(-.5, .5));
    // Second order in the cell, whatever its size: what stepped edges do to a pressure that
    // vanishes there. Ratcheting adds it up per step. The factor of (h/a)^2 was 0.1 in the mean and
    // 0.8 at most of 60 random contacts, alike for 8 and 20 cells, and 1.2 in the worst one known.
    const double h = 1. / cells;
    RC_LOG() << cells << ' ' << here << ' ' << there << '\n';
    RC_ASSERT(std::abs(there - here) <= 2 * h * h * std::max(1., here));
    RC_ASSERT(there != here);  // it has been moved
}

}  // namespace
}  // namespace tricontact::properties::properties_symmetry_test
