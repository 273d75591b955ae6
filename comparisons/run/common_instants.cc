#include "comparisons/run/common_instants.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using report::Film;
using PlayedPart = Film::Part;
using Instant = report::Player::Instant;

constexpr double same_phase = 1e-6;  // of a period: steps are far longer, rounding far below

bool has_part(const Film& film, PlayedPart part) {
    return std::ranges::any_of(film.frames,
                               [&](const Film::Frame& frame) { return frame.part == part; });
}

/// What a film shows as this part: the first period is the last one of a run that ends with it.
PlayedPart part_played(const Film& film, PlayedPart part) {
    return part == PlayedPart::last_period && !has_part(film, part) ? PlayedPart::first_period
                                                                    : part;
}

int frame_at(const Film& film, PlayedPart part, double phase) {
    for (std::size_t k = 0; k < film.frames.size(); ++k)
        if (film.frames[k].part == part && std::abs(film.frames[k].phase - phase) < same_phase)
            return static_cast<int>(k);
    return -1;
}

std::string label_at(const std::vector<Film>& films, const std::vector<int>& frames,
                     PlayedPart part, double phase) {
    std::string label;
    bool is_one = true;
    for (std::size_t i = 0; i < films.size(); ++i) {
        if (frames[i] < 0) continue;
        const std::string& own = films[i].frames[static_cast<std::size_t>(frames[i])].label;
        is_one = is_one && (label.empty() || own == label);
        label = own;
    }
    if (is_one) return label;
    return phase > 1 - same_phase && part == PlayedPart::last_period
               ? "end of each model's last period"
               : fmt::format("each model's last period, {:.4g} of it", phase);
}

void add_part(const std::vector<Film>& films, PlayedPart part, std::vector<Instant>& instants) {
    std::vector<PlayedPart> parts;
    for (const Film& film : films) parts.push_back(part_played(film, part));
    const auto shows = [&](std::size_t i) { return has_part(films[i], parts[i]); };
    std::size_t leader = 0;
    while (leader < films.size() && !shows(leader)) ++leader;
    if (leader == films.size()) return;
    for (const Film::Frame& frame : films[leader].frames) {
        if (frame.part != parts[leader]) continue;
        std::vector<int> frames;
        bool have_all = true;
        for (std::size_t i = 0; i < films.size(); ++i) {
            frames.push_back(frame_at(films[i], parts[i], frame.phase));
            have_all = have_all && (frames[i] >= 0 || !shows(i));
        }
        if (have_all) instants.push_back({label_at(films, frames, part, frame.phase), frames});
    }
}

}  // namespace

std::vector<Instant> common_instants(const std::vector<Film>& films) {
    std::vector<Instant> instants;
    for (const PlayedPart part : {PlayedPart::pressed, PlayedPart::loaded, PlayedPart::first_period,
                                  PlayedPart::last_period, PlayedPart::path})
        if (std::ranges::any_of(films, [&](const Film& film) { return has_part(film, part); }))
            add_part(films, part, instants);
    return instants;
}

std::array<std::string, 4> largest_of(const std::vector<Film>& films) {
    constexpr const char* units[] = {"Pa", "Pa", "m", "Pa"};
    std::array<std::string, 4> words;
    for (std::size_t field = 0; field < words.size(); ++field) {
        double largest = 0;
        for (const Film& film : films) largest = std::max(largest, film.largest[field]);
        words[field] = report::quantity(largest, units[field], 3);
    }
    return words;
}

}  // namespace tricontact::comparisons
