#include "comparisons/run/contact_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/load_path.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using contact::ContactState;
using contact::History;
using contact::StepRecord;
using contact::Surface;
using report::Film;

constexpr std::size_t most_points = 512 * 512;  // of a surface that is kept step by step
constexpr std::size_t most_frames = 50;         // of a film
constexpr std::size_t most_path_shots = 400;    // before they are thinned
constexpr std::size_t most_bytes =
    600'000;                    // of a film: five of them stay below 3 MB, base64 (4/3) included
constexpr int most_cells = 96;  // in each direction
constexpr double mm = 1e3, um = 1e6;

/// What is played, of a surface.
Surface thinned_fields(Surface s) {
    Surface kept;
    kept.layout = Surface::Layout::grid;
    kept.n_x = s.n_x;
    kept.n_y = s.n_y;
    kept.first = s.first;
    kept.spacing = s.spacing;
    kept.normal_traction = std::move(s.normal_traction);
    kept.tangential_traction_x = std::move(s.tangential_traction_x);
    kept.tangential_traction_y = std::move(s.tangential_traction_y);
    kept.gap = std::move(s.gap);
    kept.contact_state = std::move(s.contact_state);
    return kept;
}

std::string label_of(double phase, bool is_path) {
    return is_path ? fmt::format("row {:.4g}", phase) : fmt::format("n = {:.4g}", phase);
}

/// The box of cells that are ever in contact, with one cell around it, and every `stride`-th of
/// these.
struct Window {
    int low_x = 0, low_y = 0, stride = 1, n_x = 0, n_y = 0;

    std::size_t cell(const Surface& s, int i, int j) const {
        return static_cast<std::size_t>(low_y + j * stride) * s.n_x + low_x + i * stride;
    }
};

Window window_of(const Surface& s, const std::vector<bool>& touched) {
    int low_x = s.n_x, high_x = -1, low_y = s.n_y, high_y = -1;
    for (int j = 0; j < s.n_y; ++j)
        for (int i = 0; i < s.n_x; ++i)
            if (touched[static_cast<std::size_t>(j) * s.n_x + i]) {
                low_x = std::min(low_x, i), high_x = std::max(high_x, i);
                low_y = std::min(low_y, j), high_y = std::max(high_y, j);
            }
    if (high_x < 0) return {};
    low_x = std::max(0, low_x - 1), high_x = std::min(s.n_x - 1, high_x + 1);
    low_y = std::max(0, low_y - 1), high_y = std::min(s.n_y - 1, high_y + 1);
    Window window{low_x, low_y};
    const int longest = std::max(high_x - low_x, high_y - low_y) + 1;
    window.stride = (longest + most_cells - 1) / most_cells;
    window.n_x = (high_x - low_x) / window.stride + 1;
    window.n_y = (high_y - low_y) / window.stride + 1;
    return window;
}

std::uint8_t byte(double value, double largest) {
    if (!(largest > 0) || !std::isfinite(value)) return 0;
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value / largest, 0., 1.)));
}
/// 128: zero.
std::uint8_t signed_byte(double value, double largest) {
    if (!(largest > 0)) return 128;
    return static_cast<std::uint8_t>(128 + std::lround(127 * std::clamp(value / largest, -1., 1.)));
}

/// "0.31 MPa".
std::string in_words(double value, const char* unit) {
    return report::quantity(value, unit, 3);
}

}  // namespace

ContactFilm::ContactFilm(const contact::Case& c)
    : is_path_(c.prescribed_path.has_value()), direction_(contact::path_direction(c)) {}

void ContactFilm::keep(std::vector<Shot>& shots, const StepRecord& record,
                       const contact::Model& model) {
    Surface surface = model.surface();
    if (surface.layout == Surface::Layout::line || surface.size() > most_points) {
        is_playable_ = false;
        return;
    }
    if (surface.layout == Surface::Layout::nodes && !is_grid(surface)) {
        if (!resampling_) resampling_.emplace(surface);
        surface = (*resampling_)(surface);
    }
    if (surface.n_y < 2) {
        is_playable_ = false;
        return;
    }
    shots.push_back({record, thinned_fields(std::move(surface))});
}

void ContactFilm::add(const StepRecord& record, const contact::Model& model,
                      const contact::Progress& progress) {
    if (progress.step == 1) {  // all before is void
        pressed_.reset(), loaded_.reset(), resampling_.reset();
        first_.clear(), recent_.clear();
        every_ = 1, n_seen_ = 0;
    }
    if (!is_playable_) return;
    std::vector<Shot> shot;
    if (is_path_) {
        if (n_seen_++ % every_ == 0) keep(first_, record, model);
        if (first_.size() <= most_path_shots) return;
        for (std::size_t i = 0; 2 * i < first_.size(); ++i) first_[i] = std::move(first_[2 * i]);
        first_.resize((first_.size() + 1) / 2);
        every_ *= 2;
        return;
    }
    if (record.phase == 0) {
        keep(shot, record, model);
        if (shot.empty()) return;
        const bool is_loaded = record.tangential_force[0] != 0 || record.tangential_force[1] != 0;
        (is_loaded ? loaded_ : pressed_) = std::move(shot.front());
        return;
    }
    if (record.phase <= 1) return keep(first_, record, model);
    const double period = std::ceil(record.phase - 1e-9);  // phases are sums of rounded fractions
    if (period != recent_period_) recent_.clear();
    recent_period_ = period;
    keep(recent_, record, model);
}

std::vector<const ContactFilm::Shot*> ContactFilm::chosen() const {
    std::vector<const Shot*> all;
    for (const auto* one : {&pressed_, &loaded_})
        if (*one) all.push_back(&**one);
    const std::size_t n_moving = first_.size() + recent_.size();
    const std::size_t every = n_moving / most_frames + 1;
    // From the end of each period backwards: its last instant is the one that counts.
    for (const auto* shots : {&first_, &recent_})
        for (std::size_t i = 0; i < shots->size(); ++i)
            if ((shots->size() - 1 - i) % every == 0) all.push_back(&(*shots)[i]);
    return all;
}

std::optional<Film> ContactFilm::film(const History& history, int style) const {
    const std::vector<const Shot*> shots = chosen();
    if (!is_playable_ || shots.size() < 2) return {};
    const Surface& grid = shots.front()->surface;
    std::vector<bool> touched(grid.size(), false);
    double pressure = 0, traction = 0, gap = 0;
    for (const Shot* shot : shots)
        for (std::size_t k = 0; k < grid.size(); ++k)
            if (shot->surface.contact_state[k] != ContactState::open) touched[k] = true;
    const Window window = window_of(grid, touched);
    if (window.n_x == 0) return {};
    Film film{.name = report::display_name(history.model),
              .style = style,
              .n_x = window.n_x,
              .n_y = window.n_y,
              .first_x = mm * grid.x(window.low_x),
              .first_y = mm * grid.y(window.low_y),
              .spacing_x = mm * grid.spacing[0] * window.stride,
              .spacing_y = mm * grid.spacing[1] * window.stride};
    std::vector<std::size_t> cells;
    for (int j = 0; j < window.n_y; ++j)
        for (int i = 0; i < window.n_x; ++i) {
            const std::size_t k = window.cell(grid, i, j);
            film.mask.push_back(touched[k]);
            if (touched[k]) cells.push_back(k);
        }
    for (const Shot* shot : shots)
        for (const std::size_t k : cells) {
            const Surface& s = shot->surface;
            pressure = std::max(pressure, s.normal_traction[k]);
            traction = std::max(traction,
                                std::hypot(s.tangential_traction_x[k], s.tangential_traction_y[k]));
            if (std::isfinite(s.gap[k])) gap = std::max(gap, s.gap[k]);
        }
    film.largest_pressure = in_words(pressure, "Pa");
    film.largest_traction = in_words(traction, "Pa");
    film.largest_gap = in_words(gap, "m");
    const std::size_t of_a_frame = std::max<std::size_t>(1, Film::n_fields * cells.size());
    const std::size_t every = shots.size() * of_a_frame / most_bytes + 1;
    const auto way_of = [&](const StepRecord& step) {
        return mm * (step.offset[0] * std::cos(direction_) + step.offset[1] * std::sin(direction_));
    };
    for (std::size_t n = 0; n < shots.size(); ++n) {
        if ((shots.size() - 1 - n) % every != 0) continue;
        const auto& [record, s] = *shots[n];
        const auto is = [&](const std::optional<Shot>& one) { return one && &*one == shots[n]; };
        const std::string label = is(pressed_)  ? "pressed"
                                  : is(loaded_) ? "loaded"
                                                : label_of(record.phase, is_path_);
        film.frames.push_back({label, mm * record.offset[0], mm * record.offset[1],
                               um * record.shift[0], record.phase, way_of(record)});
        const auto add = [&](const auto& value_of) {
            for (const std::size_t k : cells) film.bytes.push_back(value_of(k));
        };
        add([&](std::size_t k) { return byte(s.normal_traction[k], pressure); });
        add([&](std::size_t k) { return signed_byte(s.tangential_traction_x[k], traction); });
        add([&](std::size_t k) { return signed_byte(s.tangential_traction_y[k], traction); });
        add([&](std::size_t k) { return byte(s.gap[k], gap); });
        add([&](std::size_t k) { return static_cast<std::uint8_t>(s.contact_state[k]); });
    }
    for (const StepRecord& step : history.steps)
        film.steps.push_back({step.phase, way_of(step), um * step.shift[0]});
    return film;
}

std::optional<report::Player> player_of(const contact::Case& c, const std::vector<Film>& films) {
    if (films.empty()) return {};
    return report::Player{
        .caption =
            "Surface of the substrate from above, x to the right; the circle marks the "
            "indenter's lowest point. Played: the pressed and the loaded contact, the "
            "first period and the last one; of a prescribed path its steps. Each model's "
            "colours go to its own largest value, which stands below it; values in 127 or "
            "255 steps.",
        .axis = c.prescribed_path ? "row of the path" : "period n",
        .films = films};
}

}  // namespace tricontact::comparisons
