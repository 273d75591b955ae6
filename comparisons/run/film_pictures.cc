#include <algorithm>
#include <cmath>
#include <limits>

#include "comparisons/run/film_shots.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using contact::ContactState;
using report::Film;
using report::FilmGrid;
using Shots = std::vector<const Shot*>;

constexpr int most_cells = 96, most_line_cells = 240;  // in each direction
constexpr int most_relief_cells = 56;
constexpr double relief_margin = 0.35;  // of the contact's longer side, beyond it on each side
constexpr int section_cells = 72;       // along x
constexpr double deepest_section = 1.;  // over its width
constexpr double to_mm = 1e3, to_um = 1e6;

/// A box of cells of the shots' grid, and every `stride`-th of these.
struct Window {
    int low_x = 0, low_y = 0, stride = 1, n_x = 0, n_y = 0;

    std::size_t cell(const Shot& s, int i, int j) const {
        return static_cast<std::size_t>(low_y + j * stride) * s.n_x + low_x + i * stride;
    }
    FilmGrid grid(const Shot& s) const {
        return {.n_x = n_x,
                .n_y = n_y,
                .first_x = to_mm * (s.first[0] + low_x * s.spacing[0]),
                .first_y = to_mm * (s.first[1] + low_y * s.spacing[1]),
                .spacing_x = to_mm * s.spacing[0] * stride,
                .spacing_y = to_mm * s.spacing[1] * stride};
    }
};

/// The cells between two corners, inside the grid.
Window window_of(const Shot& s, int low_x, int high_x, int low_y, int high_y, int most) {
    low_x = std::max(0, low_x), high_x = std::min(s.n_x - 1, high_x);
    low_y = std::max(0, low_y), high_y = std::min(s.n_y - 1, high_y);
    Window window{low_x, low_y};
    window.stride = (std::max(high_x - low_x, high_y - low_y) + most) / most;
    window.n_x = (high_x - low_x) / window.stride + 1;
    window.n_y = (high_y - low_y) / window.stride + 1;
    return window;
}

/// What is ever in contact, with a cell around it for the fields and more for the relief.
struct Touched {
    std::vector<bool> cells;
    int low_x, high_x = -1, low_y, high_y = -1;

    explicit Touched(const Shots& shots) {
        const Shot& s = *shots.front();
        cells.assign(static_cast<std::size_t>(s.n_x) * s.n_y, false);
        low_x = s.n_x, low_y = s.n_y;
        for (const Shot* shot : shots)
            for (std::size_t k = 0; k < cells.size(); ++k)
                if (shot->state[k] != ContactState::open) cells[k] = true;
        for (int j = 0; j < s.n_y; ++j)
            for (int i = 0; i < s.n_x; ++i)
                if (cells[static_cast<std::size_t>(j) * s.n_x + i]) {
                    low_x = std::min(low_x, i), high_x = std::max(high_x, i);
                    low_y = std::min(low_y, j), high_y = std::max(high_y, j);
                }
    }
    bool none() const { return high_x < 0; }
    Window fields(const Shot& s) const {
        return window_of(s, low_x - 1, high_x + 1, low_y - 1, high_y + 1,
                         s.n_y > 1 ? most_cells : most_line_cells);
    }
    Window relief(const Shot& s) const {
        const int margin = static_cast<int>(
            std::ceil(relief_margin * (std::max(high_x - low_x, high_y - low_y) + 1)));
        return window_of(s, low_x - margin, high_x + margin, low_y - margin, high_y + margin,
                         most_relief_cells);
    }
};

std::uint8_t byte(double value, double largest) {
    if (!(largest > 0) || !std::isfinite(value)) return 0;
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value / largest, 0., 1.)));
}
/// 128: zero.
std::uint8_t signed_byte(double value, double largest) {
    if (!(largest > 0) || !std::isfinite(value)) return 128;
    return static_cast<std::uint8_t>(128 + std::lround(127 * std::clamp(value / largest, -1., 1.)));
}

/// "0.31 MPa".
std::string in_words(double value, const char* unit) {
    return report::quantity(value, unit, 3);
}

void add_fields(const Shots& shots, const std::vector<std::size_t>& cells, Film& film) {
    double pressure = 0, traction = 0, gap = 0;
    for (const Shot* s : shots)
        for (const std::size_t k : cells) {
            pressure = std::max<double>(pressure, s->fields[Shot::pressure][k]);
            traction = std::max<double>(traction, std::hypot(s->fields[Shot::traction_x][k],
                                                             s->fields[Shot::traction_y][k]));
            const double open = s->fields[Shot::gap][k];
            if (std::isfinite(open)) gap = std::max(gap, open);
        }
    film.largest = {pressure, traction, gap, 0};
    film.largest_pressure = in_words(pressure, "Pa");
    film.largest_traction = in_words(traction, "Pa");
    film.largest_gap = in_words(gap, "m");
    film.bytes.reserve(shots.size() * cells.size() * Film::n_fields);
    for (const Shot* s : shots) {
        const auto add = [&](const auto& value_of) {
            for (const std::size_t k : cells) film.bytes.push_back(value_of(k));
        };
        add([&](std::size_t k) { return byte(s->fields[Shot::pressure][k], pressure); });
        add([&](std::size_t k) { return signed_byte(s->fields[Shot::traction_x][k], traction); });
        add([&](std::size_t k) { return signed_byte(s->fields[Shot::traction_y][k], traction); });
        add([&](std::size_t k) { return byte(s->fields[Shot::gap][k], gap); });
        add([&](std::size_t k) { return static_cast<std::uint8_t>(s->state[k]); });
    }
}

void add_relief(const Shots& shots, const Window& window, Film& film) {
    film.relief = window.grid(*shots.front());
    double low = std::numeric_limits<double>::infinity(), high = -low;
    const auto each = [&](const auto& use) {
        for (const Shot* s : shots)
            for (int j = 0; j < window.n_y; ++j)
                for (int i = 0; i < window.n_x; ++i) {
                    // Outside of a body of elements nothing is displaced.
                    const double height = s->fields[Shot::height][window.cell(*s, i, j)];
                    use(std::isfinite(height) ? height : 0.);
                }
    };
    each([&](double h) { low = std::min(low, h), high = std::max(high, h); });
    const double range = high > low ? high - low : 1;
    each([&](double h) {
        film.heights.push_back(static_cast<std::uint16_t>(std::lround(65535 * (h - low) / range)));
    });
    film.lowest = to_um * low;
    film.highest = to_um * (low + range);
}

/// The place of `value` among increasing ones: index of the lower neighbour and the share of the
/// upper one. Outside of them: index -1.
std::pair<int, double> between(const std::vector<double>& values, double value) {
    if (value < values.front() || value > values.back()) return {-1, 0};
    const auto above = std::upper_bound(values.begin() + 1, values.end() - 1, value);
    const int i = static_cast<int>(above - values.begin()) - 1;
    return {i, (value - values[i]) / (values[i + 1] - values[i])};
}

void add_sections(const Shots& shots, Film& film) {
    constexpr double no_value = -1;
    const auto is_drawn = [](const Shot* s) {
        return s->section && s->section->x.size() > 1 && s->section->z.size() > 1;
    };
    double depth = 0;  // [mm]
    for (const Shot* s : shots)
        if (is_drawn(s)) depth = std::max(depth, -to_mm * s->section->z.front());
    if (!(depth > 0)) return;
    const double width = film.cells.n_x * film.cells.spacing_x;
    depth = std::min(depth, deepest_section * width);
    FilmGrid& grid = film.section;
    grid.n_x = section_cells;
    grid.spacing_x = width / grid.n_x;
    grid.first_x = film.cells.first_x + (grid.spacing_x - film.cells.spacing_x) / 2;
    grid.n_y = std::max(1, static_cast<int>(std::lround(depth / grid.spacing_x)));
    grid.spacing_y = depth / grid.n_y;
    grid.first_y = grid.spacing_y / 2;
    std::vector<double> values;
    double largest = 0;
    int n_sections = 0;
    for (std::size_t n = 0; n < shots.size(); ++n) {
        if (!is_drawn(shots[n])) continue;
        film.frames[n].section = n_sections++;
        const contact::Subsurface& s = *shots[n]->section;
        for (int j = 0; j < grid.n_y; ++j) {
            const auto [k, up] = between(s.z, std::min(-grid.y(j) / to_mm, s.z.back()));
            for (int i = 0; i < grid.n_x; ++i) {
                const auto [l, right] =
                    between(s.x, grid.x(i) / to_mm - shots[n]->record.offset[0]);
                double value = no_value;
                if (k >= 0 && l >= 0) {
                    const auto at = [&](int di, int dk) {
                        return contact::von_mises(s.at(l + di, k + dk));
                    };
                    value = (1 - up) * ((1 - right) * at(0, 0) + right * at(1, 0)) +
                            up * ((1 - right) * at(0, 1) + right * at(1, 1));
                }
                largest = std::max(largest, value);
                values.push_back(value);
            }
        }
    }
    film.largest[3] = largest;
    film.largest_von_mises = in_words(largest, "Pa");
    for (const double value : values)
        film.von_mises.push_back(
            value < 0 ? 0
                      : static_cast<std::uint8_t>(
                            1 + std::lround(254 * (largest > 0 ? value / largest : 0))));
}

}  // namespace

Film film_of(const Shots& shots, double direction) {
    const Touched touched(shots);
    Film film;
    if (touched.none()) return film;
    const Shot& any = *shots.front();
    const Window window = touched.fields(any);
    film.cells = window.grid(any);
    std::vector<std::size_t> cells;
    for (int j = 0; j < window.n_y; ++j)
        for (int i = 0; i < window.n_x; ++i) {
            const std::size_t k = window.cell(any, i, j);
            film.mask.push_back(touched.cells[k]);
            if (touched.cells[k]) cells.push_back(k);
        }
    for (const Shot* shot : shots) {
        const contact::StepRecord& r = shot->record;
        film.frames.push_back(
            {.label = shot->label,
             .part = shot->part,
             .phase = shot->phase,
             .x = to_mm * r.offset[0],
             .y = to_mm * r.offset[1],
             .shift = to_um * r.shift[0],
             .position = r.phase,
             .way = to_mm * (r.offset[0] * std::cos(direction) + r.offset[1] * std::sin(direction)),
             .force = r.tangential_force[0],
             .depth = to_um * r.indentation,
             .rotation = r.rotation});
    }
    add_fields(shots, cells, film);
    if (any.n_y > 1) {
        add_relief(shots, touched.relief(any), film);
        add_sections(shots, film);
    }
    return film;
}

}  // namespace tricontact::comparisons
