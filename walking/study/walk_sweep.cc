#include "walking/study/walk_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "contact/special_values.h"
#include "report/csv.h"
#include "report/format.h"
#include "statistics/regression.h"
#include "walking/study/factorial_effects.h"

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

}  // namespace

std::size_t WalkGroup::n_tilted() const {
    return static_cast<std::size_t>(std::count_if(points.begin(), points.end(), tilted));
}

bool WalkGroup::tilts() const {
    return n_tilted() > 0 && 2 * n_tilted() >= points.size();
}

double WalkGroup::mean(double (*value)(const WalkOutcome& outcome)) const {
    if (tilts()) return contact::undefined;
    double sum = 0, n = 0;
    for (const WalkSweep::Point* point : points) {
        if (tilted(point)) continue;
        sum += value(*point->outcome);
        ++n;
    }
    return n > 0 ? sum / n : contact::undefined;
}

report::WithError WalkGroup::mu_e() const {
    const double value = mean([](const WalkOutcome& o) { return o.result.mu_e; });
    if (std::isnan(value)) return {contact::undefined, contact::undefined};
    double squares = 0;
    int n = 0;
    for (const WalkSweep::Point* point : points) {
        if (tilted(point)) continue;
        squares += std::pow(point->outcome->result.mu_e - value, 2);
        ++n;
    }
    if (n == 1) return {value, mean([](const WalkOutcome& o) { return o.result.mu_e_error; })};
    return {value, statistics::student_t(confidence, n - 1) * std::sqrt(squares / (n - 1) / n)};
}

std::vector<std::size_t> machine_axes(const WalkSweep& sweep) {
    std::vector<std::size_t> axes;
    for (std::size_t i = 0; i < sweep.axes.size(); ++i)
        if (!sweep.axes[i].key.starts_with("start.")) axes.push_back(i);
    return axes;
}

std::vector<WalkGroup> groups_of(const WalkSweep& sweep) {
    const std::vector<std::size_t> axes = machine_axes(sweep);
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

}  // namespace tricontact::walking
