#include "experiments/identification/told_combination.h"

#include <fmt/format.h>

#include <cmath>

#include "report/format.h"

namespace tricontact::experiments {

namespace {

// A power below this part of the largest one takes no part in a product.
constexpr double least_part = .03;

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
        if (found.logarithmic.standard_errors[k] > untold_error &&
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
            if (one.parameters.empty()) first = components[i];
            one.parameters.push_back(untold[i]);
            one.exponents.push_back(components[i] / first);
        }
        one.standard_error = error / std::abs(first);
        if (one.parameters.size() > 1 && one.standard_error < untold_error)
            combinations.push_back(std::move(one));
    }
    return combinations;
}

std::string sentence(const ToldCombination& combination, const Identification& found) {
    std::string names, product, alone;
    for (std::size_t i = 0; i < combination.parameters.size(); ++i) {
        const std::size_t k = combination.parameters[i];
        const std::string& symbol = found.free[k].symbol;
        const bool is_last = i + 1 == combination.parameters.size();
        names += (i == 0 ? "" : is_last ? " and " : ", ") + symbol;
        product += (i == 0 ? "" : " ") + power(symbol, combination.exponents[i]);
        alone += fmt::format("{}{}: {}", i == 0 ? "" : ", ", symbol,
                             told_to(found.logarithmic.standard_errors[k]));
    }
    return fmt::format(
        "{} are told only in the combination {} (standard error {} %), not each alone ({}).", names,
        product, report::significant(100 * combination.standard_error, 2), alone);
}

}  // namespace tricontact::experiments
