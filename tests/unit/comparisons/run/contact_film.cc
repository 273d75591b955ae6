#include "comparisons/run/contact_film.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bem/model.h"
#include "contact/run.h"
#include "mdr/model.h"

namespace tricontact::comparisons {
namespace {

using contact::ContactState;

contact::Case rolling_case() {
    contact::Case c;
    c.models = {"bem"};
    c.indenter.radius = 40e-3;
    c.substrate = {5e6, .5};
    c.friction_coefficient = .6;
    c.load.normal_force = 20;
    c.load.tangential_ratio = .5;
    c.rolling.emplace();
    c.rolling->amplitude_ratio = .25;
    c.rolling->periods = 3;
    c.rolling->run_all = true;
    c.rolling->steps_per_quarter = 2;
    c.bem.cells_per_radius = 8;
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
            film.add(record, state, progress);
            result.last = state.surface();
        });
    result.film = film.film(result.history, 1);
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
    EXPECT_NEAR(film->frames.back().shift, 1e6 * rolled().history.shift_per_period.back(), 1e-9);
    EXPECT_EQ(film->steps.size(), rolled().history.steps.size());
    // Steps and frames tell the same places: a turning point, and the end upright.
    EXPECT_NEAR(film->frames[3].way, 1e3 * rolled().history.amplitude, 1e-9);
    EXPECT_NEAR(film->frames.back().way, film->steps.back().way, 1e-12);
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
    for (int j = 0; j < film.n_y; ++j)
        for (int i = 0; i < film.n_x; ++i) {
            if (!film.mask[static_cast<std::size_t>(j * film.n_x + i)]) continue;
            const double x = 1e-3 * (film.first_x + i * film.spacing_x),
                         y = 1e-3 * (film.first_y + j * film.spacing_y);
            const auto cell =
                static_cast<std::size_t>(std::lround((y - s.first[1]) / s.spacing[1])) * s.n_x +
                static_cast<std::size_t>(std::lround((x - s.first[0]) / s.spacing[0]));
            EXPECT_EQ(frame[4 * n_cells + k], static_cast<int>(s.contact_state[cell]));
            n_slip += s.contact_state[cell] == ContactState::slip;
            // The largest pressure of all frames is that of an upright contact, as here.
            EXPECT_NEAR(frame[k] / 255., s.normal_traction[cell] / pressure, .01);
            // Less than a step of the largest traction, which is below that pressure, is zero.
            if (std::abs(s.tangential_traction_x[cell]) > .01 * pressure)
                EXPECT_EQ(frame[n_cells + k] > 128, s.tangential_traction_x[cell] > 0) << k;
            ++k;
        }
    EXPECT_GT(n_slip, 0u);
    // All that touches is played.
    const auto touching = std::ranges::count_if(
        s.contact_state, [](ContactState state) { return state != ContactState::open; });
    EXPECT_LE(static_cast<std::size_t>(touching), n_cells);
}

// Springs of MDR are a line: there is no surface to be played.
TEST(ContactFilm, LinesHaveNone) {
    contact::Case c = rolling_case();
    c.models = {"mdr"};
    c.mdr.springs = 200;
    const auto model = mdr::make_model(c);
    ContactFilm film(c);
    const auto history =
        contact::run(c, *model, [&](const auto& record, auto& state, const auto& progress) {
            film.add(record, state, progress);
        });
    EXPECT_FALSE(film.film(history, 0));
    EXPECT_FALSE(player_of(c, {}));
}

// Fine grids and long paths stay below the size of a page: 600 kB a model.
TEST(ContactFilm, StaysSmall) {
    contact::Case c = rolling_case();
    c.bem.cells_per_radius = 44;  // more than 96 across
    c.rolling->periods = 1;
    c.rolling->steps_per_quarter = 6;
    const Played fine = played(c);
    ASSERT_TRUE(fine.film);
    EXPECT_LE(fine.film->bytes.size(), 600'000u);
    EXPECT_LE(std::max(fine.film->n_x, fine.film->n_y), 96);
    EXPECT_EQ(fine.film->frames.back().label, "n = 1");
}

}  // namespace
}  // namespace tricontact::comparisons
