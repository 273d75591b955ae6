#include "experiments/identification/best_sum_of_squares.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "contact/error.h"
#include "contact/special_values.h"
#include "statistics/regression.h"

namespace tricontact::experiments {

namespace {

// Of q: so that a minimum between two of them is the only one there (sums of squares of forces and
// shifts have one or, at an end, none).
constexpr int n_friction_values = 24;
// A minimum is told from its neighbours by the square root of what a double resolves.
constexpr int minimum_bits = std::numeric_limits<double>::digits / 2;

// Of ln E, in the search for a start of least squares; and the largest step of it.
constexpr double scale_tolerance = 1e-3, largest_scale_step = 2;
constexpr int most_scale_steps = 50;

void check(const IdentificationTask& task, int n_free) {
    if (n_free == 0) throw std::invalid_argument("nothing is to be identified");
    if (task.observed.size() <= static_cast<std::size_t>(n_free))
        throw std::invalid_argument(fmt::format("{} observations do not determine {} properties",
                                                task.observed.size(), n_free));
    if (!task.standard_errors.empty() && task.standard_errors.size() != task.observed.size())
        throw std::invalid_argument("one standard error per observation");
    if (task.friction_is_free && !(task.least_friction > 0))
        throw std::invalid_argument("without a tangential force nothing tells the friction");
}

}  // namespace

BestSumOfSquares::BestSumOfSquares(const IdentificationTask& task)
    : task_(task), guess_(task.start.young) {
    check(task, n_free());
    for (const double error : task.standard_errors) weights_.push_back(1 / (error * error));
}

double BestSumOfSquares::at(const Properties& properties) const {
    std::vector<double> values;
    try {
        values = task_.model(properties);
    } catch (const contact::InputError&) {
        return contact::infinity;  // no such contact
    }
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double residual = task_.observed[i] - values[i];
        sum += weight(i) * residual * residual;
    }
    return std::isfinite(sum) ? sum : contact::infinity;
}

/// Where the model's values need no common factor to be nearest the observed ones: close to the
/// best E, and found without straying far, since a model's values are nearly a power of E.
double BestSumOfSquares::scaled_young(double guess, double friction) const {
    const auto log_factor = [&](double log_young) {
        const auto values = task_.model({std::exp(log_young), friction});
        double ym = 0, mm = 0;
        for (std::size_t i = 0; i < values.size(); ++i) {
            ym += weight(i) * task_.observed[i] * values[i];
            mm += weight(i) * values[i] * values[i];
        }
        if (!(ym > 0))
            throw contact::NotConverged("identification: the observations have the wrong sign");
        return std::log(ym / mm);
    };
    double before = std::log(guess), x = before + scale_tolerance, f_before = log_factor(before);
    for (int i = 0; i < most_scale_steps; ++i) {
        const double f = log_factor(x), step = -f * (x - before) / (f - f_before);
        before = x;
        f_before = f;
        x += std::clamp(step, -largest_scale_step, largest_scale_step);
        if (std::abs(step) < scale_tolerance) return std::exp(x);
    }
    throw contact::NotConverged("identification: no value of E explains the observations");
}

LeastSquares BestSumOfSquares::best_young(double friction) const {
    if (!task_.young_is_free) {
        const Properties fixed{task_.start.young, friction};
        return {fixed, at(fixed)};
    }
    // By its logarithm: E stays positive, and what is measured is nearly a power of it.
    const double unit = scaled_young(guess_, friction);
    const auto young_of = [&](double p) { return unit * std::exp(p - 1); };
    const auto model = [&](const std::vector<double>& p) {
        return task_.model({young_of(p[0]), friction});
    };
    statistics::FitOptions options;
    options.weights = weights_;
    const statistics::Fit fit = statistics::fit_nonlinear(model, task_.observed, {1.}, options);
    guess_ = young_of(fit.parameters[0].value);
    return {{guess_, friction}, fit.residual_sum_of_squares};
}

// `along`: from mu to what is least there.
template <class Along>
LeastSquares BestSumOfSquares::least_along_friction(const Along& along) const {
    const auto sum_at = [&](double q) { return along(task_.least_friction / q).sum; };
    const double lowest = 1 / largest_friction_ratio;
    const auto value = [&](int k) {
        return lowest + (1 - lowest) * std::clamp(k, 0, n_friction_values) / n_friction_values;
    };
    int k_best = 0;
    double least = contact::infinity;
    for (int k = n_friction_values; k >= 0; --k)
        if (const double sum = sum_at(value(k)); sum < least) {
            least = sum;
            k_best = k;
        }
    const auto [q, sum] = boost::math::tools::brent_find_minima(sum_at, value(k_best - 1),
                                                                value(k_best + 1), minimum_bits);
    return along(task_.least_friction / (sum < least ? q : value(k_best)));
}

LeastSquares BestSumOfSquares::best_friction(double young) const {
    if (!task_.friction_is_free) {
        const Properties fixed{young, task_.start.friction};
        return {fixed, at(fixed)};
    }
    return least_along_friction([&](double friction) {
        return LeastSquares{{young, friction}, at({young, friction})};
    });
}

double BestSumOfSquares::profile(Property property, double value) const {
    return (property == Property::young ? best_friction(value) : best_young(value)).sum;
}

LeastSquares BestSumOfSquares::best() const {
    if (!task_.friction_is_free) return best_young(task_.start.friction);
    return least_along_friction([&](double friction) { return best_young(friction); });
}

}  // namespace tricontact::experiments
