#include "walking/report/map_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <kainjow/mustache.hpp>
#include <span>
#include <stdexcept>
#include <tuple>

#include "contact/special_values.h"
#include "report/base64.h"
#include "report/chart_json.h"
#include "report/chart_library.h"
#include "report/format.h"
#include "report/json_number.h"
#include "report/page_templates.h"
#include "report/script_json.h"
#include "walking/report/map_page_templates.h"

namespace tricontact::walking {

namespace {

using Json = nlohmann::ordered_json;

/// What the ground of the map may show.
struct MapQuantity {
    std::string name;
    std::vector<double> values;  ///< of the cells
    double least, most;          ///< beyond them colours do not change
};

template <class Value>
MapQuantity quantity(const WalkMap& map, const std::string& name, double least, double most,
                     Value value) {
    MapQuantity result{name, {}, least, most};
    for (const WalkMapCell& cell : map.cells)
        result.values.push_back(cell.result.regime == Regime::tilting ? contact::undefined
                                                                      : value(cell.result));
    return result;
}

std::vector<MapQuantity> map_quantities(const WalkMap& map) {
    // A jump of more than a few static displacements is a high one, however high.
    constexpr double high_jump = -3;
    std::vector<MapQuantity> list{
        quantity(map, "effective friction", 0, 1, [](const auto& r) { return r.mu_e; }),
        quantity(map, "highest point, z_min over z_stat", high_jump, 1,
                 [](const auto& r) { return r.z_min_ratio; })};
    std::size_t n_spots = 0;
    for (const WalkMapCell& cell : map.cells) n_spots = std::max(n_spots, cell.result.spots.size());
    using Spot = WalkResult::Spot;
    const auto of_spots = [&](const char* name, double least, double Spot::*member) {
        for (std::size_t i = 0; i < n_spots; ++i)
            list.push_back(
                quantity(map, fmt::format("{} {}", name, i + 1), least, 1, [=](const auto& r) {
                    return i < r.spots.size() ? r.spots[i].*member : contact::undefined;
                }));
    };
    of_spots("stick time of spot", 0, &Spot::stick_time);
    of_spots("correlation of velocity and load, spot", -1, &Spot::correlation);
    return list;
}

Json json(const MapQuantity& quantity) {
    double low = quantity.most, high = quantity.least;
    for (const double value : quantity.values) {
        if (!std::isfinite(value)) continue;
        low = std::min(low, std::max(value, quantity.least));
        high = std::max(high, std::min(value, quantity.most));
    }
    return {{"name", quantity.name},
            {"values", report::numbers(quantity.values)},
            {"low", std::min(low, high)},
            {"high", std::max(low, high)}};
}

Json motions(const WalkMap& map) {
    Json values = Json::array(), words = Json::array();
    for (const WalkMapCell& cell : map.cells)
        values.push_back(static_cast<int>(motion_class(cell.result)));
    for (int i = 0; i < n_motion_classes; ++i)
        words.push_back(words_of(static_cast<MotionClass>(i)));
    return {{"name", "motion"}, {"values", values}, {"words", words}};
}

/// Friction above which the machine tilts, over the width of the map as far as its height.
Json limit(const WalkMap& map) {
    constexpr int n_points = 200;
    std::vector<double> x, y;
    const double first = map.kappa8.front(), last = map.kappa8.back();
    for (int i = 0; i < n_points; ++i) {
        const double kappa8 = first + (last - first) * i / (n_points - 1);
        const double friction = critical_friction(map, kappa8);
        x.push_back(kappa8);
        y.push_back(friction < 2 * map.friction.back() ? friction : contact::undefined);
    }
    return {{"x", report::numbers(x)}, {"y", report::numbers(y)}};
}

Json samples(const WalkMap& map, const MotionSamples& motion, double friction) {
    Json lists = Json::array();
    const Machine machine{.kappas = map.kappas, .model = map.model};
    const double load = friction * map.kappas.kappa4;
    if (motion.z.empty() || load == 0) return lists;
    const auto add = [&](std::span<const float> values, double unit) {
        std::vector<float> ratios;
        for (const float value : values) ratios.push_back(static_cast<float>(value / unit));
        const PackedSamples list = packed(ratios);
        lists.push_back({list.offset, list.scale, list.base64});
    };
    add(motion.displacement, load);
    add(motion.z, static_displacement(machine));
    add(motion.phi, map.kappas.kappa3 * load);
    add(motion.spring_force, normal_load_factor(machine) * load);
    return lists;
}

Json cells(const WalkMap& map) {
    Json list = Json::array();
    for (std::size_t i = 0; i < map.cells.size(); ++i) {
        const double kappa8 = map.kappa8[i % map.kappa8.size()];
        const double friction = map.friction[i / map.kappa8.size()];
        const WalkMapCell& cell = map.cells[i];
        const double mean =
            cell.result.regime == Regime::tilting ? contact::undefined : cell.result.mu_e;
        list.push_back({{"readings", map_readings(map, kappa8, cell.result)},
                        {"mean", report::number(mean)},
                        {"interval", cell.samples.interval},
                        {"samples", samples(map, cell.samples, friction)}});
    }
    return list;
}

/// The machine of least friction among those whose runs were long enough to tell, if there are
/// any: the first that a reader sees.
std::size_t best(const WalkMap& map) {
    const auto rank = [](const WalkMapCell& cell) {
        const WalkResult& r = cell.result;
        const bool known = r.regime != Regime::tilting && !std::isnan(r.mu_e);
        return std::tuple(!known, !r.transient_over, known ? r.mu_e : 0);
    };
    const auto found = std::min_element(
        map.cells.begin(), map.cells.end(),
        [&](const WalkMapCell& a, const WalkMapCell& b) { return rank(a) < rank(b); });
    return static_cast<std::size_t>(found - map.cells.begin());
}

const std::string dash = "–";

/// "0.427, 0.493": of all spots.
std::string of_spots(const WalkResult& result, double WalkResult::Spot::*member) {
    std::string text;
    for (const WalkResult::Spot& spot : result.spots)
        text += (text.empty() ? "" : ", ") + report::significant(spot.*member, 3);
    return text.empty() ? dash : text;
}

std::string transient(const WalkResult& result) {
    return result.transient_over ? "until t = " + report::significant(result.transient, 4)
                                 : "not over at the end: the run is too short";
}

using kainjow::mustache::data;

void check(bool right, const char* rule) {
    if (!right) throw std::invalid_argument(rule);
}

void check_map(const WalkMap& map) {
    for (const std::vector<double>* axis : {&map.kappa8, &map.friction})
        check(axis->size() >= 2 && std::adjacent_find(axis->begin(), axis->end(),
                                                      std::greater_equal()) == axis->end(),
              "an axis of the map does not increase");
    check(map.cells.size() == map.kappa8.size() * map.friction.size(),
          "the map has another number of cells than its axes say");
    for (const WalkMapCell& cell : map.cells) {
        const MotionSamples& motion = cell.samples;
        const std::size_t n = motion.z.size();
        check(motion.displacement.size() == n && motion.phi.size() == n &&
                  motion.spring_force.size() == n,
              "a machine's samples differ in number");
        check(n == 0 || motion.interval > 0, "a machine's samples have no interval");
    }
}

data pairs(const std::vector<std::pair<std::string, std::string>>& list) {
    data result{data::type::list};
    for (const auto& [name, value] : list) {
        data item{data::type::object};
        item.set("name", report::typeset(name));
        item.set("value", report::typeset(value));
        item.set("text", name);
        item.set("path", value);
        result << item;
    }
    return result;
}

}  // namespace

MotionClass motion_class(const WalkResult& result) {
    if (result.regime == Regime::tilting) return MotionClass::fallen;
    if (!result.transient_over) return MotionClass::unsettled;
    if (result.regime == Regime::steady) return MotionClass::steady;
    return result.regime == Regime::limit_cycle ? MotionClass::limit_cycle : MotionClass::chaotic;
}

std::string words_of(MotionClass motion) {
    constexpr const char* words[n_motion_classes] = {"slides steadily", "walks in a limit cycle",
                                                     "walks chaotically", "not settled yet",
                                                     "falls over"};
    return words[static_cast<int>(motion)];
}

Json map_json(const WalkMap& map) {
    Json ground = Json::array();
    const std::vector<MapQuantity> list = map_quantities(map);
    for (const MapQuantity& each : list) ground.push_back(json(each));
    ground.push_back(motions(map));
    Json curves = Json::array();
    for (const char* name : {"Δx / (μ κ_4)", "z / z_stat", "φ / (μ κ_3 κ_4)", "f_s / (μ κ_4)"})
        curves.push_back(report::chart_label(name));
    if (normal_load_factor({.kappas = map.kappas, .model = map.model}) != 1)
        curves.back() = report::chart_label("f_s / (√2 μ κ_4)");
    return {{"x", {{"name", report::chart_label("κ_8")}, {"values", map.kappa8}}},
            {"y", {{"name", "μ"}, {"values", map.friction}}},
            {"quantities", ground},
            {"limit", limit(map)},
            {"curves", curves},
            {"cells", cells(map)},
            {"start", best(map)}};
}

const std::vector<std::string>& map_reading_names() {
    static const std::vector<std::string> names{
        "motion",      "μ_e",          "period",    "z_min, z_max [z_stat]",
        "stick times", "correlations", "transient", "μ_c"};
    return names;
}

std::vector<std::string> map_readings(const WalkMap& map, double kappa8, const WalkResult& result) {
    const std::string limit = report::significant(critical_friction(map, kappa8), 4);
    const std::string motion = words_of(motion_class(result));
    if (result.regime == Regime::tilting) {
        const std::string when =
            result.tilting_time ? " at t = " + report::significant(*result.tilting_time, 4) : "";
        return {motion + when, dash, dash, dash, dash, dash, dash, limit};
    }
    return {
        motion,
        report::with_error(result.mu_e, result.mu_e_error),
        report::significant(result.period, 5),
        report::significant(result.z_min_ratio) + ", " + report::significant(result.z_max_ratio),
        of_spots(result, &WalkResult::Spot::stick_time),
        of_spots(result, &WalkResult::Spot::correlation),
        transient(result),
        limit};
}

double critical_friction(const WalkMap& map, double kappa8) {
    Machine machine{.kappas = map.kappas, .model = map.model};
    machine.kappas.kappa8 = kappa8;
    return critical_friction(machine);
}

PackedSamples packed(std::span<const float> samples) {
    if (samples.empty()) return {};
    if (!std::all_of(samples.begin(), samples.end(), [](float x) { return std::isfinite(x); }))
        throw std::invalid_argument("a sample that is not finite cannot be packed");
    const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
    constexpr double most = 32767;
    PackedSamples result;
    result.offset = (static_cast<double>(*low) + *high) / 2;
    result.scale = (static_cast<double>(*high) - *low) / (2 * most);
    std::string bytes;
    for (const double sample : samples) {
        const double whole =
            result.scale > 0 ? std::round((sample - result.offset) / result.scale) : 0;
        const auto bits =
            static_cast<std::uint16_t>(static_cast<std::int16_t>(std::clamp(whole, -most, most)));
        bytes += static_cast<char>(bits & 0xff);
        bytes += static_cast<char>(bits >> 8);
    }
    result.base64 = report::base64(bytes);
    return result;
}

std::string map_page(const WalkMap& map) {
    check_map(map);
    data readings{data::type::list};
    for (const std::string& name : map_reading_names())
        readings << data{"name", report::typeset(name)};
    data page{data::type::object};
    page.set("style", std::string(report::page_style) + report::document_style + map_page_style);
    page.set("version", map.version);
    page.set("title", map.title);
    page.set("title_html", report::typeset(map.title));
    page.set("readings", readings);
    page.set("last_x", std::to_string(map.kappa8.size() - 1));
    page.set("last_y", std::to_string(map.friction.size() - 1));
    page.set("settings", pairs(map.settings));
    page.set("has_settings", !map.settings.empty());
    page.set("files", pairs(map.files));
    page.set("command", map.command);
    page.set("has_command", !map.command.empty());
    page.set("has_origin", !map.files.empty() || !map.command.empty());
    page.set("map", report::script_json(map_json(map)));
    page.set("library", std::string(report::chart_library()));
    page.set("script", std::string(report::charts_script) + map_page_script);
    kainjow::mustache::mustache engine{map_page_template};
    if (!engine.is_valid())
        throw std::logic_error("map_page.html.mustache: " + engine.error_message());
    return engine.render(page);
}

}  // namespace tricontact::walking
