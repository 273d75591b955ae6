#include "walking/study/walk_grid.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

#include "statistics/regression.h"
#include "walking/study/factorial_effects.h"

namespace tricontact::walking {

namespace {

constexpr std::size_t fewest_values = 8;
constexpr double no_effect = 0.99, reduction = 0.95, strong_reduction = 0.5;
// Half the vibration over z_stat up to which z counts as constant: that of the judge.
constexpr double constant_z = 0.01;

/// What regions are made of, from either reading.
struct Reading {
    double mu_e, z_min, z_max;
};

Reading reading_of(const WalkGroup& group, bool second_half) {
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
    return static_cast<std::size_t>(std::lower_bound(values.begin(), values.end(), value) -
                                    values.begin());
}

}  // namespace

std::vector<double> WalkGrid::values(double (*value)(const WalkOutcome& outcome)) const {
    std::vector<double> all;
    for (const WalkGroup* cell : cells)
        all.push_back(cell ? cell->mean(value) : std::numeric_limits<double>::quiet_NaN());
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
                          const Reading r = reading(g);
                          return (r.z_max - r.z_min) / 2 <= constant_z;
                      }),
            region_of(grid, "jumps", "z_min < 0",
                      [&](const WalkGroup& g) { return reading(g).z_min < 0; })};
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
