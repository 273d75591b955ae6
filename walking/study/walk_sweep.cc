#include "walking/study/walk_sweep.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "contact/base/special_values.h"
#include "report/csv.h"
#include "report/format.h"
#include "statistics/estimate.h"

namespace tricontact::walking {

namespace {

bool tilted(const WalkSweep::Point* point) {
    return point->outcome->result.regime == Regime::tilting;
}

std::string text_of(const report::Cell& value) {
    const auto* number = std::get_if<double>(&value);
    return number ? report::csv_field(*number) : std::get<std::string>(value);
}

constexpr std::pair<const char*, const char*> symbols[] = {
    {"machine.kappa5", "μ"},
    {"machine.friction_coefficient", "μ"},
    {"machine.height_ratio", "κ_8"},
    {"machine.base_velocity", "v_0"},
    {"start.x", "x(0)"},
    {"start.z", "z(0)"},
    {"start.phi", "φ(0)"},
    {"start.base", "x_s(0)"},
    {"start.x_velocity", "x'(0)"},
    {"start.z_velocity", "z'(0)"},
    {"start.phi_velocity", "φ'(0)"},
};

/// Largest magnitude of an axis, for its unit.
double magnitude(const WalkSweep& sweep, std::size_t axis) {
    double largest = 0;
    for (const WalkSweep::Point& point : sweep.points)
        if (const auto* value = std::get_if<double>(&point.values[axis]))
            largest = std::max(largest, std::abs(*value));
    return largest;
}

report::Unit unit_of(const WalkSweep& sweep, std::size_t axis) {
    const std::string& base = sweep.axes[axis].unit;
    return base.empty() ? report::Unit{} : report::fitting_unit(magnitude(sweep, axis), base);
}

constexpr std::size_t fewest_values = 8;
constexpr double no_effect = 0.99, reduction = 0.95, strong_reduction = 0.5;
// Half the vibration over z_stat up to which z counts as constant: that of the judge.
constexpr double constant_z = 0.01;

/// What regions are made of, from either reading.
WalkOutcome::SecondHalf reading_of(const WalkGroup& group, bool second_half) {
    if (second_half)
        return {group.mean([](const WalkOutcome& o) { return o.second_half.mu_e; }),
                group.mean([](const WalkOutcome& o) { return o.second_half.z_min_ratio; }),
                group.mean([](const WalkOutcome& o) { return o.second_half.z_max_ratio; })};
    return {group.mean([](const WalkOutcome& o) { return o.result.mu_e; }),
            group.mean([](const WalkOutcome& o) { return o.result.z_min_ratio; }),
            group.mean([](const WalkOutcome& o) { return o.result.z_max_ratio; })};
}

using Belongs = std::function<bool(const WalkGroup& group)>;

Region region_of(const WalkGrid& grid, const std::string& name, const std::string& definition,
                 const Belongs& belongs) {
    std::vector<int> inside;  // -1: no result
    double n = 0, n_inside = 0;
    for (const WalkGroup* cell : grid.cells) {
        inside.push_back(cell ? belongs(*cell) : -1);
        n += cell != nullptr;
        n_inside += inside.back() == 1;
    }
    // A boundary that crosses a row does so once per crossing; columns would count it twice.
    double n_rows = 0, n_columns = 0;
    for (std::size_t i = 0; i < inside.size(); ++i) {
        const bool last = (i + 1) % grid.x.size() == 0;
        n_rows += !last && inside[i] + inside[i + 1] == 1;
        n_columns +=
            i + grid.x.size() < inside.size() && inside[i] + inside[i + grid.x.size()] == 1;
    }
    const double n_crossings = std::max(n_rows, n_columns);
    const double deviation = std::sqrt(n_crossings / 12);  // of even distributions, one cell wide
    return {name, definition, n_inside / n,
            statistics::normal_quantile(confidence) * deviation / n};
}

std::vector<double> values_of(const WalkSweep& sweep, const std::vector<WalkGroup>& groups,
                              std::size_t axis, std::size_t place) {
    std::set<double> values;
    for (const WalkGroup& group : groups) {
        const double value = shown_value(sweep, axis, group.values[place]);
        if (std::isnan(value)) return {};
        values.insert(value);
    }
    return {values.begin(), values.end()};
}

std::size_t place_of(const std::vector<double>& values, double value) {
    return static_cast<std::size_t>(std::ranges::lower_bound(values, value) - values.begin());
}

}  // namespace

report::WithError mean_of(const std::vector<double>& values) {
    const auto n = static_cast<int>(values.size());
    if (n < 2) return {n == 1 ? values.front() : contact::undefined, contact::undefined};
    const statistics::Estimate mean = statistics::mean_of(values, confidence);
    return {mean.value, statistics::student_t(confidence, n - 1) * mean.standard_error};
}

std::size_t WalkGroup::n_tilted() const {
    return static_cast<std::size_t>(std::ranges::count_if(points, tilted));
}

bool WalkGroup::tilts() const {
    return n_tilted() > 0 && 2 * n_tilted() >= points.size();
}

std::vector<double> WalkGroup::values_of(double (*value)(const WalkOutcome& outcome)) const {
    std::vector<double> all;
    if (tilts()) return all;
    for (const WalkSweep::Point* point : points)
        if (!tilted(point)) all.push_back(value(*point->outcome));
    return all;
}

double WalkGroup::mean(double (*value)(const WalkOutcome& outcome)) const {
    return mean_of(values_of(value)).value;
}

report::WithError WalkGroup::mu_e() const {
    const std::vector<double> all = values_of([](const WalkOutcome& o) { return o.result.mu_e; });
    report::WithError friction = mean_of(all);
    if (all.size() == 1)
        friction.error = mean([](const WalkOutcome& o) { return o.result.mu_e_error; });
    return friction;
}

std::vector<std::size_t> machine_axes(const WalkSweep& sweep) {
    std::vector<std::size_t> axes;
    for (std::size_t i = 0; i < sweep.axes.size(); ++i)
        if (!sweep.axes[i].key.starts_with("start.")) axes.push_back(i);
    return axes;
}

std::vector<WalkGroup> groups_over(const WalkSweep& sweep, const std::vector<std::size_t>& axes) {
    std::vector<WalkGroup> groups;
    std::map<std::vector<std::string>, std::size_t> known;
    for (const WalkSweep::Point& point : sweep.points) {
        if (!point.outcome) continue;
        std::vector<std::string> texts;
        for (const std::size_t axis : axes) texts.push_back(text_of(point.values[axis]));
        const auto [at, is_new] = known.emplace(texts, groups.size());
        if (is_new) {
            WalkGroup& group = groups.emplace_back();
            for (const std::size_t axis : axes) group.values.push_back(point.values[axis]);
        }
        groups[at->second].points.push_back(&point);
    }
    return groups;
}

std::vector<WalkGroup> groups_of(const WalkSweep& sweep) {
    return groups_over(sweep, machine_axes(sweep));
}

std::string label_of(const WalkSweep& sweep, std::size_t axis) {
    const std::string& key = sweep.axes[axis].key;
    const std::string name = key.substr(key.find('.') + 1);
    std::string label = name.starts_with("kappa") ? "κ_" + name.substr(5) : name;
    for (const auto& [full, symbol] : symbols)
        if (key == full) label = symbol;
    const report::Unit unit = unit_of(sweep, axis);
    return unit.symbol.empty() ? label : label + " [" + unit.symbol + "]";
}

double shown_value(const WalkSweep& sweep, std::size_t axis, const report::Cell& value) {
    const auto* number = std::get_if<double>(&value);
    return number ? *number / unit_of(sweep, axis).factor : contact::undefined;
}

report::Cell shown_cell(const WalkSweep& sweep, std::size_t axis, const report::Cell& value) {
    if (!std::holds_alternative<double>(value)) return value;
    return shown_value(sweep, axis, value);
}

std::vector<double> WalkGrid::values(double (*value)(const WalkOutcome& outcome)) const {
    std::vector<double> all;
    for (const WalkGroup* cell : cells)
        all.push_back(cell ? cell->mean(value) : contact::undefined);
    return all;
}

std::optional<WalkGrid> grid_of(const WalkSweep& sweep, const std::vector<WalkGroup>& groups) {
    const std::vector<std::size_t> axes = machine_axes(sweep);
    if (axes.size() != 2) return {};
    WalkGrid grid{.x_axis = axes[0],
                  .y_axis = axes[1],
                  .x = values_of(sweep, groups, axes[0], 0),
                  .y = values_of(sweep, groups, axes[1], 1),
                  .cells = {}};
    const std::size_t n = grid.x.size() * grid.y.size();
    // A sample has as many values of each axis as points, and no grid.
    if (grid.x.size() < fewest_values || grid.y.size() < fewest_values || 2 * groups.size() < n)
        return {};
    grid.cells.resize(n);
    for (const WalkGroup& group : groups)
        grid.cells[place_of(grid.x, shown_value(sweep, axes[0], group.values[0])) +
                   grid.x.size() * place_of(grid.y, shown_value(sweep, axes[1], group.values[1]))] =
            &group;
    return grid;
}

std::vector<Region> regions_of(const WalkGrid& grid, bool second_half) {
    const auto reading = [second_half](const WalkGroup& g) { return reading_of(g, second_half); };
    return {region_of(grid, "critical", "tilts", [](const WalkGroup& g) { return g.tilts(); }),
            region_of(grid, "no effect", "μ_e > 0.99",
                      [&](const WalkGroup& g) { return reading(g).mu_e > no_effect; }),
            region_of(grid, "reduction", "μ_e < 0.95",
                      [&](const WalkGroup& g) { return reading(g).mu_e < reduction; }),
            region_of(grid, "strong reduction", "μ_e < 0.5",
                      [&](const WalkGroup& g) { return reading(g).mu_e < strong_reduction; }),
            region_of(grid, "constant z", "z vibrates by at most 0.01 z_stat",
                      [&](const WalkGroup& g) {
                          const auto r = reading(g);
                          return (r.z_max_ratio - r.z_min_ratio) / 2 <= constant_z;
                      }),
            region_of(grid, "jumps", "z_min < 0",
                      [&](const WalkGroup& g) { return reading(g).z_min_ratio < 0; })};
}

TiltingAgreement tilting_agreement(const WalkGrid& grid) {
    TiltingAgreement agreement;
    for (const WalkGroup* cell : grid.cells) {
        if (!cell) continue;
        ++agreement.n_cells;
        const Machine& machine = cell->machine();
        agreement.n_agreeing +=
            cell->tilts() == (machine.kappas.kappa5 > critical_friction(machine));
    }
    return agreement;
}

}  // namespace tricontact::walking
