#include "comparisons/run/contact_film.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

#include "bem/model.h"
#include "contact/cells.h"
#include "contact/run.h"
#include "mdr/model.h"
#include "mdr/settings.h"
#include "report/player_json.h"

namespace tricontact::comparisons {
namespace {

using contact::ContactState;

contact::Case rolling_case() {
    contact::Case c;
    c.models = {"bem"};
    c.indenter.radius = 40e-3;
    c.substrate = {5e6, .5};
    c.friction.coefficient = .6;
    c.load.normal_force = 20;
    c.load.tangential_ratio = .5;
    c.rolling.emplace();
    c.rolling->amplitude_ratio = .25;
    c.rolling->periods = 3;
    c.rolling->run_all = true;
    c.rolling->steps_per_quarter = 2;
    c.of<contact::Cells>().per_radius = 8;
    return c;
}

struct Played {
    contact::History history;
    std::optional<report::Film> film;
    contact::Surface last;
};

Played played(const contact::Case& c) {
    Played result;
    const auto model = bem::make_model(c, 1);
    ContactFilm film(c);
    result.history =
        contact::run(c, *model, [&](const auto& record, auto& state, const auto& progress) {
            film.add(
                record, [&] { return state.surface(); }, progress);
            result.last = state.surface();
        });
    result.film = film.film(result.history);
    return result;
}

const Played& rolled() {
    static const Played once = played(rolling_case());
    return once;
}

TEST(ContactFilm, HoldsTheFirstPeriodAndTheLast) {
    const auto& film = rolled().film;
    ASSERT_TRUE(film);
    ASSERT_EQ(film->frames.size(), 2u + 8 + 8);
    EXPECT_EQ(film->frames[0].label, "pressed");
    EXPECT_EQ(film->frames[1].label, "loaded");
    EXPECT_EQ(film->frames[2].label, "n = 0.125");
    EXPECT_EQ(film->frames[10].label, "n = 2.125");
    EXPECT_EQ(film->frames.back().label, "n = 3");
    EXPECT_EQ(film->frames[2].part, report::Film::Part::first_period);
    EXPECT_NEAR(film->frames[10].phase, .125, 1e-9);
    EXPECT_EQ(film->frames.back().part, report::Film::Part::last_period);
    EXPECT_NEAR(film->frames.back().phase, 1, 1e-9);
    EXPECT_NEAR(film->frames.back().shift, 1e6 * rolled().history.shift_per_period.back(), 1e-9);
    EXPECT_EQ(film->steps.size(), rolled().history.steps.size());
    // Steps and frames tell the same places: a turning point, and the end upright.
    EXPECT_NEAR(film->frames[3].way, 1e3 * rolled().history.amplitude, 1e-9);
    EXPECT_NEAR(film->frames.back().way, film->steps.back().way, 1e-12);
}

// Coupled contact that is pressed with friction has forces of rounding along the surface, which are
// no load.
TEST(ContactFilm, APressedContactIsNotLoaded) {
    contact::Case c = rolling_case();
    c.rolling.reset();
    c.substrate.poisson = .3;
    const auto model = bem::make_model(c, 1);
    ContactFilm film(c);
    const auto history =
        contact::run(c, *model, [&](const auto& record, auto& state, const auto& progress) {
            contact::StepRecord told = record;
            if (told.tangential_force[0] == 0) told.tangential_force[0] = 1e-15;
            film.add(
                told, [&] { return state.surface(); }, progress);
        });
    const auto played = film.film(history);
    ASSERT_TRUE(played);
    ASSERT_EQ(played->frames.size(), 2u);
    EXPECT_EQ(played->frames[0].label, "pressed");
    EXPECT_EQ(played->frames[1].label, "loaded");
}

// What the bytes of the last frame say, against the model's own surface: sums of pressure and
// traction to half a step of each cell, states exactly.
TEST(ContactFilm, BytesAreTheSurface) {
    const report::Film& film = *rolled().film;
    const contact::Surface& s = rolled().last;
    const auto n_cells = static_cast<std::size_t>(std::ranges::count(film.mask, true));
    ASSERT_EQ(film.bytes.size(), film.frames.size() * n_cells * report::Film::n_fields);
    const auto* frame = film.bytes.data() + film.bytes.size() - n_cells * report::Film::n_fields;
    const double pressure = std::ranges::max(s.normal_traction);
    std::size_t k = 0, n_slip = 0;
    for (int j = 0; j < film.cells.n_y; ++j)
        for (int i = 0; i < film.cells.n_x; ++i) {
            if (!film.mask[static_cast<std::size_t>(j * film.cells.n_x + i)]) continue;
            const double x = 1e-3 * film.cells.x(i), y = 1e-3 * film.cells.y(j);
            const auto cell =
                static_cast<std::size_t>(std::lround((y - s.first[1]) / s.spacing[1])) * s.n_x +
                static_cast<std::size_t>(std::lround((x - s.first[0]) / s.spacing[0]));
            EXPECT_EQ(frame[4 * n_cells + k], static_cast<int>(s.contact_state[cell]));
            n_slip += s.contact_state[cell] == ContactState::slip;
            // The largest pressure of all frames is that of an upright contact, as here.
            EXPECT_NEAR(frame[k] / 255., s.normal_traction[cell] / pressure, .01);
            // Less than a step of the largest traction, which is below that pressure, is zero.
            if (std::abs(s.tangential_traction_x[cell]) > .01 * pressure) {
                EXPECT_EQ(frame[n_cells + k] > 128, s.tangential_traction_x[cell] > 0) << k;
            }
            ++k;
        }
    EXPECT_GT(n_slip, 0u);
    // All that touches is played.
    const auto touching = std::ranges::count_if(
        s.contact_state, [](ContactState state) { return state != ContactState::open; });
    EXPECT_LE(static_cast<std::size_t>(touching), n_cells);
}

// Springs of MDR are a line along the path, also where that is at an angle to x: as many springs as
// stick in the last state say so, and the largest pressure is that of the model's own scale.
TEST(ContactFilm, LinesOfSprings) {
    contact::Case c = rolling_case();
    c.models = {"mdr"};
    c.of<mdr::Settings>().springs = 200;
    c.rolling->angle = .5;
    const auto model = mdr::make_model(c);
    ContactFilm film(c);
    std::size_t n_stick = 0;
    const auto history =
        contact::run(c, *model, [&](const auto& record, auto& state, const auto& progress) {
            film.add(
                record, [&] { return state.surface(); }, progress);
            n_stick = static_cast<std::size_t>(
                std::ranges::count(state.contact_states(), ContactState::stick));
        });
    const auto line = film.film(history);
    ASSERT_TRUE(line);
    EXPECT_EQ(line->line, "springs");
    EXPECT_EQ(line->cells.n_y, 1);
    EXPECT_TRUE(line->heights.empty());
    const auto n_cells = static_cast<std::size_t>(std::ranges::count(line->mask, true));
    const auto states = std::span(line->bytes).last(n_cells);
    ASSERT_GT(n_stick, 0u);
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(states, 1)), n_stick);
    EXPECT_NEAR(line->frames[3].x, 1e3 * history.amplitude, 1e-9);  // a turning point
    EXPECT_EQ(line->frames[3].y, 0);
    const auto player = player_of(c, {*line});
    ASSERT_TRUE(player);
    EXPECT_NE(player->caption.find("springs"), std::string::npos);
    EXPECT_TRUE(player->body_heights.empty());
    EXPECT_FALSE(player_of(c, {}));
}

// Under the indenter, where nothing is open, the surface has its shape: height of the surface = h -
// d, to the steps in which both are kept (a spacing of both grids aside, h is taken exactly).
TEST(ContactFilm, TheSurfaceFollowsTheIndenter) {
    const report::Film& film = *rolled().film;
    const contact::Case c = rolling_case();
    const report::Player player = *player_of(c, {film});
    const report::Film::Frame& last = film.frames.back();
    const std::size_t start = (film.frames.size() - 1) * film.relief.size();
    const double step = (film.highest - film.lowest) / 65535;
    std::size_t n_touching = 0;
    for (int j = 0; j < film.relief.n_y; ++j)
        for (int i = 0; i < film.relief.n_x; ++i) {
            const double x = film.relief.x(i) - last.x, y = film.relief.y(j) - last.y;  // [mm]
            const double height =
                film.lowest + step * film.heights[start + j * film.relief.n_x + i];  // [um]
            const double body = 1e3 * (x * x + y * y) / (2 * 40) - last.depth;
            // The body is never below the surface; 1e-4 of the depth: the solver's tolerance.
            EXPECT_GT(body, height - 2 * step - 1e-4 * last.depth);
            n_touching += std::abs(body - height) < 2 * step + 1e-4 * last.depth;
        }
    const auto touching =
        std::ranges::count_if(rolled().last.contact_state,
                              [](ContactState state) { return state != ContactState::open; });
    const double share = film.relief.spacing_x / (1e3 * rolled().last.spacing[0]);
    EXPECT_NEAR(n_touching * share * share, touching, .1 * touching);  // the edge, by whole cells
    // The indenter: a paraboloid up to the corner.
    EXPECT_NEAR(player.highest_body, 1e3 * (player.body.first_x * player.body.first_x) / 40,
                1e-6 * player.highest_body);
    EXPECT_EQ(player.body_heights.front(), 65534);
}

// A stress field that is known, sigma_z = 1e5 Pa + 1e7 Pa/m * x + 2e7 Pa/m * depth alone, is its
// own von Mises stress; the largest is in the deepest right corner of the picture.
TEST(ContactFilm, SectionsAreTheStresses) {
    const contact::Case c = rolling_case();
    const auto model = bem::make_model(c, 1);
    ContactFilm film(c);
    contact::Subsurface section;
    for (int i = -30; i <= 30; ++i) section.x.push_back(1e-3 * i);
    for (int k = 0; k <= 10; ++k) section.z.push_back(-1e-3 * (10 - k) * (10 - k) / 5);
    const auto stress = [](double x, double depth) { return 1e6 + 1e7 * x + 2e7 * depth; };
    for (const double z : section.z)
        for (const double x : section.x) section.stress.push_back({0, 0, stress(x, -z), 0, 0, 0});
    const auto history =
        contact::run(c, *model, [&](const auto& record, auto& state, const auto& progress) {
            film.add(
                record, [&] { return state.surface(); }, progress);
            if (record.phase == 3) film.add_section(section, progress.step);
        });
    const report::Film made = *film.film(history);
    EXPECT_EQ(made.frames.back().section, 0);
    EXPECT_EQ(made.frames.front().section, -1);
    ASSERT_EQ(made.von_mises.size(), made.section.size());
    // As wide as the surface's picture, no deeper than wide, and no deeper than what is known.
    EXPECT_NEAR(made.section.n_x * made.section.spacing_x, made.cells.n_x * made.cells.spacing_x,
                1e-9);
    const auto value = [&](int i, int j) {
        return stress(1e-3 * made.section.x(i) - history.steps.back().offset[0],
                      1e-3 * made.section.y(j));
    };
    const double largest = value(made.section.n_x - 1, made.section.n_y - 1);
    for (int j = 0; j < made.section.n_y; j += 7)
        for (int i = 0; i < made.section.n_x; i += 7)
            EXPECT_NEAR(made.von_mises[j * made.section.n_x + i], 1 + 254 * value(i, j) / largest,
                        .51)
                << i << ' ' << j;
}

// However many steps a period has, what is kept of it is bounded; turning points and the ends of
// periods stay.
TEST(ContactFilm, LongPeriodsAreThinned) {
    contact::Case c = rolling_case();
    c.models = {"mdr"};
    c.of<mdr::Settings>().springs = 60;
    c.rolling->steps_per_quarter = 75;
    const auto model = mdr::make_model(c);
    ContactFilm film(c);
    const auto history =
        contact::run(c, *model, [&](const auto& record, auto& state, const auto& progress) {
            film.add(
                record, [&] { return state.surface(); }, progress);
        });
    const auto line = film.film(history);
    ASSERT_TRUE(line);
    EXPECT_LE(line->frames.size(), 60u);
    for (const char* label : {"n = 0.25", "n = 0.75", "n = 1", "n = 2.25", "n = 3"})
        EXPECT_TRUE(std::ranges::any_of(line->frames, [&](const report::Film::Frame& frame) {
            return frame.label == label;
        })) << label;
}

// Fine grids and long paths stay below the size of a page: 600 kB a model, five in 3 MB.
TEST(ContactFilm, StaysSmall) {
    contact::Case c = rolling_case();
    c.of<contact::Cells>().per_radius = 40;  // more than 96 across
    c.rolling->periods = 1;
    c.rolling->steps_per_quarter = 1;
    const Played fine = played(c);
    ASSERT_TRUE(fine.film);
    const report::Film& film = *fine.film;
    EXPECT_LE(report::player_json(*player_of(c, {film}))["films"][0].dump().size(), 620'000u);
    EXPECT_LE(std::max(film.cells.n_x, film.cells.n_y), 96);
    EXPECT_EQ(film.frames.back().label, "n = 1");
}

}  // namespace
}  // namespace tricontact::comparisons
