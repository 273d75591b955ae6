#include "experiments/assumptions/assumption.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "contact/base/error.h"
#include "contact/base/root.h"
#include "contact/base/special_values.h"
#include "statistics/distribution.h"
#include "statistics/latin_hypercube.h"

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

std::optional<double> value_if_any(const Calculation& calculation, const Values& x) {
    try {
        const double value = calculation.function(x);
        return std::isfinite(value) ? std::optional(value) : std::nullopt;
    } catch (const contact::InputError&) {
        return {};  // no such body
    } catch (const contact::NotConverged&) {
        return {};
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
                      std::string unit, std::vector<Given> given, statistics::Quantity function,
                      statistics::Correlations::Matrix correlation) {
    std::vector<Estimate> quantities;
    for (const Given& one : given) quantities.push_back(one.value);
    const Estimate result = statistics::propagate(function, quantities, correlation).result;
    return {std::move(name),       std::move(symbol), std::move(formula),  std::move(source),
            std::move(unit),       std::move(given),  std::move(function), result,
            std::move(correlation)};
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
    if (std::abs(value - threshold) < error) return Standing::not_testable;
    return is_met_by(value) ? Standing::holds : Standing::violated;
}

double probability_of_violation(const Criterion& criterion, int n_samples) {
    constexpr std::uint64_t seed = 1;
    const std::vector<Given>& given = criterion.calculation.given;
    const auto unit = statistics::latin_hypercube(n_samples, static_cast<int>(given.size()), seed);
    const bool is_uncertain =
        std::ranges::any_of(given, [](const Given& one) { return one.value.standard_error > 0; });
    if (!is_uncertain) n_samples = 1;
    const auto root = statistics::triangular_root(criterion.calculation.correlation, given.size());
    int n_defined = 0, n_violated = 0;
    for (int j = 0; j < n_samples; ++j) {
        Values x = values_of(given);
        std::vector<double> z;
        for (const std::vector<double>& axis : unit)
            z.push_back(statistics::standard_quantile(statistics::Distribution::normal, axis[j]));
        z = statistics::correlated(root, z);
        for (std::size_t i = 0; i < x.size(); ++i) x[i] += given[i].value.standard_error * z[i];
        const auto value = value_if_any(criterion.calculation, x);
        if (!value) continue;
        ++n_defined;
        n_violated += !criterion.is_met_by(*value);
    }
    return n_defined > 0 ? static_cast<double>(n_violated) / n_defined : contact::undefined;
}

bool Criterion::is_met_by(double value) const {
    return relation == Relation::at_most ? value <= threshold : value >= threshold;
}

Standing Assumption::standing() const {
    const auto any = [&](Standing standing) {
        return std::ranges::any_of(criteria,
                                   [&](const auto& one) { return one.standing() == standing; });
    };
    if (any(Standing::violated)) return Standing::violated;
    const bool open = criteria.empty() || !missing.empty() || any(Standing::not_testable);
    return open ? Standing::not_testable : Standing::holds;
}

const Calculation* Assumption::find(std::string_view calculation) const {
    for (const Criterion& criterion : criteria)
        if (criterion.calculation.name == calculation) return &criterion.calculation;
    const auto found = std::ranges::find(background, calculation, &Calculation::name);
    return found == background.end() ? nullptr : &*found;
}

}  // namespace tricontact::experiments
