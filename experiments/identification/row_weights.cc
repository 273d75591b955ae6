#include "experiments/identification/row_weights.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "experiments/identification/adhesive_values.h"
#include "experiments/identification/estimation/best_sum_of_squares.h"
#include "experiments/identification/identification_models.h"
#include "experiments/identification/loop_values.h"
#include "io/case/measurement_models.h"
#include "statistics/variance_sizes.h"

namespace tricontact::experiments {

namespace {

using Table = IdentificationInput::Table;

constexpr int n_passes = 3;
// Of the largest force, squared: what exact rows have for a variance.
constexpr double rounding = 1e-24;
// Of the variance of all rows: what the sensor of force has at least.
constexpr double least_share = 1e-3;

bool has_loops(const Table& table) {
    return !table.loops.loops.empty();
}

/// Rows whose given values have errors that are told: of loops, and of curves down to their
/// tension, where a force curve is soft.
bool is_weighed(const Table& table) {
    return has_loops(table) || !table.ways.empty();
}

/// Squares of the slopes dF/dU or dF/dd of the fitted curves at the rows of a table [N^2/m^2].
std::vector<double> square_slopes(const Table& table, const IdentifiedRig& rig, bool on_layer) {
    std::vector<double> all;
    if (!has_loops(table)) {
        for (const double slope : adhesive_slopes(table, rig, RigDiscs(rig.as_case, on_layer)))
            all.push_back(slope * slope);
        return all;
    }
    std::vector<LoopState> starts;
    for (const FittedLoop& fit : fitted_loops(table, rig, starts))
        for (const double slope : fit.slopes[1]) all.push_back(slope * slope);
    return all;
}

/// Rows that share their sensors' settings.
std::vector<std::vector<std::size_t>> series_of(const Table& table) {
    if (!has_loops(table)) {
        std::vector<std::size_t> all(table.given.size());
        std::iota(all.begin(), all.end(), 0);
        return {all};
    }
    std::vector<std::vector<std::size_t>> series(table.loops.n_series());
    for (const MeasuredLoop& loop : table.loops.loops)
        for (std::size_t i = loop.first; i < loop.first + loop.n; ++i)
            series[loop.series].push_back(i);
    return series;
}

double mean_of(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

/// Rows of all tables, as a search has left them, for the variances of those without stated errors.
class RowVariances {
  public:
    RowVariances(const BestSumOfSquares& search, const std::vector<double>& x)
        : errors_(search.standard_errors()) {
        residuals_ = search.residuals(x);
        columns_ = search.logarithmic_slopes(x);
        own_ = search.own_slopes(x);
        for (auto* const one : {&columns_, &own_})
            for (auto& column : *one) scale(column);
        scale(residuals_);
        for (const double error : errors_) sum_.fixed.push_back(error * error);
    }

    /// Each series has variances of its own, of the force and of the shift, which counts by the
    /// squared slope: sensors are set to what they measure.
    void add(const Table& table, std::size_t first, const std::vector<double>& slopes) {
        for (const auto& series : series_of(table)) {
            std::vector<double> force(errors_.size()), shift(errors_.size());
            std::vector<double> squares, of_series;
            double largest = 0;
            for (const std::size_t i : series) {
                squares.push_back(residuals_[first + i] * residuals_[first + i]);
                of_series.push_back(slopes[i]);
                largest = std::max(largest, std::abs(table.observed[i]));
                force[first + i] = 1;
                shift[first + i] = slopes[i];
                sum_.fixed[first + i] = 0;
            }
            const double size = std::max(mean_of(squares), rounding * largest * largest),
                         slope = mean_of(of_series);
            for (double& part : force) part *= size;
            for (double& part : shift) part *= slope > 0 ? size / slope : 0;
            sum_.parts.push_back(std::move(force));
            sum_.parts.push_back(std::move(shift));
            sum_.least.insert(sum_.least.end(), {least_share, 0});
        }
    }

    /// Gives relative errors and parts of variances to the tables that were added.
    void tell(std::vector<Table>& tables) {
        if (sum_.parts.empty()) return;
        constexpr double start = .5;
        const auto sizes = statistics::variance_sizes(
            columns_, own_, residuals_, sum_, std::vector<double>(sum_.parts.size(), start));
        const auto variances = sum_.of(sizes);
        std::size_t first = 0, part = 0;
        for (Table& table : tables) {
            const std::size_t end = first + table.observed.size();
            if (table.standard_errors.empty() && is_weighed(table)) {
                auto& [stated, of_given, relative, parts] = table.row_errors;
                relative.clear();
                for (std::size_t i = first; i < end; ++i)
                    relative.push_back(std::sqrt(variances[i] / variances[first]));
                parts.assign(2 * series_of(table).size(), {});
                for (auto& column : parts) {
                    for (std::size_t i = first; i < end; ++i)
                        column.push_back(sizes[part] * sum_.parts[part][i] / variances[i]);
                    ++part;
                }
            }
            first = end;
        }
    }

  private:
    void scale(std::vector<double>& column) const {
        for (std::size_t i = 0; i < column.size(); ++i) column[i] *= errors_[i];
    }

    std::vector<double> errors_, residuals_;
    std::vector<std::vector<double>> columns_, own_;
    statistics::VarianceSum sum_;
};

}  // namespace

void weigh_rows(IdentificationInput& input, const contact::ModelRunner& runner) {
    if (std::ranges::none_of(input.tables, is_weighed)) return;
    const std::string& model = input.models.front();
    const bool on_layer = io::measurement_model(model).is_layer;
    for (int pass = 0; pass < n_passes; ++pass) {
        IdentificationTask task = task_of(input, model);
        task.model = prediction_of(model, input, runner);
        BestSumOfSquares search(task);
        const auto best = search.best();
        const IdentifiedRig rig =
            rig_with(input, task.parameters, values_of(task.parameters, best.x));
        RowVariances rows(search, best.x);
        std::size_t first = 0;
        for (Table& table : input.tables) {
            const bool has_stated = !table.standard_errors.empty();
            if (is_weighed(table) && !(has_stated && table.row_errors.given.empty())) {
                const auto slopes = square_slopes(table, rig, on_layer);
                if (!has_stated) rows.add(table, first, slopes);
                for (std::size_t i = 0; has_stated && i < slopes.size(); ++i)
                    table.standard_errors[i] =
                        std::hypot(table.row_errors.observed[i],
                                   std::sqrt(slopes[i]) * table.row_errors.given[i]);
            }
            first += table.observed.size();
        }
        rows.tell(input.tables);
    }
}

}  // namespace tricontact::experiments
