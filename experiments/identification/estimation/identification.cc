#include "experiments/identification/estimation/identification.h"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "contact/base/error.h"
#include "contact/base/interruption.h"
#include "contact/base/root.h"
#include "contact/base/special_values.h"
#include "experiments/identification/estimation/best_sum_of_squares.h"
#include "experiments/identification/estimation/residual_checks.h"
#include "statistics/regression.h"

namespace tricontact::experiments {

namespace {

/// R^2; undefined where the observed values do not vary.
double determination(double sum_of_squares, double about_mean) {
    return about_mean > 0 ? 1 - sum_of_squares / about_mean : contact::undefined;
}

// First step from the best value when an edge of an interval is looked for: of the linearised half
// width, else of the coordinate; and its growth.
constexpr double first_part = .7, first_step = 1e-4, step_growth = 1.6;
// An edge to 1e-7 of the interval: far below any error of it.
constexpr int edge_bits = 24;
// Figures show a profile beyond the edges of its interval, by this part of it.
constexpr double profile_margin = 0.3;
constexpr double widest_profile = 10;  // in best values, where an interval is open

/// By how much a sum of squares exceeds the least one with n parameters held. `degrees` of the
/// errors' estimate: infinite for known ones.
double excess(double confidence, int n_held, double degrees) {
    if (std::isinf(degrees)) return gsl_cdf_chisq_Pinv(confidence, n_held);
    return n_held * gsl_cdf_fdist_Pinv(confidence, n_held, degrees);
}

double quantile(double confidence, double degrees) {
    return std::sqrt(excess(confidence, 1, degrees));
}

/// What an open end of an interval is.
double open_end(const FreeParameter& p, bool upwards) {
    if (p.scale == FreeParameter::Scale::either_sign)
        return upwards ? contact::infinity : -contact::infinity;
    const bool is_wide = p.scale == FreeParameter::Scale::logarithmic;
    if (p.scale == FreeParameter::Scale::from_zero)
        return upwards ? (p.high > widest_profile * p.size ? contact::infinity : p.high) : p.low;
    if (upwards)
        return is_wide || p.scale == FreeParameter::Scale::reciprocal ? contact::infinity : p.high;
    return is_wide ? 0 : p.low;
}

/// Another parameter than the k-th is as far from its start as is looked at.
bool is_cut_off(const std::vector<FreeParameter>& parameters, std::size_t k,
                const std::vector<double>& x) {
    for (std::size_t other = 0; other < x.size(); ++other)
        if (other != k && parameters[other].scale == FreeParameter::Scale::logarithmic &&
            parameters[other].is_at_bound(parameters[other].value(x[other])))
            return true;
    return false;
}

/// The value where the profile of a parameter leaves a level, upwards or downwards in value; open
/// where only the range of another one ends it.
double edge(const BestSumOfSquares& squares, const std::vector<FreeParameter>& parameters,
            std::size_t k, const statistics::BoundedFit& best, double level, double start_step,
            bool upwards) {
    const FreeParameter& p = parameters[k];
    const bool is_reciprocal = p.scale == FreeParameter::Scale::reciprocal;
    const bool rises = upwards != is_reciprocal;
    const double from = best.x[k], end = std::abs((rises ? p.largest() : p.least()) - from);
    std::vector<double> nearest = best.x;  // where the others are best, at the last place
    const auto coordinate = [&](double way) {
        return std::clamp(from + (rises ? way : -way), p.least(), p.largest());
    };
    // An infinite sum has no root finder: a large one has its edge at the same place.
    const auto beyond = [&](double way) {
        auto fit = squares.profile(k, coordinate(way), nearest);
        // Far out the others are elsewhere, from where a search may not come back.
        if (fit.sum_of_squares > level)
            if (auto other = squares.profile(k, coordinate(way), best.x);
                other.sum_of_squares < fit.sum_of_squares)
                fit = std::move(other);
        if (std::isfinite(fit.sum_of_squares)) nearest = fit.x;
        return std::min(fit.sum_of_squares - level, 1e300);
    };
    double inside = 0, below = best.sum_of_squares - level, step = start_step;
    if (below >= 0) return p.value(from);  // exact observations, to rounding
    while (inside < end) {
        const double outside = std::min(end, inside + step);
        const double excess = beyond(outside);
        if (excess >= 0) {
            const double root =
                contact::bracketed_root(beyond, inside, outside, below, excess, edge_bits);
            if (is_cut_off(parameters, k, nearest)) break;
            return p.value(coordinate(root));
        }
        inside = outside;
        below = excess;
        step *= step_growth;
    }
    return open_end(p, upwards);
}

/// Half widths of the fitted values' intervals over their errors.
std::vector<double> half_widths(const std::vector<std::vector<double>>& columns,
                                const Identification& found) {
    const auto& c = found.logarithmic.adjusted;
    const double degrees = std::ranges::min(found.logarithmic.effective_degrees);
    std::vector<double> widths;
    for (std::size_t i = 0; i < columns.front().size(); ++i) {
        double variance = 0;
        for (std::size_t k = 0; k < columns.size(); ++k)
            for (std::size_t l = 0; l < columns.size(); ++l)
                variance += columns[k][i] * c[k][l] * columns[l][i];
        widths.push_back(quantile(found.confidence, degrees) * std::sqrt(std::max(0., variance)));
    }
    return widths;
}

double error_of_mean(const double* errors, std::size_t n) {
    double weights = 0;
    for (std::size_t i = 0; i < n; ++i) weights += 1 / (errors[i] * errors[i]);
    return 1 / std::sqrt(weights);
}

/// Weighted sum of squares about the mean.
double total_of(const std::vector<double>& observed, const std::vector<double>& errors) {
    double mean = 0, weights = 0, total = 0;
    for (std::size_t i = 0; i < observed.size(); ++i) {
        mean += observed[i] / (errors[i] * errors[i]);
        weights += 1 / (errors[i] * errors[i]);
    }
    mean /= weights;
    for (std::size_t i = 0; i < observed.size(); ++i)
        total += std::pow((observed[i] - mean) / errors[i], 2);
    return total;
}

void add_tables(const IdentificationTask& task, const BestSumOfSquares& squares,
                const std::vector<double>& x, Identification& found) {
    const auto residuals = squares.residuals(x);
    const auto widths = half_widths(squares.logarithmic_slopes(x), found);
    const auto& errors = squares.standard_errors();
    contact::interruption_point();
    const auto origins = origins_of(task, task.model(values_of(task.parameters, x)), errors);
    double known = 0, known_degrees = 0, explained = 0, total = 0;
    std::size_t row = 0;
    for (std::size_t t = 0; t < task.tables.size(); ++t) {
        const ObservedTable& table = task.tables[t];
        TableFit fit{.origin = origins[t]};
        fit.degrees_of_freedom = found.logarithmic.degrees_of_freedom[t];
        double squares_si = 0;
        const double origin_width =
            table.has_free_origin
                ? quantile(found.confidence,
                           std::ranges::min(found.logarithmic.effective_degrees)) *
                      error_of_mean(errors.data() + row, table.observed.size())
                : 0;
        for (std::size_t i = 0; i < table.observed.size(); ++i, ++row) {
            fit.standard_errors.push_back(errors[row]);
            fit.residuals.push_back(residuals[row] * errors[row]);
            fit.fitted.push_back(table.observed[i] - fit.residuals[i]);
            fit.fitted_half_widths.push_back(std::hypot(widths[row] * errors[row], origin_width));
            fit.sum_of_squares += residuals[row] * residuals[row];
            squares_si += fit.residuals[i] * fit.residuals[i];
        }
        fit.residual_standard_deviation = std::sqrt(squares_si / fit.degrees_of_freedom);
        const double about_mean = total_of(table.observed, fit.standard_errors);
        fit.r_squared = determination(fit.sum_of_squares, about_mean);
        explained += fit.sum_of_squares;
        total += about_mean;
        if (!table.standard_errors.empty()) {
            fit.goodness = gsl_cdf_chisq_Q(fit.sum_of_squares, fit.degrees_of_freedom);
            known += fit.sum_of_squares;
            known_degrees += fit.degrees_of_freedom;
        }
        found.tables.push_back(std::move(fit));
    }
    found.r_squared = determination(explained, total);
    if (known_degrees > 0) found.goodness = gsl_cdf_chisq_Q(known, known_degrees);
}

statistics::Estimate linearised(const FreeParameter& p, double value, double relative,
                                double factor) {
    if (!std::isfinite(relative) || p.is_at_bound(value))
        return {value, contact::infinity, -contact::infinity, contact::infinity};
    return statistics::with_interval(value, p.unit_of_change(value) * relative, factor);
}

}  // namespace

std::vector<double> Identification::best() const {
    std::vector<double> values;
    for (const ParameterEstimate& estimate : parameters) values.push_back(estimate.value);
    return values;
}

std::optional<std::size_t> Identification::find(const std::string& key, std::size_t index) const {
    for (std::size_t k = 0; k < free.size(); ++k)
        if (free[k].key == key && free[k].index == index) return k;
    return {};
}

std::optional<double> Identification::correlation(std::size_t i, std::size_t k) const {
    const auto& c = logarithmic.adjusted;
    const auto told = [&](std::size_t p) {
        return std::isfinite(parameters[p].standard_error) && c[p][p] > 0;
    };
    if (!told(i) || !told(k)) return {};
    return c[i][k] / std::sqrt(c[i][i] * c[k][k]);
}

double Identification::level_of_pair(std::size_t i, std::size_t k) const {
    const auto& degrees = logarithmic.effective_degrees;
    return sum_of_squares + std::max(logarithmic.inflation(i), logarithmic.inflation(k)) *
                                excess(confidence, 2, std::min(degrees[i], degrees[k]));
}

Identification identify(const IdentificationTask& task) {
    BestSumOfSquares squares(task);
    const statistics::BoundedFit best = squares.best();
    Identification found{.free = task.parameters,
                         .sum_of_squares = best.sum_of_squares,
                         .confidence = task.confidence,
                         .logarithmic = squares.covariance(best.x)};
    double degrees_left = 0;
    for (const double degrees : found.logarithmic.degrees_of_freedom) degrees_left += degrees;
    found.degrees_of_freedom = static_cast<int>(std::lround(degrees_left));
    check_residuals(task, squares, best.x, found);
    for (std::size_t k = 0; k < task.parameters.size(); ++k) {
        const FreeParameter& p = task.parameters[k];
        const double value = p.value(best.x[k]), degrees = found.logarithmic.effective_degrees[k];
        const double relative = found.logarithmic.standard_errors[k];
        const double factor = quantile(task.confidence, degrees);
        ParameterEstimate estimate{linearised(p, value, relative, factor)};
        estimate.level = best.sum_of_squares + found.logarithmic.inflation(k) * factor * factor;
        const double width = std::abs(factor * relative * p.slope(value));
        const double step = std::isfinite(width) && width > 0 ? first_part * width : first_step;
        const auto edge_at = [&](bool upwards) {
            return edge(squares, task.parameters, k, best, estimate.level, step, upwards);
        };
        estimate.likelihood = {edge_at(false), edge_at(true)};
        found.parameters.push_back(estimate);
    }
    add_tables(task, squares, best.x, found);
    return found;
}

std::vector<double> best_nearby(const IdentificationTask& task, const Identification& found,
                                const std::vector<double>& observed) {
    IdentificationTask other = task;
    std::vector<double> errors;
    std::size_t row = 0;
    for (std::size_t t = 0; t < other.tables.size(); ++t) {
        for (double& value : other.tables[t].observed) value = observed[row++];
        const auto& stated = found.tables[t].standard_errors;
        errors.insert(errors.end(), stated.begin(), stated.end());
    }
    const BestSumOfSquares squares(other, errors);
    return values_of(task.parameters,
                     squares.best_from(coordinates_of(task.parameters, found.best())).x);
}

namespace {

std::vector<double> errors_of(const Identification& found) {
    std::vector<double> errors;
    for (const TableFit& table : found.tables)
        errors.insert(errors.end(), table.standard_errors.begin(), table.standard_errors.end());
    return errors;
}

}  // namespace

Profile profile_of(const IdentificationTask& task, const Identification& found, std::size_t k,
                   int n_points) {
    const BestSumOfSquares squares(task, errors_of(found));
    const FreeParameter& p = task.parameters[k];
    const ParameterEstimate& estimate = found.parameters[k];
    const double best = estimate.value;
    const double lowest =
        p.scale == FreeParameter::Scale::logarithmic ? best / widest_profile : p.low;
    const double largest =
        p.scale == FreeParameter::Scale::from_zero ? std::max(best, p.size) : best;
    const double highest =
        p.scale == FreeParameter::Scale::either_sign ? p.high : largest * widest_profile;
    const auto [low, high] = estimate.likelihood;
    const double from = std::max({lowest, p.low, low - profile_margin * (best - low)});
    const double to = std::min({highest, p.high, high + profile_margin * (high - best)});
    Profile profile;
    std::vector<double> x = coordinates_of(task.parameters, found.best());
    for (int i = 0; i < n_points; ++i) {
        profile.value.push_back(from + (to - from) * i / (n_points - 1));
        const auto fit = squares.profile(k, p.coordinate(profile.value.back()), x);
        if (std::isfinite(fit.sum_of_squares)) x = fit.x;
        profile.sum_of_squares.push_back(fit.sum_of_squares);
    }
    return profile;
}

std::vector<double> squares_of_pair(const IdentificationTask& task, const Identification& found,
                                    std::size_t first, std::size_t second,
                                    const std::vector<double>& first_values,
                                    const std::vector<double>& second_values) {
    const BestSumOfSquares squares(task, errors_of(found));
    const auto& c = found.logarithmic.covariance;
    const auto best = found.best();
    const auto x = coordinates_of(task.parameters, best);
    const double determinant =
        c[first][first] * c[second][second] - c[first][second] * c[first][second];
    std::vector<double> sums;
    for (const double v : second_values)
        for (const double u : first_values) {
            std::vector<double> at = x;
            const double du = task.parameters[first].change(best[first], u),
                         dv = task.parameters[second].change(best[second], v);
            for (std::size_t k = 0; k < at.size() && determinant > 0; ++k) {
                const double by_u =
                    (c[k][first] * c[second][second] - c[k][second] * c[first][second]) /
                    determinant;
                const double by_v =
                    (c[k][second] * c[first][first] - c[k][first] * c[first][second]) / determinant;
                const FreeParameter& p = task.parameters[k];
                at[k] = std::clamp(p.coordinate(p.changed(best[k], by_u * du + by_v * dv)),
                                   p.least(), p.largest());
            }
            at[first] = task.parameters[first].coordinate(u);
            at[second] = task.parameters[second].coordinate(v);
            const double sum = squares.at(at);
            sums.push_back(std::isfinite(sum) ? sum : contact::undefined);
        }
    return sums;
}

}  // namespace tricontact::experiments
