#include "experiments/identification/estimation/residual_checks.h"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace tricontact::experiments {

namespace {

using Columns = std::vector<std::vector<double>>;

// Correlations of tables have a pattern below this chance, over the number of tables.
constexpr double pattern_chance = .05;
constexpr std::size_t least_rows = 3;
constexpr double least_repeats = 2, least_lack_degrees = .5;
// Of a mean square of residuals over their errors. Estimated errors make it 1 but in a fit to
// rounding; far within stated ones a pattern is of no account.
constexpr double least_mean_square = .1;
// Correlations up to one that the residuals have: a variance may be largest in between.
constexpr int n_correlations = 5;

/// Rows of one table among all.
struct TableRows {
    std::size_t first = 0, end = 0;
    std::vector<std::size_t> in_order;  ///< in which neighbours may be alike
    bool is_known = false;              ///< errors are stated
    double degrees = 0;
};

std::vector<TableRows> rows_of(const IdentificationTask& task, const Identification& found) {
    std::vector<TableRows> all;
    std::size_t first = 0;
    for (std::size_t t = 0; t < task.tables.size(); ++t) {
        const ObservedTable& table = task.tables[t];
        TableRows rows{.first = first, .end = first + table.observed.size()};
        rows.in_order.resize(table.observed.size());
        std::iota(rows.in_order.begin(), rows.in_order.end(), first);
        if (!table.given.empty())
            std::ranges::stable_sort(rows.in_order, {},
                                     [&](std::size_t row) { return table.given[row - first]; });
        rows.is_known = !table.standard_errors.empty();
        rows.degrees = found.logarithmic.degrees_of_freedom[t];
        first = rows.end;
        all.push_back(std::move(rows));
    }
    return all;
}

double sum_of_squares(const std::vector<double>& residuals, const TableRows& rows) {
    return std::inner_product(residuals.begin() + rows.first, residuals.begin() + rows.end,
                              residuals.begin() + rows.first, 0.);
}

std::optional<double> lack_of_fit(const ObservedTable& table, const std::vector<double>& residuals,
                                  const TableRows& rows) {
    if (table.given.empty()) return {};
    struct Reading {
        double n = 0, sum = 0, squares = 0;
    };
    std::map<double, Reading> readings;
    for (std::size_t row = rows.first; row < rows.end; ++row) {
        Reading& reading = readings[table.given[row - rows.first]];
        ++reading.n;
        reading.sum += residuals[row];
        reading.squares += residuals[row] * residuals[row];
    }
    double scatter = 0, repeats = 0;
    for (const auto& [given, reading] : readings) {
        scatter += reading.squares - reading.sum * reading.sum / reading.n;
        repeats += reading.n - 1;
    }
    const double degrees = rows.degrees - repeats;
    if (repeats < least_repeats || degrees < least_lack_degrees || !(scatter > 0)) return {};
    const double misfit = std::max(0., sum_of_squares(residuals, rows) - scatter);
    return gsl_cdf_fdist_Q(misfit / degrees / (scatter / repeats), degrees, repeats);
}

/// Variances of parameters over those of independent errors, where errors of each table have their
/// correlation.
std::vector<double> inflations(const Columns& columns, const Columns& covariance,
                               const std::vector<TableRows>& tables,
                               const statistics::ResidualProjection& projection,
                               const std::vector<double>& correlations) {
    const std::size_t m = covariance.size();
    Columns information(m, std::vector<double>(m, 0.));  // of the slopes, as errors spread it
    for (std::size_t t = 0; t < tables.size(); ++t) {
        // Estimated errors came from residuals that correlated errors leave too small.
        const double scale =
            tables[t].is_known || correlations[t] == 0
                ? 1
                : tables[t].degrees / statistics::mean_sum_of_squares(tables[t].in_order,
                                                                      projection, correlations[t]);
        Columns slopes;
        for (std::size_t k = 0; k < m; ++k) {
            auto& column = slopes.emplace_back();
            for (const std::size_t row : tables[t].in_order) column.push_back(columns[k][row]);
        }
        for (std::size_t k = 0; k < m; ++k)
            for (std::size_t l = 0; l < m; ++l)
                information[k][l] +=
                    scale * statistics::correlated_product(slopes[k], slopes[l], correlations[t]);
    }
    std::vector<double> factors;
    for (std::size_t k = 0; k < m; ++k) {
        double variance = 0;
        for (std::size_t i = 0; i < m; ++i)
            for (std::size_t j = 0; j < m; ++j)
                variance += covariance[k][i] * information[i][j] * covariance[j][k];
        factors.push_back(covariance[k][k] > 0 ? std::max(1., variance / covariance[k][k]) : 1);
    }
    return factors;
}

/// The largest ones on the way to these correlations.
std::vector<double> largest_inflations(const Columns& columns, const Columns& covariance,
                                       const std::vector<TableRows>& tables,
                                       const statistics::ResidualProjection& projection,
                                       const std::vector<double>& correlations) {
    std::vector<double> largest(covariance.size(), 1.);
    if (std::ranges::max(correlations) == 0) return largest;  // not to rounding
    for (int part = 1; part <= n_correlations; ++part) {
        std::vector<double> at = correlations;
        for (double& rho : at) rho *= static_cast<double>(part) / n_correlations;
        const auto here = inflations(columns, covariance, tables, projection, at);
        for (std::size_t k = 0; k < here.size(); ++k) largest[k] = std::max(largest[k], here[k]);
    }
    return largest;
}

/// Whether chi^2 does not reject the model for the other rows of stated errors: rows that a wrong
/// model misses are no outliers.
bool explains_others(const std::vector<double>& residuals, const Columns& columns,
                     const std::vector<TableRows>& tables,
                     const std::vector<statistics::OutlyingRow>& outlying) {
    if (outlying.empty()) return true;
    double sum = 0, degrees = -static_cast<double>(outlying.size());
    for (const TableRows& table : tables) {
        if (!table.is_known) continue;
        degrees += table.degrees;
        for (std::size_t row = table.first; row < table.end; ++row) {
            if (std::ranges::count(outlying, row, &statistics::OutlyingRow::row)) continue;
            double residual = residuals[row];
            for (std::size_t k = 0; k < columns.size(); ++k)
                residual += columns[k][row] * outlying.back().change[k];
            sum += residual * residual;
        }
    }
    return !(degrees > 0) || gsl_cdf_chisq_Q(sum, degrees) >= rare_chance;
}

/// Of standard errors, in squares; estimated errors have the degrees of freedom of as many
/// independent rows as tell a variance as well.
void widen(statistics::JointCovariance& covariance, const std::vector<double>& inflation,
           double correlation) {
    const double share = (1 - correlation * correlation) / (1 + correlation * correlation);
    for (std::size_t k = 0; k < inflation.size(); ++k) {
        for (std::size_t l = 0; l < inflation.size(); ++l)
            covariance.adjusted[k][l] *= std::sqrt(inflation[k] * inflation[l]);
        covariance.standard_errors[k] *= std::sqrt(inflation[k]);
        covariance.effective_degrees[k] = std::max(1., share * covariance.effective_degrees[k]);
    }
}

}  // namespace

bool Identification::has_pattern() const {
    return std::ranges::any_of(residuals, &TableResiduals::has_pattern);
}

bool Identification::has_strong_pattern() const {
    return std::ranges::any_of(residuals, &TableResiduals::has_strong_one);
}

void check_residuals(const IdentificationTask& task, const BestSumOfSquares& squares,
                     const std::vector<double>& x, Identification& found) {
    const auto residuals = squares.residuals(x);
    const auto columns = squares.all_slopes(x);
    const statistics::ResidualProjection projection(columns);
    const auto tables = rows_of(task, found);
    std::vector<double> of_patterns, not_excluded;
    std::vector<statistics::ErrorGroup> groups;
    for (std::size_t t = 0; t < tables.size(); ++t) {
        const TableRows& rows = tables[t];
        TableResiduals one;
        const bool matters =
            rows.in_order.size() >= least_rows &&
            sum_of_squares(residuals, rows) > least_mean_square * std::max(0., rows.degrees);
        if (matters) {
            one.correlation =
                statistics::residual_correlation(residuals, rows.in_order, projection);
            one.lack_of_fit = lack_of_fit(task.tables[t], residuals, rows);
            const double chance =
                one.correlation->chance * static_cast<double>(tables.size());  // Bonferroni
            const bool lacks_fit = one.lack_of_fit.value_or(1) < rare_chance;
            one.has_pattern = chance < pattern_chance || lacks_fit;
            one.has_strong_one = chance < rare_chance || lacks_fit;
        }
        of_patterns.push_back(one.has_pattern ? one.correlation->of_errors : 0);
        not_excluded.push_back(matters ? one.correlation->not_excluded : 0);
        groups.push_back({.n_rows = rows.end - rows.first, .is_known = rows.is_known});
        found.residuals.push_back(one);
    }
    const auto& covariance = found.logarithmic.covariance;
    const auto inflation = largest_inflations(columns, covariance, tables, projection, of_patterns);
    const auto possible = largest_inflations(columns, covariance, tables, projection, not_excluded);
    for (const double factor : inflation) found.widening.push_back(std::sqrt(factor));
    found.possible_widening = std::sqrt(std::ranges::max(possible));
    found.outlying = statistics::outlying_rows(residuals, columns, groups, rare_chance);
    if (!explains_others(residuals, columns, tables, found.outlying)) found.outlying.clear();
    widen(found.logarithmic, inflation, std::ranges::max(of_patterns));
}

}  // namespace tricontact::experiments
