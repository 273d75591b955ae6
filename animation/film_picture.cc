#include "animation/film_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "animation/canvas.h"
#include "report/plot_style.h"

namespace tricontact::animation {

namespace {

using report::Film;
using Fields = std::array<std::span<const std::uint8_t>, Film::n_fields>;

// As player.js: viridis turned round, two hues about zero (Okabe and Ito), states by lightness too.
const std::vector<Colour> magnitudes{
    {253, 231, 37}, {94, 201, 98}, {33, 145, 140}, {59, 82, 139}, {68, 1, 84}};
const std::vector<Colour> signs{
    {0, 114, 178}, {160, 200, 225}, {247, 247, 247}, {240, 180, 130}, {213, 94, 0}};
Colour colour_from(const std::string& text) {  // "#rrggbb"
    const auto part = [&](int at) {
        return static_cast<unsigned char>(std::stoi(text.substr(at, 2), nullptr, 16));
    };
    return {part(1), part(3), part(5)};
}
const Colour sticks = colour_from(report::stick_colour), slips = colour_from(report::slip_colour);
constexpr Colour ink{33, 38, 43}, soft{140, 146, 152}, curve{0, 114, 178};

constexpr int width = 800, margin = 24, scale_room = 130;
constexpr double most_map_height = 560, history_height = 150, head = 74;

Colour ramp(const std::vector<Colour>& colours, double share) {
    const double place = std::clamp(share, 0., 1.) * static_cast<double>(colours.size() - 1);
    const std::size_t k = std::min(static_cast<std::size_t>(place), colours.size() - 2);
    Colour result{};
    for (int i = 0; i < 3; ++i)
        result[i] = static_cast<unsigned char>(
            std::lround(colours[k][i] +
                        (place - static_cast<double>(k)) * (colours[k + 1][i] - colours[k][i])));
    return result;
}

/// What a cell has of a field: -1 to 1 with a sign, else 0 to 1; of states the pressure.
double share_of(const Fields& f, const std::string& field, std::size_t k) {
    const double x = (f[Film::traction_x][k] - 128) / 127.,
                 y = (f[Film::traction_y][k] - 128) / 127.;
    if (field == "traction") return std::hypot(x, y);
    if (field == "traction_x") return x;
    return f[field == "gap" ? Film::gap : Film::pressure][k] / 255.;
}

std::optional<Colour> colour_of(const Fields& f, const std::string& field, std::size_t k) {
    const int state = f[Film::state][k];
    if (field == "gap") {
        if (f[Film::gap][k] == 0) return {};
        return ramp(magnitudes, share_of(f, field, k));
    }
    if (state == 0) return {};
    if (field == "state") return state == 1 ? sticks : slips;
    if (field == "traction_x") return ramp(signs, (share_of(f, field, k) + 1) / 2);
    return ramp(magnitudes, share_of(f, field, k));
}

/// Where cells and places of the film are in the picture.
struct Map {
    const Film& film;
    Box box;
    double x(double at) const {
        const auto& c = film.cells;
        return box.left + (at - c.first_x + c.spacing_x / 2) / (c.n_x * c.spacing_x) * box.width;
    }
    double y(double at) const {
        const auto& c = film.cells;
        return box.top + box.height -
               (at - c.first_y + c.spacing_y / 2) / (c.n_y * c.spacing_y) * box.height;
    }
};

Map map_of(const Film& film) {
    const auto& c = film.cells;
    Box box{margin, head, width - 2 * margin - scale_room, 0};
    box.height = c.n_y == 1 ? 320 : box.width * (c.n_y * c.spacing_y) / (c.n_x * c.spacing_x);
    if (box.height > most_map_height) {  // narrower, in the middle
        const double narrower = box.width * most_map_height / box.height;
        box.left += (box.width - narrower) / 2;
        box.width = narrower, box.height = most_map_height;
    }
    return {film, box};
}

std::vector<std::size_t> masked(const Film& film) {
    std::vector<std::size_t> cells;
    for (std::size_t k = 0; k < film.mask.size(); ++k)
        if (film.mask[k]) cells.push_back(k);
    return cells;
}

void arrow(Canvas& canvas, const Place& middle, double dx, double dy) {
    const double length = std::hypot(dx, dy);
    if (length < 2) return;
    const Place tip{middle.x + dx / 2, middle.y + dy / 2};
    canvas.stroke({{middle.x - dx / 2, middle.y - dy / 2}, tip}, 1.6, ink);
    for (const double turn : {2.6, -2.6}) {
        const double angle = std::atan2(dy, dx) + turn;
        canvas.stroke(
            {tip, {tip.x + 0.3 * length * std::cos(angle), tip.y + 0.3 * length * std::sin(angle)}},
            1.6, ink);
    }
}

void draw_surface(Canvas& canvas, const Map& map, const Fields& f, const std::string& field,
                  const Film::Frame& frame) {
    const auto& c = map.film.cells;
    const double wide = map.box.width / c.n_x, high = map.box.height / c.n_y;
    const std::vector<std::size_t> cells = masked(map.film);
    for (std::size_t k = 0; k < cells.size(); ++k)
        if (const auto colour = colour_of(f, field, k)) {
            const auto i = static_cast<double>(cells[k] % c.n_x),
                       j = static_cast<double>(cells[k] / c.n_x);
            canvas.fill({map.box.left + i * wide, map.box.top + map.box.height - (j + 1) * high,
                         wide, high},
                        *colour);
        }
    const std::size_t step = std::max(1, (std::max(c.n_x, c.n_y) + 7) / 14);
    for (std::size_t k = 0; k < cells.size(); ++k) {
        const std::size_t i = cells[k] % c.n_x, j = cells[k] / c.n_x;
        if (i % step != 0 || j % step != 0 || f[Film::state][k] == 0) continue;
        const double length = 0.9 * static_cast<double>(step) * wide / 127;
        arrow(canvas, {map.x(c.x(static_cast<int>(i))), map.y(c.y(static_cast<int>(j)))},
              length * (f[Film::traction_x][k] - 128), -length * (f[Film::traction_y][k] - 128));
    }
    std::vector<Place> circle;
    for (int n = 0; n <= 32; ++n)
        circle.push_back({map.x(frame.x) + 6 * std::cos(n * 0.19635),
                          map.y(frame.y) + 6 * std::sin(n * 0.19635)});
    canvas.stroke(circle, 2, ink);
}

/// The field as its curve, filled, over a band of stick and slip.
void draw_line(Canvas& canvas, const Map& map, const Fields& f, const std::string& field,
               const Film::Frame& frame) {
    const Box& box = map.box;
    const double band = 16, wide = box.width / map.film.cells.n_x;
    const double bottom = box.top + box.height - 2 * band;
    const double zero = field == "traction_x" ? (box.top + bottom) / 2 : bottom;
    const double high = zero - box.top - 8;
    const std::vector<std::size_t> cells = masked(map.film);
    std::vector<Place> places;
    for (std::size_t k = 0; k < cells.size(); ++k) {
        const double left = box.left + static_cast<double>(cells[k]) * wide,
                     share = share_of(f, field, k);
        if (f[Film::state][k] != 0)
            canvas.fill({left, box.top + box.height - 1.5 * band, wide, band},
                        f[Film::state][k] == 1 ? sticks : slips);
        if (const auto colour = colour_of(f, field, k))
            canvas.fill({left, std::min(zero, zero - share * high), wide, std::abs(share) * high},
                        *colour);
        places.push_back({left + wide / 2, zero - share * high});
    }
    canvas.stroke(places, 2, ink);
    canvas.stroke({{box.left, zero}, {box.left + box.width, zero}}, 1, ink);
    canvas.stroke({{map.x(frame.x), zero}, {map.x(frame.x), box.top + box.height}}, 1.5, ink);
}

void draw_scale(Canvas& canvas, const Map& map, const std::string& field) {
    const Film& film = map.film;
    const double left = width - scale_room - margin + 24, top = map.box.top;
    const bool has_states = field == "state" || film.cells.n_y == 1;
    if (has_states) {
        const double below = field == "state" ? top : top + map.box.height - 48;
        canvas.fill({left, below, 18, 18}, sticks);
        canvas.write("stick", {left + 26, below + 15}, 16);
        canvas.fill({left, below + 28, 18, 18}, slips);
        canvas.write("slip", {left + 26, below + 43}, 16);
    }
    if (field == "state") return;
    const double height = std::min(map.box.height - (has_states ? 70 : 0), 320.);
    const bool has_sign = field == "traction_x";
    const auto& colours = has_sign ? signs : magnitudes;
    constexpr int n = 128;
    for (int k = 0; k < n; ++k)
        canvas.fill({left, top + height * k / n, 18, height / n + 1},
                    ramp(colours, 1 - (k + 0.5) / n));
    canvas.frame({left, top, 18, height}, 1, soft);
    const std::string largest = field == "pressure" ? film.largest_pressure
                                : field == "gap"    ? film.largest_gap
                                                    : film.largest_traction;
    canvas.write(largest, {left + 26, top + 12}, 16);
    if (has_sign) canvas.write("0", {left + 26, top + height / 2 + 6}, 16);
    canvas.write(has_sign ? "-" + largest : "0", {left + 26, top + height}, 16);
}

/// A length of 1, 2 or 5 times a power of ten, about a fifth of the map.
void draw_length(Canvas& canvas, const Map& map) {
    const double whole = map.film.cells.n_x * map.film.cells.spacing_x;  // [mm]
    const double ten = std::pow(10, std::floor(std::log10(whole / 3)));
    double length = ten;
    for (const double factor : {2., 5.})
        if (factor * ten <= whole / 3) length = factor * ten;
    const double wide = length / whole * map.box.width, y = map.box.top + map.box.height + 16;
    canvas.stroke({{map.box.left, y}, {map.box.left + wide, y}}, 3, ink);
    canvas.write(fmt::format("{:g} mm", length), {map.box.left + wide + 10, y + 6}, 16);
}

/// Shift of all steps, and of this instant.
void draw_history(Canvas& canvas, const Film& film, const Film::Frame& frame, double top,
                  const std::string& axis) {
    const Box box{margin + 70, top, width - 2 * margin - 70, history_height - 44};
    double left = film.steps.front().position, right = left;
    double low = film.steps.front().shift, high = low;
    for (const Film::Step& s : film.steps) {
        left = std::min(left, s.position), right = std::max(right, s.position);
        low = std::min(low, s.shift), high = std::max(high, s.shift);
    }
    if (!(right > left)) left -= 1, right += 1;
    if (!(high > low)) low -= 1, high += 1;
    const auto place = [&](double position, double shift) {
        return Place{box.left + (position - left) / (right - left) * box.width,
                     box.top + box.height - (shift - low) / (high - low) * box.height};
    };
    canvas.frame(box, 1, soft);
    std::vector<Place> places;
    for (const Film::Step& s : film.steps) {
        const Place next = place(s.position, s.shift);
        // What falls onto the place before is not seen.
        if (places.empty() || std::hypot(next.x - places.back().x, next.y - places.back().y) > 0.3)
            places.push_back(next);
    }
    canvas.stroke(places, 1.8, curve);
    canvas.disc(place(frame.position, frame.shift), 5, ink);
    const auto number = [&](double value) {  // rounding beside the range is zero
        return std::abs(value) < 1e-6 * (high - low) ? "0" : fmt::format("{:.3g}", value);
    };
    canvas.write(number(high), {box.left - 8, box.top + 12}, 15, Canvas::Align::right);
    canvas.write(number(low), {box.left - 8, box.top + box.height}, 15, Canvas::Align::right);
    canvas.write("U [µm]", {margin, box.top + box.height / 2 + 5}, 15);
    const double below = box.top + box.height + 20;
    canvas.write(fmt::format("{:.4g}", left), {box.left, below}, 15, Canvas::Align::centre);
    canvas.write(fmt::format("{:.4g}", right), {box.left + box.width, below}, 15,
                 Canvas::Align::centre);
    canvas.write(axis, {box.left + box.width / 2, below}, 15, Canvas::Align::centre);
}

}  // namespace

std::string film_picture(const Film& film, std::size_t frame, const std::string& field,
                         const std::string& title, const std::string& axis) {
    const Map map = map_of(film);
    // Movies take even numbers of pixels.
    const int height =
        2 * static_cast<int>(std::lround((map.box.top + map.box.height + 52 + history_height) / 2));
    Canvas canvas(width, height);
    const Film::Frame& shown = film.frames[frame];
    const std::size_t n = static_cast<std::size_t>(std::ranges::count(film.mask, true));
    Fields fields;
    for (std::size_t k = 0; k < fields.size(); ++k)
        fields[k] = std::span(film.bytes).subspan((frame * Film::n_fields + k) * n, n);
    if (film.cells.n_y == 1)
        draw_line(canvas, map, fields, field, shown);
    else
        draw_surface(canvas, map, fields, field, shown);
    canvas.frame(map.box, 1, soft);
    draw_scale(canvas, map, field);
    draw_length(canvas, map);
    draw_history(canvas, film, shown, map.box.top + map.box.height + 44, axis);
    const std::string words = field == "traction"     ? "tangential traction"
                              : field == "traction_x" ? "tangential traction along x"
                              : field == "state"      ? "stick and slip"
                                                      : field;
    canvas.write(film.name + ": " + words, {margin, 34}, 20, Canvas::Align::left, true);
    canvas.write(shown.label, {width - margin, 34}, 20, Canvas::Align::right, true);
    canvas.write(title, {margin, 60}, 15);
    return canvas.png();
}

}  // namespace tricontact::animation
