#include "experiments/identification/estimation/told_combination.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/format.h"
#include "statistics/estimate.h"

namespace tricontact::experiments {

namespace {

// A power below this part of the largest one takes no part in a product.
constexpr double least_part = .03;

/// Slope of a parameter's relative change by ln |v|: 1 unless it has either sign.
double slope_of_change(const Identification& found, std::size_t k) {
    const double value = found.parameters[k].value;
    return value / found.free[k].unit_of_change(value);
}

/// Standard error of ln |v|; where bounds tell more than the linearised likelihood, of an interval
/// as wide as that of the likelihood.
double error_alone(const Identification& found, std::size_t k) {
    const double linearised =
        found.logarithmic.standard_errors[k] / std::abs(slope_of_change(found, k));
    const auto [low, high] = found.parameters[k].likelihood;
    if (!(low > 0 && std::isfinite(high))) return linearised;
    return std::min(linearised,
                    std::log(high / low) / (2 * statistics::normal_quantile(found.confidence)));
}

std::string power(const std::string& symbol, double exponent) {
    if (std::abs(exponent - 1) < .005) return symbol;
    return symbol + "^" + report::significant(exponent, 2);
}

/// "80 %", "at all".
std::string told_to(double error) {
    if (error > 1e3) return "not at all";
    if (error > 1) return "within a factor of " + report::significant(std::exp(error), 2);
    return report::significant(100 * error, 2) + " %";
}

}  // namespace

std::vector<ToldCombination> told_combinations(const Identification& found) {
    std::vector<std::size_t> untold;
    for (std::size_t k = 0; k < found.free.size(); ++k)
        if (error_alone(found, k) > untold_error &&
            !found.free[k].is_at_bound(found.parameters[k].value))
            untold.push_back(k);
    std::vector<ToldCombination> combinations;
    if (untold.size() < 2) return combinations;
    for (const auto& [components, error] :
         statistics::principal_directions(found.logarithmic, untold)) {
        double largest = 0;
        for (const double c : components) largest = std::max(largest, std::abs(c));
        ToldCombination one;
        double first = 0;
        for (std::size_t i = 0; i < components.size(); ++i) {
            if (std::abs(components[i]) < least_part * largest) continue;
            const double power = components[i] * slope_of_change(found, untold[i]);
            if (one.parameters.empty()) first = power;
            one.parameters.push_back(untold[i]);
            one.exponents.push_back(power / first);
        }
        one.standard_error = error / std::abs(first);
        if (one.parameters.size() > 1 && one.standard_error < untold_error)
            combinations.push_back(std::move(one));
    }
    return combinations;
}

std::string sentence(const ToldCombination& combination, const Identification& found) {
    std::string names, product, alone, where;
    for (std::size_t i = 0; i < combination.parameters.size(); ++i) {
        const std::size_t k = combination.parameters[i];
        const std::string& symbol = found.free[k].symbol;
        const bool is_last = i + 1 == combination.parameters.size();
        names += (i == 0 ? "" : is_last ? " and " : ", ") + symbol;
        product += (i == 0 ? "" : " ") + power(symbol, combination.exponents[i]);
        if (found.free[k].scale == FreeParameter::Scale::linear) where = " near the best values";
        alone +=
            fmt::format("{}{}: {}", i == 0 ? "" : ", ", symbol, told_to(error_alone(found, k)));
    }
    return fmt::format(
        "{} are identifiable only in the combination {}{} (standard error {} %), not each alone "
        "({}).",
        names, product, where, report::significant(100 * combination.standard_error, 2), alone);
}

}  // namespace tricontact::experiments
