#include "experiments/identification/estimation/free_parameter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/format.h"

namespace tricontact::experiments {

namespace {

// Around the guess of E, and of mu over the least one: whatever lies beyond cannot be told.
constexpr double widest_young = 1e3, widest_friction = 1e3;
constexpr double bound_margin = 1e-6;
constexpr int usual_digits = 3;

std::string text_of(const FreeParameter& p, double v, int digits) {
    return p.unit.empty() ? report::significant(v, digits) : report::quantity(v, p.unit, digits);
}

}  // namespace

double FreeParameter::coordinate(double v) const {
    switch (scale) {
        case Scale::logarithmic:
            return std::log(v);
        case Scale::reciprocal:
            return low / v;
        case Scale::either_sign:
        case Scale::from_zero:
            return v / size;
        case Scale::linear:
            break;
    }
    return v;
}

double FreeParameter::value(double x) const {
    switch (scale) {
        case Scale::logarithmic:
            return std::exp(x);
        case Scale::reciprocal:
            return low / x;
        case Scale::either_sign:
        case Scale::from_zero:
            return x * size;
        case Scale::linear:
            break;
    }
    return x;
}

double FreeParameter::slope(double v) const {
    switch (scale) {
        case Scale::logarithmic:
            return 1;
        case Scale::reciprocal:
            return -low / v;
        case Scale::either_sign:
        case Scale::from_zero:
            return 1;
        case Scale::linear:
            break;
    }
    return v;
}

double FreeParameter::unit_of_change(double v) const {
    return is_sized() ? size : v;
}

double FreeParameter::change(double from, double to) const {
    return is_sized() ? (to - from) / size : std::log(to / from);
}

double FreeParameter::changed(double from, double change) const {
    return is_sized() ? from + size * change : from * std::exp(change);
}

double FreeParameter::least() const {
    return std::min(coordinate(low), coordinate(high));
}

double FreeParameter::largest() const {
    return std::max(coordinate(low), coordinate(high));
}

bool FreeParameter::has_range() const {
    if (!(low < high)) return false;
    if (is_sized()) return size > 0;
    return scale == Scale::linear ? low >= 0 : low > 0;
}

bool FreeParameter::is_at_bound(double v) const {
    const double x = coordinate(v), margin = bound_margin * (largest() - least());
    return x < least() + margin || x > largest() - margin;
}

std::string FreeParameter::shown(double v) const {
    return text_of(*this, v, usual_digits);
}

std::string FreeParameter::shown(double v, double low, double high) const {
    // The first digit of the interval's half width is shown.
    constexpr int most = 8;
    const double ratio = (high - low) / 2 / std::max(std::abs(low), std::abs(high));
    const int digits =
        ratio > 0 && std::isfinite(ratio)
            ? std::clamp(1 - static_cast<int>(std::floor(std::log10(ratio))), usual_digits, most)
            : usual_digits;
    return fmt::format("{} ({} to {})", text_of(*this, v, digits), text_of(*this, low, digits),
                       text_of(*this, high, digits));
}

FreeParameter young_parameter(double start) {
    return {.key = "substrate.young",
            .name = "young_Pa",
            .symbol = "E",
            .unit = "Pa",
            .low = start / widest_young,
            .high = start * widest_young,
            .start = start};
}

FreeParameter friction_parameter(double largest_force_ratio) {
    return {.key = "friction.coefficient",
            .name = "friction_coefficient",
            .symbol = "mu",
            .scale = FreeParameter::Scale::reciprocal,
            .low = largest_force_ratio,
            .high = largest_force_ratio * widest_friction,
            .start = 1.5 * largest_force_ratio};
}

std::vector<double> coordinates_of(const std::vector<FreeParameter>& parameters,
                                   const std::vector<double>& values) {
    std::vector<double> x;
    for (std::size_t k = 0; k < values.size(); ++k)
        x.push_back(parameters[k].coordinate(values[k]));
    return x;
}

std::vector<double> values_of(const std::vector<FreeParameter>& parameters,
                              const std::vector<double>& coordinates) {
    std::vector<double> values;
    for (std::size_t k = 0; k < coordinates.size(); ++k)
        values.push_back(parameters[k].value(coordinates[k]));
    return values;
}

}  // namespace tricontact::experiments
