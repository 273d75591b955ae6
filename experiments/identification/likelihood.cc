#include "experiments/identification/likelihood.h"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>

#include "contact/base/special_values.h"

namespace tricontact::experiments {

namespace {

// Of the largest value of a table: exact data have rounding for an error.
constexpr double least_relative_rms = 1e-12;

/// Rows and degrees of freedom of the tables whose errors are not stated.
struct EstimatedRows {
    double n = 0, degrees = 0;
    int n_tables = 0;
    bool are_all = true;
};

EstimatedRows estimated_rows(const IdentificationInput& input, const Identification& found) {
    EstimatedRows rows;
    for (std::size_t t = 0; t < input.tables.size(); ++t) {
        if (!input.tables[t].standard_errors.empty()) {
            rows.are_all = false;
            continue;
        }
        ++rows.n_tables;
        rows.n += static_cast<double>(input.tables[t].observed.size());
        rows.degrees += found.tables[t].degrees_of_freedom;
    }
    return rows;
}

}  // namespace

Likelihood likelihood_of(const IdentificationInput& input, const Identification& found) {
    Likelihood result;
    double n = 0;
    for (std::size_t t = 0; t < input.tables.size(); ++t) {
        const TableFit& table = found.tables[t];
        const auto rows = static_cast<double>(table.residuals.size());
        n += rows - static_cast<double>(input.tables[t].n_own());
        if (!input.tables[t].standard_errors.empty()) {
            result.minus_two_log += table.sum_of_squares;
            continue;
        }
        double squares = 0, largest = 0;
        const auto& relative = input.tables[t].row_errors.relative;
        for (std::size_t i = 0; i < table.residuals.size(); ++i)
            squares += std::pow(table.residuals[i] / (relative.empty() ? 1 : relative[i]), 2);
        for (const double y : input.tables[t].observed) largest = std::max(largest, std::abs(y));
        result.minus_two_log +=
            rows * std::log(std::max(squares / rows, std::pow(least_relative_rms * largest, 2)));
    }
    result.n_fitted =
        static_cast<int>(input.parameters.size()) + estimated_rows(input, found).n_tables;
    const double k = result.n_fitted;
    result.aicc = n > k + 1 ? result.minus_two_log + 2 * k * n / (n - k - 1) : contact::infinity;
    return result;
}

double chance_of_ratio(double ratio, double n_more, const IdentificationInput& input,
                       const Identification& wider) {
    const EstimatedRows rows = estimated_rows(input, wider);
    if (rows.n_tables == 0) return gsl_cdf_chisq_Q(ratio, n_more);
    // Exact for one table and a linear model; of both kinds of tables the known ones count as if
    // their errors were estimated, too.
    const double f =
        rows.are_all ? std::expm1(ratio / rows.n) * rows.degrees / n_more : ratio / n_more;
    return gsl_cdf_fdist_Q(f, n_more, rows.degrees);
}

}  // namespace tricontact::experiments
