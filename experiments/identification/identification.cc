#include "experiments/identification/identification.h"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "contact/error.h"
#include "contact/root.h"
#include "contact/special_values.h"
#include "experiments/identification/best_sum_of_squares.h"
#include "statistics/regression.h"

namespace tricontact::experiments {

namespace {

// First step from the best value when an edge of an interval is looked for, and its growth.
constexpr double first_step = 1e-4, step_growth = 1.6;
// An edge to 1e-9 of the property: far below any error of it.
constexpr int edge_bits = 30;
// Of central differences, over the property: error and rounding in balance to 1e-7 of the slope.
constexpr double difference_step = 1e-4;
// Figures show a profile beyond the edges of its interval, by this part of it.
constexpr double profile_margin = 0.3;
constexpr double widest_profile = 10;  // in best values, where an interval is open

/// How much a sum of squares may exceed the least one with n properties held.
double level(const IdentificationTask& task, double least, int n_held, int degrees_of_freedom) {
    if (!task.standard_errors.empty()) return least + gsl_cdf_chisq_Pinv(task.confidence, n_held);
    const double f = gsl_cdf_fdist_Pinv(task.confidence, n_held, degrees_of_freedom);
    return least * (1 + n_held * f / degrees_of_freedom);
}

/// Where the profile of a property leaves a level; where it does not, the bound of the property.
double edge(const BestSumOfSquares& squares, const IdentificationTask& task, Property property,
            double best, double level, bool upwards) {
    const bool young = property == Property::young;
    const double farthest = young && upwards ? best * largest_young_ratio
                            : young          ? best / largest_young_ratio
                                    : task.least_friction * (upwards ? largest_friction_ratio : 1);
    // Outwards by growing steps in the logarithm, then the root between the last two.
    const double end = std::abs(std::log(farthest / best));
    const auto value = [&](double x) { return best * std::exp(upwards ? x : -x); };
    // An infinite sum has no root finder: a large one has its edge at the same place.
    const auto excess = [&](double x) {
        return std::min(squares.profile(property, value(x)) - level, 1e300);
    };
    double inside = 0, below = excess(inside), step = first_step;
    if (below >= 0) return best;  // exact observations, to rounding
    while (inside < end) {
        const double outside = std::min(end, inside + step);
        const double beyond = excess(outside);
        if (beyond >= 0)
            return value(
                contact::bracketed_root(excess, inside, outside, below, beyond, edge_bits));
        inside = outside;
        below = beyond;
        step *= step_growth;
    }
    return upwards ? contact::infinity : young ? 0 : task.least_friction;
}

std::vector<Property> free_properties(const IdentificationTask& task) {
    std::vector<Property> properties;
    if (task.young_is_free) properties.push_back(Property::young);
    if (task.friction_is_free) properties.push_back(Property::friction);
    return properties;
}

/// Least squares once more in the properties themselves, from the best ones: their covariance.
/// Empty where there is none, at the edge of what the model is defined for.
std::optional<statistics::Fit> linearised(const IdentificationTask& task,
                                          const BestSumOfSquares& squares,
                                          const LeastSquares& best) {
    const auto properties = free_properties(task);
    std::vector<double> start;
    for (const Property property : properties) start.push_back(best.at[property]);
    const auto model = [&](const std::vector<double>& p) {
        Properties trial = best.at;
        for (std::size_t k = 0; k < p.size(); ++k) trial[properties[k]] = p[k];
        if (!(trial.young > 0) || (task.friction_is_free && trial.friction < task.least_friction))
            throw std::domain_error("no such material");
        return task.model(trial);
    };
    statistics::FitOptions options{task.confidence, squares.weights()};
    options.weights_are_absolute = !task.standard_errors.empty();
    try {
        return statistics::fit_nonlinear(model, task.observed, start, options);
    } catch (const std::domain_error&) {
    } catch (const contact::InputError&) {
    } catch (const contact::NotConverged&) {
    }
    return {};
}

/// The last digits of the best properties; false if the fit went elsewhere.
bool take_over(const statistics::Fit& fit, const IdentificationTask& task, LeastSquares& best) {
    const auto properties = free_properties(task);
    Properties at = best.at;
    for (std::size_t k = 0; k < properties.size(); ++k) at[properties[k]] = fit.parameters[k].value;
    if (fit.residual_sum_of_squares > best.sum ||
        (task.friction_is_free && at.friction > task.least_friction * largest_friction_ratio))
        return false;
    best = {at, fit.residual_sum_of_squares};
    return true;
}

/// Slope of all fitted values by one property.
std::vector<double> slope(const IdentificationTask& task, const Properties& best,
                          Property property) {
    const double value = best[property];
    const double high = value * (1 + difference_step);
    double low = value * (1 - difference_step);
    if (property == Property::friction) low = std::max(low, task.least_friction);
    const auto values_at = [&](double changed) {
        Properties properties = best;
        properties[property] = changed;
        return task.model(properties);
    };
    const auto above = values_at(high), below = values_at(low);
    std::vector<double> slopes;
    for (std::size_t i = 0; i < above.size(); ++i)
        slopes.push_back((above[i] - below[i]) / (high - low));
    return slopes;
}

std::vector<double> half_widths(const IdentificationTask& task, const Properties& best,
                                const statistics::Fit& fit, double factor) {
    std::vector<std::vector<double>> slopes;
    for (const Property property : free_properties(task))
        slopes.push_back(slope(task, best, property));
    std::vector<double> widths;
    for (std::size_t i = 0; i < task.observed.size(); ++i) {
        double variance = 0;
        for (std::size_t k = 0; k < slopes.size(); ++k)
            for (std::size_t l = 0; l < slopes.size(); ++l)
                variance += slopes[k][i] * fit.covariance[k][l] * slopes[l][i];
        widths.push_back(factor * std::sqrt(variance));
    }
    return widths;
}

statistics::Estimate estimate_of(double value, const statistics::Estimate* linear) {
    if (!linear || !(linear->standard_error > 0) || !std::isfinite(linear->standard_error))
        return {value, contact::infinity, -contact::infinity, contact::infinity};
    return {value, linear->standard_error, linear->low, linear->high};
}

void add_goodness(const IdentificationTask& task, const BestSumOfSquares& squares,
                  Identification& found) {
    found.fitted = task.model(found.best);
    double mean = 0, sum_of_weights = 0, total = 0;
    for (std::size_t i = 0; i < task.observed.size(); ++i) {
        found.residuals.push_back(task.observed[i] - found.fitted[i]);
        mean += squares.weight(i) * task.observed[i];
        sum_of_weights += squares.weight(i);
    }
    mean /= sum_of_weights;
    for (std::size_t i = 0; i < task.observed.size(); ++i)
        total += squares.weight(i) * std::pow(task.observed[i] - mean, 2);
    found.r_squared = 1 - found.sum_of_squares / total;
    found.residual_standard_deviation = std::sqrt(found.sum_of_squares / found.degrees_of_freedom);
    if (!squares.weights().empty())
        found.goodness = gsl_cdf_chisq_Q(found.sum_of_squares, found.degrees_of_freedom);
}

}  // namespace

Identification identify(const IdentificationTask& task) {
    const BestSumOfSquares squares(task);
    LeastSquares best = squares.best();
    if (!std::isfinite(best.sum))
        throw contact::NotConverged("identification: no value of E explains the observations");
    std::optional<statistics::Fit> fit = linearised(task, squares, best);
    if (fit && !take_over(*fit, task, best)) fit.reset();

    Identification found;
    found.best = best.at;
    found.sum_of_squares = best.sum;
    found.confidence = task.confidence;
    found.degrees_of_freedom = static_cast<int>(task.observed.size()) - squares.n_free();
    found.level_of_interval = {level(task, best.sum, 1, found.degrees_of_freedom),
                               level(task, best.sum, 2, found.degrees_of_freedom)};
    std::size_t k = 0;
    for (const Property property : free_properties(task)) {
        const double value = best.at[property];
        const auto edge_at = [&](bool upwards) {
            return edge(squares, task, property, value, found.level_of_interval[0], upwards);
        };
        found[property] = {estimate_of(value, fit ? &fit->parameters[k++] : nullptr),
                           {edge_at(false), edge_at(true)}};
    }
    const bool both_told = found.young && found.friction &&
                           std::isfinite(found.young->standard_error) &&
                           std::isfinite(found.friction->standard_error);
    if (both_told)
        found.correlation =
            fit->covariance[0][1] / (found.young->standard_error * found.friction->standard_error);
    if (fit) {
        const double factor = task.standard_errors.empty()
                                  ? statistics::student_t(task.confidence, found.degrees_of_freedom)
                                  : statistics::normal_quantile(task.confidence);
        found.fitted_half_widths = half_widths(task, best.at, *fit, factor);
    }
    add_goodness(task, squares, found);
    return found;
}

Profile profile_of(const IdentificationTask& task, const Identification& found, Property property,
                   int n_points) {
    const BestSumOfSquares squares(task);
    const auto& estimate = found[property];
    if (!estimate) throw std::invalid_argument("a property that was not free has no profile");
    const double best = estimate->value;
    const double lowest =
        property == Property::friction ? task.least_friction : best / widest_profile;
    const auto [low, high] = estimate->likelihood;
    const double from = std::max(lowest, low - profile_margin * (best - low));
    const double to = std::min(best * widest_profile, high + profile_margin * (high - best));
    Profile profile;
    for (int i = 0; i < n_points; ++i) {
        profile.value.push_back(from + (to - from) * i / (n_points - 1));
        profile.sum_of_squares.push_back(squares.profile(property, profile.value.back()));
    }
    return profile;
}

std::vector<double> sums_of_squares(const IdentificationTask& task,
                                    const std::vector<double>& young,
                                    const std::vector<double>& friction) {
    const BestSumOfSquares squares(task);
    std::vector<double> sums;
    for (const double mu : friction)
        for (const double modulus : young) {
            const double sum =
                mu < task.least_friction ? contact::infinity : squares.at({modulus, mu});
            sums.push_back(std::isfinite(sum) ? sum : contact::undefined);
        }
    return sums;
}

}  // namespace tricontact::experiments
