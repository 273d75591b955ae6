#include "comparisons/run/contact_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/quantities/reference.h"
#include "comparisons/run/common_instants.h"
#include "contact/load_path.h"
#include "report/format.h"
#include "report/packed.h"

namespace tricontact::comparisons {

namespace {

using contact::History;
using contact::StepRecord;
using contact::Surface;
using report::Film;
using report::FilmGrid;

constexpr std::size_t most_points = 512 * 512;  // of a surface that is kept step by step
constexpr std::size_t most_frames = 50;         // of a film, but for quarters of periods
constexpr std::size_t most_packed = 600'000;    // characters of a film: five stay at 3 MB
constexpr int body_cells = 64;                  // from edge to edge of the indenter's picture
constexpr double mm = 1e3, um = 1e6;
constexpr double phase_rounding = 1e-9;  // phases are sums of rounded fractions

std::string label_of(const StepRecord& record, bool is_path) {
    return fmt::format("{}{:.4g}", is_path ? "row " : "n = ", record.phase);
}

bool same_line(const Shot& a, const Shot& b) {
    return a.n_x == b.n_x && a.first == b.first && a.spacing == b.spacing;
}

std::size_t packed_size(const Film& film) {
    const auto size = [](const auto& values) {
        return report::packed({reinterpret_cast<const char*>(values.data()),
                               values.size() * sizeof(values[0])})
            .size();
    };
    return size(film.bytes) + size(film.heights) + size(film.von_mises);
}

/// The undeformed indenter, as wide as what the films show around their contacts.
void add_body(const contact::Case& c, report::Player& player) {
    double half = 0;  // [mm]
    for (const Film& film : player.films)
        half = std::max({half, film.relief.n_x * film.relief.spacing_x / 2,
                         film.relief.n_y * film.relief.spacing_y / 2});
    if (half == 0) return;
    const auto indenter = c.make_indenter();
    const double step = 2 * half / body_cells;
    player.body = {body_cells + 1, body_cells + 1, -half, -half, step, step};
    std::vector<double> heights;
    double highest = 0;
    for (int j = 0; j <= body_cells; ++j)
        for (int i = 0; i <= body_cells; ++i) {
            const double h = indenter->height(player.body.x(i) / mm, player.body.y(j) / mm);
            heights.push_back(h);
            if (std::isfinite(h)) highest = std::max(highest, h);
        }
    player.highest_body = um * highest;
    for (const double h : heights)
        player.body_heights.push_back(!std::isfinite(h) ? 65535
                                      : highest > 0     ? static_cast<std::uint16_t>(std::lround(
                                                              65534 * std::clamp(h / highest, 0., 1.)))
                                                        : 0);
}

}  // namespace

ContactFilm::ContactFilm(const contact::Case& c)
    : is_path_(c.prescribed_path.has_value()), direction_(contact::path_direction(c)) {}

std::optional<Shot> ContactFilm::shot_of(const StepRecord& record, const SurfaceOfStep& surface_of,
                                         const contact::Progress& progress) {
    Surface surface = surface_of();
    is_playable_ = surface.size() <= most_points;
    if (!is_playable_) return {};
    is_springs_ = surface.layout == Surface::Layout::line;
    if (surface.layout == Surface::Layout::nodes && !is_grid(surface)) {
        if (!resampling_) resampling_.emplace(surface);
        surface = (*resampling_)(surface);
    }
    Shot shot(surface);
    shot.record = record;
    shot.label = label_of(record, is_path_);
    const double period = std::ceil(record.phase - phase_rounding);
    shot.part = is_path_     ? Film::Part::path
                : period > 1 ? Film::Part::last_period
                             : Film::Part::first_period;
    shot.phase = is_path_ ? record.phase : record.phase - (period - 1);
    shot.is_quarter = progress.quarter && !is_path_;
    shot.step = progress.step;
    return shot;
}

void ContactFilm::keep(ShotRow& row, const StepRecord& record, const SurfaceOfStep& surface,
                       const contact::Progress& progress) {
    if (!row.wants(is_path_ ? progress.step == progress.steps_at_most : progress.quarter)) return;
    if (auto shot = shot_of(record, surface, progress)) row.add(std::move(*shot));
}

void ContactFilm::add(const StepRecord& record, const SurfaceOfStep& surface,
                      const contact::Progress& progress) {
    if (progress.step == 1) {  // all before is void
        pressed_.reset(), loaded_.reset(), resampling_.reset();
        first_ = recent_ = {};
    }
    if (!is_playable_) return;
    if (is_path_) return keep(first_, record, surface, progress);
    if (record.phase == 0) {
        auto shot = shot_of(record, surface, progress);
        if (!shot) return;
        // Coupled contact that is pressed balances its tractions but for rounding.
        const bool loaded = is_loaded(contact::norm(record.tangential_force) / record.normal_force);
        shot->label = loaded ? "loaded" : "pressed";
        shot->part = loaded ? Film::Part::loaded : Film::Part::pressed;
        shot->phase = 0;
        (loaded ? loaded_ : pressed_) = std::move(shot);
        return;
    }
    if (record.phase <= 1) return keep(first_, record, surface, progress);
    const double period = std::ceil(record.phase - phase_rounding);
    if (period != recent_period_) recent_.clear();
    recent_period_ = period;
    keep(recent_, record, surface, progress);
}

void ContactFilm::add_section(const contact::Subsurface& section, int step) {
    const auto offer = [&](Shot& shot) {
        if (shot.step == step) shot.section = section;
    };
    for (auto* one : {&pressed_, &loaded_})
        if (*one) offer(**one);
    for (auto* row : {&first_, &recent_})
        for (Shot& shot : row->shots()) offer(shot);
}

std::vector<const Shot*> ContactFilm::chosen() const {
    std::vector<const Shot*> all;
    for (const auto* one : {&pressed_, &loaded_})
        if (*one) all.push_back(&**one);
    const std::size_t n_moving = first_.shots().size() + recent_.shots().size();
    const std::size_t every = n_moving / most_frames + 1;
    // From the end of each period backwards: its last instant is the one that counts.
    for (const auto* row : {&first_, &recent_}) {
        const std::vector<Shot>& shots = row->shots();
        for (std::size_t i = 0; i < shots.size(); ++i)
            if (shots[i].is_quarter || (shots.size() - 1 - i) % every == 0)
                all.push_back(&shots[i]);
    }
    return all;
}

std::optional<Film> ContactFilm::film(const History& history) const {
    std::vector<const Shot*> shots = chosen();
    if (!is_playable_ || shots.size() < 2) return {};
    // Beds of springs that proved too short were made longer.
    std::vector<Shot> lines;
    if (shots.back()->n_y == 1) {
        lines.reserve(shots.size());
        for (const Shot*& shot : shots)
            if (!same_line(*shot, *shots.back()))
                shot = &lines.emplace_back(shot->on_line_of(*shots.back()));
    }
    Film film = film_of(shots, direction_);
    if (film.frames.empty()) return {};
    // Every second, third ... instant, from the end, until they fit.
    for (std::size_t every = 2; every < shots.size() && packed_size(film) > most_packed; ++every) {
        std::vector<const Shot*> fewer;
        for (std::size_t n = 0; n < shots.size(); ++n)
            if ((shots.size() - 1 - n) % every == 0) fewer.push_back(shots[n]);
        film = film_of(fewer, direction_);
    }
    film.name = report::display_name(history.model);
    film.style = report::model_style(history.model).value_or(0);
    if (film.cells.n_y == 1) film.line = is_springs_ ? "springs" : "cells";
    for (const StepRecord& step : history.steps)
        film.steps.push_back(
            {step.phase,
             mm * (step.offset[0] * std::cos(direction_) + step.offset[1] * std::sin(direction_)),
             um * step.shift[0], step.tangential_force[0]});
    if (is_springs_)  // a line of its own, along the path
        for (Film::Frame& frame : film.frames) frame.x = frame.way, frame.y = 0;
    return film;
}

std::optional<report::Player> player_of(const contact::Case& c, const std::vector<Film>& films) {
    if (films.empty()) return {};
    report::Player player{
        .caption =
            "Surface of the substrate from above, x to the right; the circle marks the "
            "indenter's lowest point. Played: the pressed and the loaded contact, the "
            "first period and each model's last one, at the same share of the period for all "
            "models; of a prescribed path its steps. Below each model: its period n, and its "
            "largest value of all instants.",
        .axis = c.prescribed_path ? "row of the path" : "period n",
        .films = films,
        .instants = common_instants(films),
        .largest = largest_of(films)};
    const auto has = [&](const auto& property) { return std::ranges::any_of(films, property); };
    if (has([](const Film& film) { return film.line == "springs"; }))
        player.caption +=
            " MDR is a line of springs along the path: stick, slip and gap are theirs, pressure "
            "and traction those of the round contact at that distance from the indenter, "
            "transformed back from the springs' loads (of their even part).";
    if (has([](const Film& film) { return film.line == "cells"; }))
        player.caption += " A cylinder's contact is the same along its axis: a line across it.";
    if (has([](const Film& film) { return !film.von_mises.empty(); }))
        player.caption +=
            " Sections: von Mises' stress below the surface in the plane of the indenter's lowest "
            "point, at the instants at which the inside was computed.";
    if (c.adhesion) player.caption += " Tension is drawn as no pressure; surface.ex2 has it.";
    add_body(c, player);
    return player;
}

}  // namespace tricontact::comparisons
