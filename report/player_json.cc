#include "report/player_json.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "report/json_number.h"
#include "report/packed.h"

namespace tricontact::report {

namespace {

using json = nlohmann::ordered_json;

std::string packed_bits(const std::vector<bool>& mask) {
    std::string bytes((mask.size() + 7) / 8, '\0');
    for (std::size_t i = 0; i < mask.size(); ++i)
        if (mask[i]) bytes[i / 8] = static_cast<char>(bytes[i / 8] | (1 << (i % 8)));
    return packed(bytes);
}

std::string packed_bytes(const std::vector<std::uint8_t>& bytes) {
    return packed({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

/// The lower byte first, as JavaScript's arrays on all machines of today.
std::string packed_words(const std::vector<std::uint16_t>& words) {
    std::string bytes;
    bytes.reserve(2 * words.size());
    for (const std::uint16_t word : words) {
        bytes.push_back(static_cast<char>(word & 255));
        bytes.push_back(static_cast<char>(word >> 8));
    }
    return packed(bytes);
}

/// More than a picture has; what is no number stays where the picture begins.
double rounded(double value) {
    return std::isfinite(value) ? to_digits(value, 7) : 0;
}

json grid_json(const FilmGrid& grid) {
    return {{"n", {grid.n_x, grid.n_y}},
            {"first", {rounded(grid.first_x), rounded(grid.first_y)}},
            {"spacing", {rounded(grid.spacing_x), rounded(grid.spacing_y)}}};
}

json frame_json(const Film::Frame& f) {
    json frame{{"label", f.label},
               {"x", rounded(f.x)},
               {"y", rounded(f.y)},
               {"shift", rounded(f.shift)},
               {"position", rounded(f.position)},
               {"way", rounded(f.way)},
               {"force", rounded(f.force)},
               {"depth", rounded(f.depth)}};
    if (f.rotation != 0) frame["rotation"] = rounded(f.rotation);
    if (f.section >= 0) frame["section"] = f.section;
    return frame;
}

json film_json(const Film& film) {
    json frames = json::array(), position = json::array(), way = json::array(),
         shift = json::array(), force = json::array();
    for (const Film::Frame& frame : film.frames) frames.push_back(frame_json(frame));
    for (const Film::Step& s : film.steps) {
        position.push_back(rounded(s.position));
        way.push_back(rounded(s.way));
        shift.push_back(rounded(s.shift));
        force.push_back(rounded(s.force));
    }
    json result{
        {"name", film.name},
        {"style", film.style},
        {"line", film.line},
        {"cells", grid_json(film.cells)},
        {"mask", packed_bits(film.mask)},
        {"largest",
         {film.largest_pressure, film.largest_traction, film.largest_gap, film.largest_von_mises}},
        {"values", {film.largest[0], film.largest[1], film.largest[2], film.largest[3]}},
        {"frames", frames},
        {"bytes", packed_bytes(film.bytes)},
        {"position", position},
        {"way", way},
        {"shift", shift},
        {"force", force}};
    if (!film.heights.empty()) {
        result["relief"] = grid_json(film.relief);
        result["relief"]["range"] = {rounded(film.lowest), rounded(film.highest)};
        result["relief"]["heights"] = packed_words(film.heights);
    }
    if (!film.von_mises.empty()) {
        result["section"] = grid_json(film.section);
        result["section"]["bytes"] = packed_bytes(film.von_mises);
    }
    return result;
}

}  // namespace

json player_json(const Player& player) {
    json films = json::array();
    for (const Film& film : player.films) films.push_back(film_json(film));
    json instants = json::array();
    for (const auto& [label, frames] : player.instants)
        instants.push_back({{"label", label}, {"frames", frames}});
    json result{{"axis", player.axis},
                {"films", films},
                {"instants", instants},
                {"largest", player.largest}};
    if (!player.body_heights.empty()) {
        result["body"] = grid_json(player.body);
        result["body"]["highest"] = rounded(player.highest_body);
        result["body"]["heights"] = packed_words(player.body_heights);
    }
    return result;
}

}  // namespace tricontact::report
