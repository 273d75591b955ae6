#include "experiments/validation/student_sum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "contact/base/root.h"
#include "statistics/estimate.h"

namespace tricontact::experiments {

namespace {

constexpr double level_of_sum = .95;
constexpr double as_good_as_known = 1e4;  // degrees of freedom
constexpr int n_nodes = 96;

/// A scale of a variance that was estimated by few values: true over estimated.
struct Node {
    double scale = 0, probability = 0;
};

/// nu/chi^2, by the trapezoidal rule over x = ln(chi^2/nu), whose density exp(nu (x - e^x)/2) is
/// analytic and dies out on both sides: exact but for rounding.
std::array<Node, n_nodes> nodes_of(double degrees_of_freedom) {
    const double width = std::sqrt(2 / degrees_of_freedom);  // of x, for many degrees
    const double low = -std::max(8 * width, 50 / degrees_of_freedom),
                 high = std::min(4., 8 * width);
    std::array<Node, n_nodes> nodes;
    double sum = 0;
    for (int i = 0; i < n_nodes; ++i) {
        const double x = low + (high - low) * i / (n_nodes - 1);
        Node& node = nodes[static_cast<std::size_t>(i)];
        node.scale = std::exp(-x);
        node.probability = std::exp(degrees_of_freedom / 2 * (x - std::exp(x) + 1));
        sum += node.probability;
    }
    for (Node& node : nodes) node.probability /= sum;
    return nodes;
}

/// The smaller ones of more than two are put together.
void reduce(std::vector<EstimatedError>& errors) {
    std::ranges::sort(errors, std::greater(), &EstimatedError::standard_error);
    if (errors.size() <= 2) return;
    double variance = 0, sum = 0;
    for (std::size_t i = 1; i < errors.size(); ++i) {
        const double one = errors[i].standard_error * errors[i].standard_error;
        variance += one;
        sum += one * one / errors[i].degrees_of_freedom;
    }
    errors.resize(2);
    errors[1] = {std::sqrt(variance), variance * variance / sum};
}

/// The half width at which `beyond`, which decreases, falls to 5 %, by bisection: the same digits
/// however it comes about. The root is found first, and tells the sides of what is not close to it.
template <class Beyond>
double solve(double standard_error, const Beyond& beyond) {
    constexpr double least = 1 - level_of_sum;
    constexpr double close = 1e-11;  // of the root, whose own error is a hundredth of it
    constexpr int root_bits = 44, bisections = 40;
    double low = 0, high = 2 * standard_error, at_low = level_of_sum, at_high = 0;
    while ((at_high = beyond(high) - least) > 0) {
        low = high;
        at_low = at_high;
        high *= 2;
    }
    const double root =
        contact::bracketed_root([&](double half_width) { return beyond(half_width) - least; }, low,
                                high, at_low, at_high, root_bits);
    low = 0;
    for (int i = 0; i < bisections; ++i) {
        const double middle = (low + high) / 2;
        const bool is_low =
            std::abs(middle - root) > close * root ? middle < root : beyond(middle) > least;
        (is_low ? low : high) = middle;
    }
    return (low + high) / 2;
}

}  // namespace

double half_width_of_sum(double known_variance, std::vector<EstimatedError> estimated) {
    std::erase_if(estimated, [&](const EstimatedError& one) {
        if (one.degrees_of_freedom < as_good_as_known) return one.standard_error == 0;
        known_variance += one.standard_error * one.standard_error;
        return true;
    });
    known_variance = std::max(known_variance, 0.);
    if (estimated.empty())
        return statistics::normal_quantile(level_of_sum) * std::sqrt(known_variance);
    reduce(estimated);
    const double degrees = estimated.front().degrees_of_freedom;
    if (estimated.size() == 1 && known_variance == 0 && degrees == std::round(degrees))
        return statistics::student_t(level_of_sum, static_cast<int>(degrees)) *
               estimated.front().standard_error;
    std::vector<Node> variances{{known_variance, 1}};
    double all = known_variance;
    for (const EstimatedError& one : estimated) {
        const double variance = one.standard_error * one.standard_error;
        all += variance;
        std::vector<Node> next;
        for (const Node& before : variances)
            for (const Node& node : nodes_of(one.degrees_of_freedom)) {
                constexpr double least_probability = 1e-9;
                const double probability = before.probability * node.probability;
                if (probability > least_probability)
                    next.push_back({before.scale + variance * node.scale, probability});
            }
        variances = std::move(next);
    }
    return solve(std::sqrt(all), [&](double half_width) {
        double beyond = 0;
        for (const Node& node : variances)
            beyond += node.probability * std::erfc(half_width / std::sqrt(2 * node.scale));
        return beyond;
    });
}

}  // namespace tricontact::experiments
