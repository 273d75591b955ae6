#include "experiments/identification/estimation/best_sum_of_squares.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "contact/base/error.h"
#include "contact/base/special_values.h"

namespace tricontact::experiments {

namespace {

// Of F_T/(mu F_N) at the largest force, and of Poisson's ratio: a sum of squares may have a minimum
// at small ones and one close to sliding, or at 1/2.
constexpr double scanned_ratios[] = {.3, .6, .85, .97};
constexpr double scanned_poissons[] = {.25, .47};
// Errors estimated from residuals and parameters found with them stand still to this.
constexpr double error_tolerance = 1e-6;
// Of a wrong model each round may take a fifth off the change alone.
constexpr int most_rounds = 200;
// From then on what a table has left beside its parameters stands still: a parameter that reaches
// and leaves the end of its range by turns would change it for ever, and the errors with it.
constexpr int rounds_of_freedom = 60;
// Of the largest value of a table: exact data have rounding for an error.
constexpr double least_relative_error = 1e-12;
constexpr double first_relative_error = 1e-2;
// Rows of a table left beside the parameters that it tells, below which its error is unknown.
constexpr double least_rows_left = .5;

double largest_of(const ObservedTable& table) {
    double largest = 0;
    for (const double value : table.observed) largest = std::max(largest, std::abs(value));
    return largest;
}

double relative(const ObservedTable& table, std::size_t row) {
    return table.relative_errors.empty() ? 1 : table.relative_errors[row];
}

void check(const IdentificationTask& task) {
    const std::size_t n = task.n_observations() - task.n_own(), m = task.parameters.size();
    if (m == 0) throw std::invalid_argument("nothing is to be identified");
    if (n <= m)
        throw std::invalid_argument(
            fmt::format("{} observations do not determine {} parameters", n, m));
    for (const ObservedTable& table : task.tables)
        if (!table.standard_errors.empty() && table.standard_errors.size() != table.observed.size())
            throw std::invalid_argument("one standard error per observation");
    for (const FreeParameter& p : task.parameters)
        if (!p.has_range()) throw std::invalid_argument("no range of " + p.key);
}

std::vector<statistics::ErrorGroup> groups_of(const IdentificationTask& task) {
    std::vector<statistics::ErrorGroup> groups;
    for (const ObservedTable& table : task.tables)
        groups.push_back({.n_rows = table.observed.size(),
                          .n_own = table.n_own(),
                          .is_known = !table.standard_errors.empty(),
                          .parts = table.variance_parts});
    return groups;
}

/// All combinations of the scanned values, other parameters at their start.
std::vector<std::vector<double>> starts_of(const std::vector<FreeParameter>& parameters) {
    std::vector<std::vector<double>> starts{{}};
    for (const FreeParameter& p : parameters) {
        std::vector<double> values{p.coordinate(p.start)};
        for (const double start : p.further_starts) values.push_back(p.coordinate(start));
        if (p.scale == FreeParameter::Scale::reciprocal && p.further_starts.empty())
            values.assign(std::begin(scanned_ratios), std::end(scanned_ratios));
        else if (p.key == "substrate.poisson")
            values.assign(std::begin(scanned_poissons), std::end(scanned_poissons));
        std::vector<std::vector<double>> longer;
        for (const auto& start : starts)
            for (const double value : values) {
                longer.push_back(start);
                longer.back().push_back(value);
            }
        starts = std::move(longer);
    }
    return starts;
}

/// The place with all terms of relaxation as small as they may be, but for a held one: the valley
/// of a slow, large term and that of none are apart, and a search ends in one of them.
std::vector<double> without_terms(const std::vector<FreeParameter>& parameters,
                                  const statistics::Bounds& bounds, std::size_t held,
                                  std::vector<double> x) {
    for (std::size_t i = 0; i < parameters.size(); ++i)
        if (i != held && parameters[i].key == "substrate.relaxation.relative_moduli")
            x[i] = bounds.low[i];
    return x;
}

}  // namespace

BestSumOfSquares::BestSumOfSquares(const IdentificationTask& task) : task_(task) {
    check(task);
    for (const ObservedTable& table : task.tables) {
        observed_.insert(observed_.end(), table.observed.begin(), table.observed.end());
        const auto& stated = table.standard_errors;
        errors_.insert(errors_.end(), stated.begin(), stated.end());
        if (stated.empty())
            for (std::size_t i = 0; i < table.observed.size(); ++i)
                errors_.push_back(first_relative_error * largest_of(table) * relative(table, i));
    }
    for (const FreeParameter& p : task.parameters) {
        bounds_.low.push_back(p.least());
        bounds_.high.push_back(p.largest());
    }
}

BestSumOfSquares::BestSumOfSquares(const IdentificationTask& task,
                                   std::vector<double> standard_errors)
    : BestSumOfSquares(task) {
    errors_ = std::move(standard_errors);
}

std::vector<double> BestSumOfSquares::residuals(const std::vector<double>& x) const {
    if (++n_evaluations_ > most_evaluations) {
        std::string symbols;
        for (const FreeParameter& p : task_.parameters)
            symbols += (symbols.empty() ? "" : ", ") + p.symbol;
        throw contact::NotConverged(fmt::format(
            "identification: after {} evaluations of the model there is no end to the search for "
            "{}: these observations do not determine them; measure more, or find fewer",
            most_evaluations, symbols));
    }
    return residuals_of(task_, task_.model(values_of(task_.parameters, x)), errors_);
}

double BestSumOfSquares::at(const std::vector<double>& x) const {
    double sum = 0;
    try {
        for (const double r : residuals(x)) sum += r * r;
    } catch (const contact::InputError&) {
        return contact::infinity;  // no such contact
    }
    return std::isfinite(sum) ? sum : contact::infinity;
}

statistics::BoundedFit BestSumOfSquares::best_from(const std::vector<double>& x) const {
    return statistics::fit_within([this](const auto& at) { return residuals(at); }, x, bounds_);
}

statistics::BoundedFit BestSumOfSquares::best() {
    statistics::BoundedFit best{{}, contact::infinity};
    std::string undefined, reason;
    for (const auto& start : starts_of(task_.parameters)) {
        try {
            residuals(start);
            auto fit = best_from(start);
            if (fit.sum_of_squares < best.sum_of_squares) best = std::move(fit);
        } catch (const contact::InputError& error) {
            undefined = error.what();
        } catch (const contact::NotConverged& error) {
            reason = error.what();
        }
    }
    if (best.x.empty() && !undefined.empty()) throw contact::InputError(undefined);
    if (best.x.empty())
        throw contact::NotConverged("identification: nothing explains the observations: " + reason);
    if (std::ranges::all_of(task_.tables, [](const auto& t) { return !t.standard_errors.empty(); }))
        return best;
    std::vector<double> left;
    for (int i = 0; i < most_rounds; ++i) {
        if (i < rounds_of_freedom) left = covariance(best.x).degrees_of_freedom;
        const double change = estimate_errors(best.x, left);
        best = best_from(best.x);
        if (change < error_tolerance) return best;
    }
    throw contact::NotConverged(
        "identification: the errors of the tables cannot be estimated from their residuals; state "
        "them");
}

statistics::BoundedFit BestSumOfSquares::profile(std::size_t k, double coordinate,
                                                 std::vector<double> x) const {
    statistics::Bounds held = bounds_;
    held.low[k] = held.high[k] = x[k] = coordinate;
    if (!std::isfinite(at(x))) return {std::move(x), contact::infinity};
    const auto from = [&](const std::vector<double>& start) {
        return statistics::fit_within([this](const auto& at) { return residuals(at); }, start,
                                      held);
    };
    auto best = from(x);
    const std::vector<double> bare = without_terms(task_.parameters, bounds_, k, x);
    if (bare == x || !std::isfinite(at(bare))) return best;
    auto other = from(bare);
    return other.sum_of_squares < best.sum_of_squares ? other : best;
}

std::vector<std::vector<double>> BestSumOfSquares::logarithmic_slopes(
    const std::vector<double>& x) const {
    auto columns = statistics::slopes([this](const auto& at) { return residuals(at); }, x, bounds_);
    for (std::size_t k = 0; k < columns.size(); ++k) {
        const FreeParameter& p = task_.parameters[k];
        const double value = p.value(x[k]);
        for (double& slope : columns[k]) slope *= p.is_at_bound(value) ? 0 : p.slope(value);
    }
    return columns;
}

std::vector<std::vector<double>> BestSumOfSquares::all_slopes(const std::vector<double>& x) const {
    auto columns = logarithmic_slopes(x);
    for (auto& column : own_slopes(x)) columns.push_back(std::move(column));
    return columns;
}

std::vector<std::vector<double>> BestSumOfSquares::own_slopes(const std::vector<double>& x) const {
    std::vector<std::vector<double>> columns;
    std::size_t row = 0;
    for (const ObservedTable& table : task_.tables) {
        const std::size_t end = row + table.observed.size();
        if (table.has_free_origin) {
            auto& origin = columns.emplace_back(observed_.size(), 0.);
            for (std::size_t i = row; i < end; ++i) origin[i] = 1 / errors_[i];
        }
        row = end;
    }
    if (!task_.inner_slopes) return columns;
    for (auto& slopes : task_.inner_slopes(values_of(task_.parameters, x))) {
        for (std::size_t i = 0; i < slopes.size(); ++i) slopes[i] /= errors_[i];
        columns.push_back(std::move(slopes));
    }
    return columns;
}

statistics::JointCovariance BestSumOfSquares::covariance(const std::vector<double>& x) const {
    const auto has_parts = [](const ObservedTable& t) { return !t.variance_parts.empty(); };
    const bool asks_own = std::ranges::any_of(task_.tables, has_parts);
    return statistics::joint_covariance(
        logarithmic_slopes(x), groups_of(task_),
        asks_own ? own_slopes(x) : std::vector<std::vector<double>>());
}

double BestSumOfSquares::estimate_errors(const std::vector<double>& x,
                                         const std::vector<double>& left) {
    const auto residual = residuals(x);
    double change = 0;
    std::size_t row = 0;
    for (std::size_t t = 0; t < task_.tables.size(); ++t) {
        const ObservedTable& table = task_.tables[t];
        const std::size_t end = row + table.observed.size();
        if (table.standard_errors.empty()) {
            if (left[t] < least_rows_left)
                throw contact::NotConverged(
                    "identification: the table " + table.name +
                    " determines parameters but not its own errors; state them in its last column");
            double sum = 0;
            for (std::size_t i = row; i < end; ++i)
                sum += std::pow(residual[i] * errors_[i] / relative(table, i - row), 2);
            const double error =
                std::max(std::sqrt(sum / left[t]), least_relative_error * largest_of(table));
            change = std::max(change, std::abs(error * relative(table, 0) / errors_[row] - 1));
            for (std::size_t i = row; i < end; ++i) errors_[i] = error * relative(table, i - row);
        }
        row = end;
    }
    return change;
}

}  // namespace tricontact::experiments
