#include "walking/report/map_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <kainjow/mustache.hpp>
#include <nlohmann/json.hpp>
#include <ranges>
#include <stdexcept>
#include <tuple>

#include "contact/base/special_values.h"
#include "report/base64.h"
#include "report/chart_json.h"
#include "report/figure.h"
#include "report/format.h"
#include "report/json_number.h"
#include "report/page_templates.h"
#include "walking/report/map_page_templates.h"

namespace tricontact::walking {

namespace {

using Json = nlohmann::ordered_json;

/// What a map tells a run by: its regime, if it lasted long enough to have one.
constexpr const char* motion_words[] = {"slides steadily", "walks in a limit cycle",
                                        "walks chaotically", "not settled yet", "falls over"};

/// One of these words.
int motion_class(const WalkResult& result) {
    if (result.regime == Regime::tilting) return 4;
    if (!result.transient_over) return 3;
    return result.regime == Regime::steady ? 0 : result.regime == Regime::limit_cycle ? 1 : 2;
}

/// mu_c of the map's machine with this kappa8; its normal forces are those of its model.
double critical_friction_at(const WalkMap& map, double kappa8) {
    Machine machine = map.machine;
    machine.kappas.kappa8 = kappa8;
    return critical_friction(machine);
}

/// "0.427, 0.493": of all spots.
template <double WalkResult::Spot::*member>
std::string of_spots(const WalkResult& result) {
    if (result.spots.empty()) return "–";
    return fmt::format(
        "{}", fmt::join(result.spots | std::views::transform([](const WalkResult::Spot& spot) {
                            return report::significant(spot.*member, 3);
                        }),
                        ", "));
}

/// What the page says about a machine that stands, beside its motion and mu_c.
struct Reading {
    const char* name;
    std::string (*text)(const WalkResult& result);
};

constexpr Reading readings[] = {
    {"μ_e", [](const WalkResult& r) { return report::with_error(r.mu_e, r.mu_e_error); }},
    {"period", [](const WalkResult& r) { return report::significant(r.period, 5); }},
    {"z_min, z_max [z_stat]",
     [](const WalkResult& r) {
         return report::significant(r.z_min_ratio) + ", " + report::significant(r.z_max_ratio);
     }},
    {"stick times", of_spots<&WalkResult::Spot::stick_time>},
    {"correlations", of_spots<&WalkResult::Spot::correlation>},
    {"transient", [](const WalkResult& r) {
         return r.transient_over ? "until t = " + report::significant(r.transient, 4)
                                 : "not over at the end: the run is too short";
     }}};

std::vector<std::string> texts_of(const WalkMap& map, double kappa8, const WalkResult& result) {
    std::vector<std::string> texts{motion_words[motion_class(result)]};
    if (result.tilting_time)
        texts.front() += " at t = " + report::significant(*result.tilting_time, 4);
    for (const Reading& reading : readings)
        texts.push_back(result.regime == Regime::tilting ? "–" : reading.text(result));
    texts.push_back(report::significant(critical_friction_at(map, kappa8), 4));
    return texts;
}

/// A quantity that the ground of the map may show: beyond `least` and `most` colours do not change.
template <class Value>
Json quantity(const WalkMap& map, const std::string& name, double least, double most, Value value) {
    std::vector<double> values;
    double low = most, high = least;
    for (const WalkOutcome& cell : map.cells) {
        values.push_back(cell.result.regime == Regime::tilting ? contact::undefined
                                                               : value(cell.result));
        if (!std::isfinite(values.back())) continue;
        low = std::min(low, std::max(values.back(), least));
        high = std::max(high, std::min(values.back(), most));
    }
    return {{"name", name},
            {"values", report::numbers(values)},
            {"low", std::min(low, high)},
            {"high", std::max(low, high)}};
}

Json quantities_of(const WalkMap& map) {
    // A jump of more than a few static displacements is a high one, however high.
    constexpr double high_jump = -3;
    Json list = Json::array();
    list.push_back(quantity(map, "effective friction", 0, 1, [](const auto& r) { return r.mu_e; }));
    list.push_back(quantity(map, "highest point, z_min over z_stat", high_jump, 1,
                            [](const auto& r) { return r.z_min_ratio; }));
    std::size_t n_spots = 0;
    for (const WalkOutcome& cell : map.cells) n_spots = std::max(n_spots, cell.result.spots.size());
    using Spot = WalkResult::Spot;
    const auto add_spots = [&](const char* name, double least, double Spot::*member) {
        for (std::size_t i = 0; i < n_spots; ++i)
            list.push_back(
                quantity(map, fmt::format("{} {}", name, i + 1), least, 1, [=](const auto& r) {
                    return i < r.spots.size() ? r.spots[i].*member : contact::undefined;
                }));
    };
    add_spots("stick time of spot", 0, &Spot::stick_time);
    add_spots("correlation of velocity and load, spot", -1, &Spot::correlation);
    list.push_back(
        {{"name", "motion"},
         {"values",
          report::list_of(map.cells, [](const auto& c) { return motion_class(c.result); })},
         {"words", motion_words}});
    return list;
}

/// Friction above which the machine tilts, over the width of the map as far as its height.
Json limit(const WalkMap& map) {
    report::Curve curve;
    curve.sample(map.kappa8.front(), map.kappa8.back(), 199, [&](double kappa8) {
        const double friction = critical_friction_at(map, kappa8);
        return friction < 2 * map.friction.back() ? friction : contact::undefined;
    });
    return {{"x", report::numbers(curve.x)}, {"y", report::numbers(curve.y)}};
}

Json samples(const WalkMap& map, const MotionSamples& motion, double friction) {
    Json lists = Json::array();
    const double load = friction * map.machine.kappas.kappa4;
    if (motion.z.empty() || load == 0) return lists;
    const auto add = [&](std::span<const float> values, double unit) {
        std::vector<float> ratios;
        for (const float value : values) ratios.push_back(static_cast<float>(value / unit));
        const PackedSamples list = packed(ratios);
        lists.push_back({list.offset, list.scale, list.base64});
    };
    add(motion.displacement, load);
    add(motion.z, static_displacement(map.machine));
    add(motion.phi, map.machine.kappas.kappa3 * load);
    add(motion.spring_force, normal_load_factor(map.machine) * load);
    return lists;
}

Json cells(const WalkMap& map) {
    Json list = Json::array();
    for (std::size_t i = 0; i < map.cells.size(); ++i) {
        const double kappa8 = map.kappa8[i % map.kappa8.size()];
        const double friction = map.friction[i / map.kappa8.size()];
        const WalkOutcome& cell = map.cells[i];
        const double mean =
            cell.result.regime == Regime::tilting ? contact::undefined : cell.result.mu_e;
        list.push_back({{"readings", texts_of(map, kappa8, cell.result)},
                        {"mean", report::number(mean)},
                        {"interval", cell.samples.interval},
                        {"samples", samples(map, cell.samples, friction)}});
    }
    return list;
}

/// The machine of least friction among those whose runs were long enough to tell, if there are
/// any: the first that a reader sees.
std::size_t best(const WalkMap& map) {
    const auto rank = [](const WalkOutcome& cell) {
        const WalkResult& r = cell.result;
        const bool known = r.regime != Regime::tilting && !std::isnan(r.mu_e);
        return std::tuple(!known, !r.transient_over, known ? r.mu_e : 0);
    };
    return static_cast<std::size_t>(std::ranges::min_element(map.cells, {}, rank) -
                                    map.cells.begin());
}

using kainjow::mustache::data;

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

Json map_json(const WalkMap& map) {
    Json curves = Json::array();
    const char* force =
        map.machine.model == Machine::Model::prism ? "f_s / (√2 μ κ_4)" : "f_s / (μ κ_4)";
    for (const char* name : {"Δx / (μ κ_4)", "z / z_stat", "φ / (μ κ_3 κ_4)", force})
        curves.push_back(report::chart_label(name));
    return {{"x", {{"name", report::chart_label("κ_8")}, {"values", map.kappa8}}},
            {"y", {{"name", "μ"}, {"values", map.friction}}},
            {"quantities", quantities_of(map)},
            {"limit", limit(map)},
            {"curves", curves},
            {"cells", cells(map)},
            {"start", best(map)}};
}

PackedSamples packed(std::span<const float> samples) {
    if (samples.empty()) return {};
    if (!std::ranges::all_of(samples, [](float x) { return std::isfinite(x); }))
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
    data names{data::type::list};
    const auto add = [&](const char* name) { names << data{"name", report::typeset(name)}; };
    add("motion");
    for (const Reading& reading : readings) add(reading.name);
    add("μ_c");
    data page{data::type::object};
    page.set("style", std::string(report::page_style) + report::document_style +
                          report::marked_map_style + map_page_style);
    page.set("version", map.version);
    page.set("title", map.title);
    page.set("title_html", report::typeset(map.title));
    page.set("readings", names);
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
    page.set("script", report::charts_script() + report::marked_map_script + map_page_script);
    kainjow::mustache::mustache engine{map_page_template};
    if (!engine.is_valid())
        throw std::logic_error("map_page.html.mustache: " + engine.error_message());
    return engine.render(page);
}

}  // namespace tricontact::walking
