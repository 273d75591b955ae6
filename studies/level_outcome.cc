#include "studies/level_outcome.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "comparisons/quantities/quantities.h"
#include "comparisons/quantities/results.h"

namespace tricontact::studies {

namespace {

using contact::Snapshot;
using contact::Surface;
using json = nlohmann::ordered_json;
using Field = std::vector<double> Surface::*;

constexpr const char* last_state_key = "last_state";
constexpr std::array<std::pair<const char*, Field>, 6> kept_fields{
    {{"p", &Surface::normal_traction},
     {"tx", &Surface::tangential_traction_x},
     {"ty", &Surface::tangential_traction_y},
     {"ux", &Surface::displacement_x},
     {"uy", &Surface::displacement_y},
     {"uz", &Surface::displacement_z}}};

/// To seven digits: a store of text is a third as large. What is no number becomes null.
json rounded(const std::vector<double>& values) {
    json list = json::array();
    for (const double value : values)
        list.push_back(std::isfinite(value) ? json(std::stod(fmt::format("{:.6e}", value)))
                                            : json());
    return list;
}

std::vector<double> numbers_of(const json& list) {
    std::vector<double> values;
    for (const json& value : list)
        values.push_back(value.is_null() ? std::nan("") : value.get<double>());
    return values;
}

json state_json(const Snapshot& snapshot) {
    const Surface& s = snapshot.surface;
    json state{{"phase", snapshot.phase},
               {"layout", static_cast<int>(s.layout)},
               {"counts", {s.n_x, s.n_y}},
               {"first", {s.first[0], s.first[1]}},
               {"spacing", {s.spacing[0], s.spacing[1]}},
               {"offset", {s.offset[0], s.offset[1]}},
               {"node_x", s.node_x},
               {"node_y", s.node_y},
               {"quads", s.quads}};
    for (const auto& [key, field] : kept_fields) state[key] = rounded(s.*field);
    return state;
}

Snapshot read_state(const json& state) {
    Snapshot snapshot{.phase = state.at("phase").get<double>(), .surface = {}};
    Surface& s = snapshot.surface;
    s.layout = static_cast<Surface::Layout>(state.at("layout").get<int>());
    s.n_x = state.at("counts").at(0).get<int>();
    s.n_y = state.at("counts").at(1).get<int>();
    for (int i = 0; i < 2; ++i) {
        s.first[i] = state.at("first").at(i).get<double>();
        s.spacing[i] = state.at("spacing").at(i).get<double>();
        s.offset[i] = state.at("offset").at(i).get<double>();
    }
    s.node_x = numbers_of(state.at("node_x"));
    s.node_y = numbers_of(state.at("node_y"));
    for (const json& quad : state.at("quads")) s.quads.push_back(quad.get<std::array<int, 9>>());
    for (const auto& [key, field] : kept_fields) s.*field = numbers_of(state.at(key));
    return snapshot;
}

json results_json(const contact::Case& c, const contact::History& history,
                  std::optional<double> normal_stiffness) {
    json results = comparisons::stored_results({c, history});
    if (normal_stiffness && std::isfinite(*normal_stiffness))
        results[comparisons::quantities::normal_stiffness.key] = *normal_stiffness;
    if (!history.snapshots.empty()) results[last_state_key] = state_json(history.snapshots.back());
    return results;
}

}  // namespace

std::string level_results_text(const contact::Case& c, const contact::History& history,
                               std::optional<double> normal_stiffness) {
    return results_json(c, history, normal_stiffness).dump();
}

std::string level_outcome_text(const contact::Case& c, const contact::History& history,
                               std::optional<double> normal_stiffness) {
    return json{{"results", results_json(c, history, normal_stiffness)},
                {"cpu_s", history.cpu_s},
                {"wall_s", history.wall_s}}
        .dump();
}

LevelState level_state_of(const io::PointOutcome& outcome) {
    LevelState found;
    if (!outcome.results) return found;
    const json results = json::parse(*outcome.results);
    if (results.contains(last_state_key)) found.last = read_state(results.at(last_state_key));
    const char* key = comparisons::quantities::normal_stiffness.key;
    if (results.contains(key)) found.normal_stiffness = results.at(key).get<double>();
    return found;
}

}  // namespace tricontact::studies
