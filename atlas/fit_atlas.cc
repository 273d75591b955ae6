#include "atlas/fit_atlas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/base/error.h"

namespace tricontact::atlas {

namespace {

using comparisons::Quantity;
using comparisons::Results;

/// Largest over least value of what is fitted by its logarithm, all errors being relative: what
/// falls further has a zero somewhere, near which its own size is no measure.
constexpr double widest_spread = 100;

/// The closed form that a quantity with a unit is a multiple of; that of the baseline else.
std::optional<double> closed_form(const Atlas& atlas, const Quantity& q, const Sample& sample) {
    if (*q.unit == '\0') return atlas.baseline.of(q, atlas.baseline.at(sample.coordinates));
    return q.exact ? comparisons::number_of(q.exact(comparisons::reference(sample.c)))
                   : std::nullopt;
}

/// Points of [-1, 1]^n and what a polynomial is fitted to there.
struct Table {
    std::vector<double> points, values, corrections;
};

/// What the coarser runs say is missing to the finest one's fitted value.
double correction(const Atlas& atlas, const Quantity& q, const Sample& sample, double finest,
                  bool is_logarithmic) {
    double sum = 0;
    for (const Sample::Coarser& one : sample.coarser)
        if (const auto coarser = fitted_value(atlas, q, sample, one.results, is_logarithmic))
            sum += one.factor * (finest - *coarser);
    return sum;
}

Table table_of(const Atlas& atlas, const Quantity& q, const std::vector<Sample>& samples,
               bool is_logarithmic) {
    Table table;
    for (const Sample& sample : samples) {
        const auto finest = fitted_value(atlas, q, sample, sample.finest, is_logarithmic);
        if (!finest) continue;
        const std::vector<double> x = unit_coordinates(atlas, sample.coordinates);
        table.points.insert(table.points.end(), x.begin(), x.end());
        table.values.push_back(*finest);
        table.corrections.push_back(correction(atlas, q, sample, *finest, is_logarithmic));
    }
    return table;
}

bool is_constant(const std::vector<double>& values) {
    return std::ranges::all_of(values, [&](double v) { return v == values.front(); });
}

statistics::PolynomialFit fit_of(const Table& table, const std::vector<double>& values, int n) {
    if (!is_constant(values)) return statistics::fit_polynomial(table.points, values, n);
    const std::vector<std::uint8_t> zeros(static_cast<std::size_t>(n), 0);
    return {.polynomial = {n, zeros, {values.front()}},
            .log_error = {n, zeros, {0.}},
            .error_factor = 0};
}

/// Of the product of the ranges, what lies between the ends.
double share_of_ranges(const std::vector<Axis>& axes) {
    double share = 1;
    for (const Axis& axis : axes)
        share *= (axis.to - axis.from) / (axis.range.to - axis.range.from);
    return share;
}

/// The next sample inwards of `at` becomes the end; none if there is none.
std::optional<std::vector<Axis>> cut_off(std::vector<Axis> axes, std::size_t d, bool is_upper,
                                         double at, const std::vector<const Sample*>& defined) {
    std::vector<double> kept;
    for (const Sample* one : defined)
        if (const double x = one->coordinates[d];
            is_upper ? x < at - axes[d].tolerance() : x > at + axes[d].tolerance())
            kept.push_back(x);
    if (kept.empty()) return {};
    (is_upper ? axes[d].to : axes[d].from) =
        is_upper ? std::ranges::max(kept) : std::ranges::min(kept);
    return axes;
}

}  // namespace

std::optional<double> fitted_value(const Atlas& atlas, const Quantity& q, const Sample& sample,
                                   const Results& results, bool is_logarithmic) {
    const auto value = results.number(q);
    const auto form = closed_form(atlas, q, sample);
    if (!value || !form || !(std::abs(*form) > 0)) return {};
    const double quotient = *value / *form;
    if (!is_logarithmic) return quotient;
    return quotient > 0 ? std::optional(std::log(quotient)) : std::nullopt;
}

std::optional<double> extrapolated_value(const Atlas& atlas, const Quantity& q,
                                         const Sample& sample) {
    auto value = fitted_value(atlas, q, sample, sample.finest, false);
    if (!value) return {};
    *value += correction(atlas, q, sample, *value, false);
    return *q.unit ? *value : *value * atlas.baseline.of(q, atlas.baseline.at(sample.coordinates));
}

Map fit_map(const Atlas& atlas, const Quantity& q, const std::vector<Sample>& samples) {
    const int n = static_cast<int>(atlas.axes.size());
    Map map{.quantity = &q, .correction = {.n_variables = n}};
    Table table = table_of(atlas, q, samples, false);
    if (table.values.size() < statistics::least_points(n))
        throw contact::InputError(fmt::format(
            "{} is defined at {} of {} points, and {} are needed; {}", q.key, table.values.size(),
            samples.size(), statistics::least_points(n),
            *q.unit && !q.exact ? "it has a unit and no closed form: take the ratio of it"
                                : "change the ranges, take more points, or omit it"));
    const auto [least, most] = std::ranges::minmax(table.values);
    map.is_logarithmic = least > 0 && most < widest_spread * least;
    if (map.is_logarithmic) table = table_of(atlas, q, samples, true);
    map.n_points = table.values.size();
    map.fit = fit_of(table, table.values, n);
    if (!is_constant(table.corrections))
        map.correction = fit_of(table, table.corrections, n).polynomial;
    return map;
}

void cut_domain(Atlas& atlas, const std::vector<Sample>& samples) {
    constexpr double most_lost = .2;
    // Rigs work near their limit of load; that of the amplitude is of the author's choice.
    constexpr double load_weight = 2;
    std::vector<const Sample*> defined, undefined;
    for (const Sample& sample : samples) {
        const bool is_whole = std::ranges::all_of(atlas.maps, [&](const Map& map) {
            return sample.finest.number(*map.quantity).has_value();
        });
        (is_whole ? defined : undefined).push_back(&sample);
    }
    std::vector<Axis> axes = atlas.axes;
    for (const Sample* bad : undefined) {
        if (!is_inside(axes, bad->coordinates)) continue;
        double least_cost = std::numeric_limits<double>::infinity();
        std::vector<Axis> best = axes;
        for (std::size_t d = 0; d < axes.size(); ++d) {
            const bool is_load = axes[d].key.starts_with("load.");
            if (!is_load && axes[d].key != "rolling.amplitude_ratio") continue;
            for (const bool is_upper : {true, false}) {
                const auto cut = cut_off(axes, d, is_upper, bad->coordinates[d], defined);
                if (!cut) continue;
                const double lost = share_of_ranges(axes) - share_of_ranges(*cut);
                const double cost = is_load ? load_weight * lost : lost;
                if (cost >= least_cost) continue;
                least_cost = cost;
                best = *cut;
            }
        }
        axes = best;
        std::erase_if(defined,
                      [&](const Sample* one) { return !is_inside(axes, one->coordinates); });
    }
    if (share_of_ranges(axes) >= 1 - most_lost) atlas.axes = axes;
}

double typical_error(const Map& map, const std::vector<Sample>& samples, const Atlas& atlas) {
    statistics::ChebyshevTable chebyshev(static_cast<int>(atlas.axes.size()));
    chebyshev.cover(map.fit.log_error);
    chebyshev.cover(map.correction);
    std::vector<double> errors;
    double squares = 0;
    for (const Sample& sample : samples) {
        const auto value =
            fitted_value(atlas, *map.quantity, sample, sample.finest, map.is_logarithmic);
        if (!value) continue;
        chebyshev.set_point(unit_coordinates(atlas, sample.coordinates));
        errors.push_back(std::hypot(statistics::error_bar(map.fit, chebyshev),
                                    atlas.safety_factor * chebyshev.evaluate(map.correction)));
        squares += *value * *value;
    }
    const auto n = static_cast<double>(errors.size());
    const auto place = errors.begin() + static_cast<std::ptrdiff_t>(0.95 * (n - 1));
    std::ranges::nth_element(errors, place);
    return map.is_logarithmic ? std::expm1(*place) : *place / std::sqrt(squares / n);
}

}  // namespace tricontact::atlas
