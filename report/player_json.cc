#include "report/player_json.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "report/base64.h"

namespace tricontact::report {

namespace {

using json = nlohmann::ordered_json;

std::string packed(const std::vector<bool>& mask) {
    std::string bytes((mask.size() + 7) / 8, '\0');
    for (std::size_t i = 0; i < mask.size(); ++i)
        if (mask[i]) bytes[i / 8] = static_cast<char>(bytes[i / 8] | (1 << (i % 8)));
    return base64(bytes);
}

/// To seven digits: more than a picture has.
double rounded(double value) {
    return std::isfinite(value) ? std::stod(fmt::format("{:.7g}", value)) : 0;
}

json film_json(const Film& film) {
    json frames = json::array(), position = json::array(), way = json::array(),
         shift = json::array();
    for (const Film::Frame& f : film.frames)
        frames.push_back({{"label", f.label},
                          {"x", rounded(f.x)},
                          {"y", rounded(f.y)},
                          {"shift", rounded(f.shift)},
                          {"position", rounded(f.position)},
                          {"way", rounded(f.way)}});
    for (const Film::Step& s : film.steps) {
        position.push_back(rounded(s.position));
        way.push_back(rounded(s.way));
        shift.push_back(rounded(s.shift));
    }
    return {
        {"name", film.name},
        {"style", film.style},
        {"n", {film.n_x, film.n_y}},
        {"first", {rounded(film.first_x), rounded(film.first_y)}},
        {"spacing", {rounded(film.spacing_x), rounded(film.spacing_y)}},
        {"mask", packed(film.mask)},
        {"largest", {film.largest_pressure, film.largest_traction, film.largest_gap}},
        {"frames", frames},
        {"bytes", base64({reinterpret_cast<const char*>(film.bytes.data()), film.bytes.size()})},
        {"position", position},
        {"way", way},
        {"shift", shift}};
}

}  // namespace

json player_json(const Player& player) {
    json films = json::array();
    for (const Film& film : player.films) films.push_back(film_json(film));
    return {{"axis", player.axis}, {"films", films}};
}

}  // namespace tricontact::report
