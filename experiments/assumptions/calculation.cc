#include "experiments/assumptions/calculation.h"

#include <cmath>
#include <optional>
#include <stdexcept>

#include "contact/error.h"
#include "theory/bracketed_root.h"

namespace tricontact::experiments {

namespace {

constexpr double widest_factor = 1e6;

// Factor on the i-th quantity that makes the result `wanted`; empty if none within `widest_factor`
// does. Formulas here are monotonic in each quantity.
std::optional<double> factor_for(const Calculation& calculation, std::size_t i, double wanted) {
    std::vector<double> x = values_of(calculation.given);
    const double value = x[i];
    const auto excess = [&](double log_factor) {
        x[i] = value * std::exp(log_factor);
        return calculation.function(x) - wanted;
    };
    const double widest = std::log(widest_factor);
    try {
        const double low = excess(-widest), high = excess(widest);
        if (!std::isfinite(low) || !std::isfinite(high) || low * high >= 0) return {};
        return std::exp(theory::bracketed_root(excess, -widest, widest, low, high, 40));
    } catch (const contact::InputError&) {
        return {};  // such a body does not exist: Poisson's ratio above 1/2
    } catch (const std::domain_error&) {
        return {};
    }
}

}  // namespace

std::vector<double> values_of(const std::vector<Given>& given) {
    std::vector<double> values;
    for (const Given& one : given) values.push_back(one.value.value);
    return values;
}

Calculation calculate(std::string name, std::string symbol, std::string formula, std::string source,
                      std::string unit, std::vector<Given> given, statistics::Quantity function) {
    std::vector<statistics::Uncertain> quantities;
    for (const Given& one : given) quantities.push_back(one.value);
    const statistics::Uncertain result = statistics::propagate(function, quantities).result;
    return {std::move(name), std::move(symbol), std::move(formula),  std::move(source),
            std::move(unit), std::move(given),  std::move(function), result};
}

std::vector<Substitute> substitutes(const Calculation& calculation, double wanted) {
    std::vector<Substitute> found;
    for (std::size_t i = 0; i < calculation.given.size(); ++i) {
        const Given& one = calculation.given[i];
        if (const auto factor = factor_for(calculation, i, wanted))
            found.push_back({one.symbol, one.value.value * *factor, one.value.value, one.unit});
    }
    return found;
}

}  // namespace tricontact::experiments
