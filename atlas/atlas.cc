#include "atlas/atlas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/base/special_values.h"
#include "io/case/case_keys.h"

namespace tricontact::atlas {

namespace {

/// In [-1, 1].
double unit_coordinate(const Axis& axis, double value) {
    const double inside = std::clamp(value, axis.range.from, axis.range.to);
    return std::clamp(2 * axis.range.fraction_of(inside) - 1, -1., 1.);
}

/// Of the quotient's fit, bar and correction there; `factor` is the closed form.
Value whole_value(const Atlas& atlas, const Map& map, double fitted, double bar, double correction,
                  double factor) {
    const double error = std::hypot(bar, atlas.safety_factor * correction);
    const double quotient = fitted + correction;
    if (!map.is_logarithmic) return {factor * quotient, std::abs(factor) * error};
    const double value = factor * std::exp(quotient);
    return {value, std::abs(value) * std::expm1(error)};
}

/// The same, if its bar is short enough.
Value value_of(const Atlas& atlas, const Map& map, double fitted, double bar, double correction,
               double factor) {
    Value v = whole_value(atlas, map, fitted, bar, correction, factor);
    if (v.error > atlas.largest_error * std::abs(v.value)) v.value = contact::undefined;
    return v;
}

}  // namespace

const Map* Atlas::find(const comparisons::Quantity& q) const {
    const auto found = std::ranges::find(maps, &q, &Map::quantity);
    return found == maps.end() ? nullptr : &*found;
}

const Axis* Atlas::axis(std::string_view key) const {
    const auto found = std::ranges::find(axes, key, &Axis::key);
    return found == axes.end() ? nullptr : &*found;
}

double Atlas::kept_value(std::string_view key) const {
    contact::Case c = kept;
    const io::CaseKey* found = io::find_key(key);
    if (!found) return contact::undefined;
    const io::Field field = io::place_of(*found, c);
    if (auto* const* value = std::get_if<double*>(&field)) return **value;
    auto* const* value = std::get_if<std::optional<double>*>(&field);
    return value && **value ? ***value : contact::undefined;
}

bool is_inside(const std::vector<Axis>& axes, std::span<const double> coordinates) {
    for (std::size_t d = 0; d < axes.size(); ++d)
        if (!axes[d].is_inside(coordinates[d])) return false;
    return true;
}

std::vector<double> unit_coordinates(const Atlas& atlas, std::span<const double> coordinates) {
    std::vector<double> unit;
    for (std::size_t d = 0; d < atlas.axes.size(); ++d)
        unit.push_back(unit_coordinate(atlas.axes[d], coordinates[d]));
    return unit;
}

Reader::Reader(const Atlas& atlas)
    : atlas_(atlas), table_(static_cast<int>(atlas.axes.size())), unit_(atlas.axes.size()) {
    for (const Map& map : atlas.maps) {
        table_.cover(map.fit.polynomial);
        table_.cover(map.fit.log_error);
        table_.cover(map.correction);
    }
}

void Reader::go_to(std::span<const double> coordinates) {
    if (coordinates.size() != atlas_.axes.size())
        throw std::invalid_argument(fmt::format("atlas {} has {} coordinates, not {}", atlas_.name,
                                                atlas_.axes.size(), coordinates.size()));
    for (std::size_t d = 0; d < unit_.size(); ++d) {
        const Axis& axis = atlas_.axes[d];
        if (!axis.is_inside(coordinates[d]))
            throw OutsideDomain(fmt::format("{} = {:.6g}: atlas {} goes from {:.6g} to {:.6g}",
                                            axis.key, coordinates[d], atlas_.name, axis.from,
                                            axis.to));
        unit_[d] = unit_coordinate(axis, coordinates[d]);
    }
    table_.set_point(unit_);
    point_ = atlas_.baseline.at(coordinates);
}

Value Reader::read(const Map& map) const {
    return value_of(atlas_, map, table_.evaluate(map.fit.polynomial),
                    statistics::error_bar(map.fit, table_), table_.evaluate(map.correction),
                    atlas_.baseline.of(*map.quantity, point_));
}

Value Reader::read_with_errors(const Map& map, std::vector<double> coordinates,
                               std::span<const double> errors) {
    go_to(coordinates);
    Value value = read(map);
    for (std::size_t d = 0; d < errors.size(); ++d) {
        if (!(errors[d] > 0)) continue;
        const io::Study::Range& range = atlas_.axes[d].range;
        const double there = coordinates[d];
        coordinates[d] += there < (range.from + range.to) / 2 ? errors[d] : -errors[d];
        go_to(coordinates);
        value.error = std::hypot(value.error, read(map).value - value.value);
        coordinates[d] = there;
    }
    return value;
}

Value said(const Atlas& atlas, const Map& map, const Value& value) {
    if (std::isnan(value.value))
        throw OutsideDomain(
            fmt::format("{}: atlas {} gives no value there: its error bar would be {:.2g}",
                        map.quantity->key, atlas.name, value.error));
    return value;
}

Value read_with_errors(const Atlas& atlas, const Map& map, std::vector<double> coordinates,
                       std::span<const double> errors) {
    return Reader(atlas).read_with_errors(map, std::move(coordinates), errors);
}

Values read_all(const Atlas& atlas, const Map& map, std::span<const double> points) {
    const std::size_t n_axes = atlas.axes.size();
    if (points.size() % n_axes != 0)
        throw std::invalid_argument(
            fmt::format("{} coordinates are no points of {} axes", points.size(), n_axes));
    const std::size_t n = points.size() / n_axes;
    std::vector<double> unit(points.size());
    std::vector<char> inside(n, 1);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Axis& axis = atlas.axes[i % n_axes];
        if (!axis.is_inside(points[i])) inside[i / n_axes] = 0;
        unit[i] = std::isnan(points[i]) ? 0 : unit_coordinate(axis, points[i]);
    }
    const std::vector<double> fitted = statistics::evaluate_all(map.fit.polynomial, unit);
    const std::vector<double> log_errors = statistics::evaluate_all(map.fit.log_error, unit);
    const std::vector<double> corrections = statistics::evaluate_all(map.correction, unit);
    const bool has_form = !atlas.baseline.name_of(*map.quantity).empty();
    Values result{std::vector<double>(n), std::vector<double>(n)};
    for (std::size_t i = 0; i < n; ++i) {
        const double factor =
            has_form && inside[i]
                ? atlas.baseline.of(*map.quantity,
                                    atlas.baseline.at(points.subspan(i * n_axes, n_axes)))
                : 1;
        const Value value = inside[i] ? value_of(atlas, map, fitted[i],
                                                 map.fit.error_factor * std::exp(log_errors[i]),
                                                 corrections[i], factor)
                                      : Value{contact::undefined, contact::undefined};
        result.values[i] = value.value;
        result.errors[i] = value.error;
    }
    return result;
}

}  // namespace tricontact::atlas
