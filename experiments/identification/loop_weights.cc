#include "experiments/identification/loop_weights.h"

#include <algorithm>
#include <cmath>

#include "experiments/identification/estimation/best_sum_of_squares.h"
#include "experiments/identification/identification_models.h"
#include "experiments/identification/loop_values.h"

namespace tricontact::experiments {

namespace {

using Table = IdentificationInput::Table;

constexpr int n_passes = 2, n_rounds = 30;
// Of a row: what a loop's own numbers take from its residual.
constexpr double largest_leverage = .9;
// Of the variance of all rows: what the sensor of force has at least.
constexpr double least_share = 1e-3;

/// Squares of residuals, as independent errors would have them without a fit, and of slopes; the
/// rows' series.
struct RowSquares {
    std::vector<double> residuals, slopes;
    std::vector<std::size_t> series;

    /// Of one series.
    RowSquares of(std::size_t which) const {
        RowSquares part;
        for (std::size_t i = 0; i < series.size(); ++i) {
            if (series[i] != which) continue;
            part.residuals.push_back(residuals[i]);
            part.slopes.push_back(slopes[i]);
        }
        return part;
    }
};

/// Variances of errors of the force [N^2] and of the shift [m^2].
struct Variances {
    double force = 0, shift = 0;
};

RowSquares squares_of(const Table& table, const IdentifiedRig& rig) {
    RowSquares all;
    std::vector<LoopState> starts;
    const auto fits = fitted_loops(table, rig, starts);
    for (std::size_t loop = 0; loop < fits.size(); ++loop) {
        const LoopRows rows = rows_of(table, table.loops.loops[loop]);
        const FittedLoop& fit = fits[loop];
        for (std::size_t i = 0; i < rows.forces.size(); ++i) {
            double leverage = 0;
            for (std::size_t k = 0; k < n_of_loop; ++k)
                for (std::size_t l = 0; l < n_of_loop; ++l)
                    leverage += fit.slopes[k][i] * fit.covariance[k][l] * fit.slopes[l][i];
            leverage /= rows.error(i) * rows.error(i);
            const double residual = rows.forces[i] - fit.forces[i];
            all.residuals.push_back(residual * residual /
                                    (1 - std::clamp(leverage, 0., largest_leverage)));
            all.slopes.push_back(fit.slopes[1][i] * fit.slopes[1][i]);
            all.series.push_back(table.loops.loops[loop].series);
        }
    }
    return all;
}

/// By weighted least squares of the squares as a + b (dF/dU)^2, whose scatter goes with themselves.
Variances variances_of(const RowSquares& squares) {
    const std::size_t n = squares.residuals.size();
    double mean = 0;
    for (const double square : squares.residuals) mean += square / static_cast<double>(n);
    double a = mean, b = 0;
    for (int round = 0; round < n_rounds; ++round) {
        double w = 0, s = 0, r = 0, ss = 0, sr = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const double weight = std::pow(a + b * squares.slopes[i], -2);
            w += weight;
            s += weight * squares.slopes[i];
            r += weight * squares.residuals[i];
            ss += weight * squares.slopes[i] * squares.slopes[i];
            sr += weight * squares.slopes[i] * squares.residuals[i];
        }
        const double determinant = w * ss - s * s;
        b = determinant > 0 ? std::max(0., (w * sr - s * r) / determinant) : 0;
        a = b > 0 ? std::max(least_share * mean, (r - b * s) / w) : r / w;
    }
    return {a, b};
}

/// Errors of the rows over that of the first series' force. Each series has variances of its own:
/// sensors are set to what they measure.
std::vector<double> relative_errors(const RowSquares& squares, std::size_t n_series) {
    std::vector<Variances> of_series;
    for (std::size_t s = 0; s < n_series; ++s) of_series.push_back(variances_of(squares.of(s)));
    std::vector<double> errors;
    for (std::size_t i = 0; i < squares.slopes.size(); ++i) {
        const Variances& own = of_series[squares.series[i]];
        errors.push_back(
            std::sqrt((own.force + own.shift * squares.slopes[i]) / of_series[0].force));
    }
    return errors;
}

}  // namespace

void weigh_loop_rows(IdentificationInput& input, const contact::ModelRunner& runner) {
    if (!input.find(IdentificationInput::Measurement::friction_loop)) return;
    for (int pass = 0; pass < n_passes; ++pass) {
        IdentificationTask task = task_of(input, input.models.front());
        task.model = prediction_of(input.models.front(), input, runner);
        const auto best = BestSumOfSquares(task).best();
        const IdentifiedRig rig =
            rig_with(input, task.parameters, values_of(task.parameters, best.x));
        for (Table& table : input.tables) {
            const RowSquares squares = squares_of(table, rig);
            if (table.standard_errors.empty())
                table.loops.relative_errors = relative_errors(squares, table.loops.n_series());
            else if (!table.loops.shift_errors.empty())
                for (std::size_t i = 0; i < table.standard_errors.size(); ++i)
                    table.standard_errors[i] =
                        std::hypot(table.loops.force_errors[i],
                                   std::sqrt(squares.slopes[i]) * table.loops.shift_errors[i]);
        }
    }
}

}  // namespace tricontact::experiments
