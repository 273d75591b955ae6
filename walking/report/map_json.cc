#include "walking/report/map_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>

#include "contact/special_values.h"
#include "report/chart_json.h"
#include "report/format.h"
#include "report/json_number.h"
#include "walking/study/motion_class.h"

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

}  // namespace

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

}  // namespace tricontact::walking
