#include "statistics/bounded_least_squares.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "contact/base/error.h"
#include "contact/base/special_values.h"

namespace tricontact::statistics {

namespace {

constexpr int most_steps = 2000;
// Of variables of the order of 1: error and rounding of differences in balance.
constexpr double difference_step = 1e-5;
constexpr double largest_step = 1;
// Damping: at first, its growth and decay, and where no step is left that helps.
constexpr double first_damping = 1e-3, damping_growth = 6, damping_decay = 8, most_damping = 1e12;
// Many steps that succeed must not lead to 0, from which damping never grows again.
constexpr double least_damping = 1e-100;
// A step below this, or one that gains less than rounding of the sum, is the last.
constexpr double step_tolerance = 1e-11, gain_tolerance = 1e-15;
// So many steps that together gain less than this of the sum wander in a valley of which the
// observations do not resolve the ground: statistics ask for differences of a sum of the order of
// its degrees of freedom.
constexpr int idle_steps = 20;
constexpr double idle_gain = 1e-9;
// And after the first steps a curved valley is followed no further than statistics resolve: until
// so many gain less than this of the sum.
constexpr int steps_of_first_search = 400, many_steps = 100;
constexpr double many_gain = 1e-3;

double squares(const std::vector<double>& residuals) {
    double sum = 0;
    for (const double r : residuals) sum += r * r;
    return std::isfinite(sum) ? sum : contact::infinity;
}

/// Empty where there are none.
std::vector<double> tried(const Residuals& residuals, const std::vector<double>& x) {
    try {
        return residuals(x);
    } catch (const contact::InputError&) {
        return {};
    }
}

/// Slopes and residuals as normal equations.
struct NormalEquations {
    Eigen::MatrixXd matrix;
    Eigen::VectorXd downhill;

    NormalEquations(const std::vector<std::vector<double>>& columns,
                    const std::vector<double>& residuals) {
        const auto n = static_cast<Eigen::Index>(residuals.size());
        Eigen::MatrixXd j(n, columns.size());
        for (std::size_t k = 0; k < columns.size(); ++k)
            j.col(k) = Eigen::Map<const Eigen::VectorXd>(columns[k].data(), n);
        matrix = j.transpose() * j;
        downhill = -j.transpose() * Eigen::Map<const Eigen::VectorXd>(residuals.data(), n);
    }
};

/// The damped step within the box.
std::vector<double> stepped(const NormalEquations& equations, const std::vector<double>& x,
                            const Bounds& bounds, double damping) {
    const auto m = static_cast<Eigen::Index>(x.size());
    Eigen::MatrixXd a = equations.matrix;
    Eigen::VectorXd b = equations.downhill;
    for (Eigen::Index k = 0; k < m; ++k) {
        const bool is_held = bounds.low[k] == bounds.high[k] ||
                             (x[k] <= bounds.low[k] && b[k] < 0) ||
                             (x[k] >= bounds.high[k] && b[k] > 0);
        if (is_held || !(a(k, k) > 0)) {
            a.row(k).setZero();
            a.col(k).setZero();
            a(k, k) = 1;
            b[k] = 0;
        } else {
            a(k, k) *= 1 + damping;
        }
    }
    const Eigen::VectorXd step = a.ldlt().solve(b);
    // Each by itself: a variable of which nothing depends would shorten the steps of all.
    std::vector<double> trial = x;
    for (Eigen::Index k = 0; k < m; ++k)
        trial[k] = std::clamp(x[k] + std::clamp(step[k], -largest_step, largest_step),
                              bounds.low[k], bounds.high[k]);
    return trial;
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
    double largest = 0;
    for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
    return largest;
}

}  // namespace

std::vector<std::vector<double>> slopes(const Residuals& residuals, const std::vector<double>& x,
                                        const Bounds& bounds) {
    const std::size_t n = residuals(x).size();
    std::vector<std::vector<double>> columns(x.size(), std::vector<double>(n, 0.));
    for (std::size_t k = 0; k < x.size(); ++k) {
        if (bounds.low[k] == bounds.high[k]) continue;
        std::vector<double> below = x, above = x;
        below[k] = std::max(bounds.low[k], x[k] - difference_step);
        above[k] = std::min(bounds.high[k], x[k] + difference_step);
        auto at_below = tried(residuals, below), at_above = tried(residuals, above);
        if (at_below.empty()) {  // the edge of what a model is about
            below = x;
            at_below = residuals(x);
        }
        if (at_above.empty()) {
            above = x;
            at_above = residuals(x);
        }
        if (above[k] > below[k])
            for (std::size_t i = 0; i < n; ++i)
                columns[k][i] = (at_above[i] - at_below[i]) / (above[k] - below[k]);
    }
    return columns;
}

BoundedFit fit_within(const Residuals& residuals, std::vector<double> start, const Bounds& bounds) {
    for (std::size_t k = 0; k < start.size(); ++k)
        start[k] = std::clamp(start[k], bounds.low[k], bounds.high[k]);
    std::vector<double> values = tried(residuals, start);
    BoundedFit fit{std::move(start), values.empty() ? contact::infinity : squares(values)};
    if (!std::isfinite(fit.sum_of_squares))
        throw contact::NotConverged("least squares: the model is not defined at the start");
    double damping = first_damping, before_idling = fit.sum_of_squares,
           before_many = contact::infinity;
    for (int i = 0; i < most_steps; ++i) {
        if (i >= steps_of_first_search && i % many_steps == 0) {
            if (before_many - fit.sum_of_squares < many_gain * fit.sum_of_squares) return fit;
            before_many = fit.sum_of_squares;
        }
        if (i > 0 && i % idle_steps == 0) {
            if (before_idling - fit.sum_of_squares < idle_gain * fit.sum_of_squares) return fit;
            before_idling = fit.sum_of_squares;
        }
        const NormalEquations equations(slopes(residuals, fit.x, bounds), values);
        for (;; damping *= damping_growth) {
            if (damping > most_damping) return fit;  // as low as rounding lets it become
            const std::vector<double> trial = stepped(equations, fit.x, bounds, damping);
            const double moved = distance(trial, fit.x);
            if (moved < step_tolerance) return fit;
            std::vector<double> found = tried(residuals, trial);
            const double sum = found.empty() ? contact::infinity : squares(found);
            if (!(sum < fit.sum_of_squares)) continue;
            const double gain = fit.sum_of_squares - sum;
            fit = {trial, sum};
            values = std::move(found);
            damping = std::max(damping / damping_decay, least_damping);
            if (gain < gain_tolerance * sum) return fit;
            break;
        }
    }
    throw contact::NotConverged("least squares: no minimum within 2000 steps");
}

}  // namespace tricontact::statistics
