#include "experiments/assumptions/assumption.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "contact/error.h"
#include "contact/root.h"

namespace tricontact::experiments {

namespace {

constexpr double widest_factor = 1e6;

// Factor on the i-th quantity that makes the result `wanted`; empty if none within `widest_factor`
// does. Formulas here are monotonic in each quantity.
std::optional<double> factor_for(const Calculation& calculation, std::size_t i, double wanted) {
    Values x = values_of(calculation.given);
    const double value = x[i];
    const auto excess = [&](double log_factor) {
        x[i] = value * std::exp(log_factor);
        return calculation.function(x) - wanted;
    };
    const double widest = std::log(widest_factor);
    try {
        const double low = excess(-widest), high = excess(widest);
        if (!std::isfinite(low) || !std::isfinite(high) || low * high >= 0) return {};
        return std::exp(contact::bracketed_root(excess, -widest, widest, low, high, 40));
    } catch (const contact::InputError&) {
        return {};  // such a body does not exist: Poisson's ratio above 1/2
    } catch (const std::domain_error&) {
        return {};
    }
}

}  // namespace

Values values_of(const std::vector<Given>& given) {
    Values values;
    for (const Given& one : given) values.push_back(one.value.value);
    return values;
}

Calculation calculate(std::string name, std::string symbol, std::string formula, std::string source,
                      std::string unit, std::vector<Given> given, statistics::Quantity function) {
    std::vector<Estimate> quantities;
    for (const Given& one : given) quantities.push_back(one.value);
    const Estimate result = statistics::propagate(function, quantities).result;
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

Standing Criterion::standing() const {
    const double value = calculation.result.value, error = calculation.result.standard_error;
    if (std::abs(value - threshold) < error) return Standing::cannot_tell;
    const bool holds = relation == Relation::at_most ? value <= threshold : value >= threshold;
    return holds ? Standing::holds : Standing::fails;
}

Standing Assumption::standing() const {
    const auto any = [&](Standing standing) {
        return std::ranges::any_of(criteria,
                                   [&](const auto& one) { return one.standing() == standing; });
    };
    if (any(Standing::fails)) return Standing::fails;
    const bool open = criteria.empty() || !missing.empty() || any(Standing::cannot_tell);
    return open ? Standing::cannot_tell : Standing::holds;
}

}  // namespace tricontact::experiments
