#include "experiments/predictions/uncertain_prediction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/base/error.h"
#include "contact/base/interruption.h"
#include "contact/base/special_values.h"
#include "statistics/distribution.h"
#include "statistics/sample_quantile.h"

namespace tricontact::experiments {

namespace {

using contact::Case;

constexpr double least_share = 1e-6;  // of a number's value: what a distribution reaches below 0

double drawn(const CaseQuantity& number, double value, double u) {
    double x =
        value + number.standard_error * statistics::standard_quantile(number.distribution, u);
    if (x > number.largest) x = 2 * number.largest - x;
    return value > 0 ? std::max(x, least_share * value) : x;
}

/// Uniform numbers in place of independent ones, by a Gaussian copula. `root`: see
/// statistics::triangular_root().
std::vector<double> by_copula(const std::vector<double>& independent,
                              const statistics::Correlations::Matrix& root) {
    std::vector<double> z;
    for (const double u : independent)
        z.push_back(statistics::standard_quantile(statistics::Distribution::normal, u));
    z = statistics::correlated(root, z);
    for (double& value : z) value = std::erfc(-value / std::numbers::sqrt2) / 2;
    return z;
}

/// One if it ratchets, zero if it settles, NaN where that is not said.
double ratchets(contact::State state) {
    switch (state) {
        case contact::State::ratcheting:
            return 1;
        case contact::State::shakedown:
            return 0;
        default:
            return contact::undefined;
    }
}

std::optional<atlas::Prediction> prediction_if_any(const Case& c, const std::string& model) {
    try {
        return atlas::predict(c, model);
    } catch (const contact::InputError&) {  // beyond the maps
        return {};
    }
}

/// Of the values of one function at all points; none where it is undefined.
std::vector<double> defined_values(const statistics::SobolSample& sample, std::size_t function) {
    std::vector<double> values;
    for (const std::vector<double>& row : sample.values)
        if (std::isfinite(row[function])) values.push_back(row[function]);
    return values;
}

SampledQuantity described(const comparisons::Quantity& q, std::vector<double> values,
                          const std::optional<statistics::SobolIndices>& indices) {
    SampledQuantity result{.quantity = &q, .indices = indices};
    const auto n = static_cast<double>(values.size());
    for (const double value : values) result.mean += value / n;
    for (const double value : values)
        result.standard_deviation += std::pow(value - result.mean, 2) / (n - 1);
    result.standard_deviation = std::sqrt(result.standard_deviation);
    result.low = statistics::sample_quantile(values, .025);
    result.high = statistics::sample_quantile(std::move(values), .975);
    return result;
}

}  // namespace

SampledPrediction sampled_prediction(const Case& c, const std::string& model,
                                     const std::vector<io::UncertainKey>& uncertain,
                                     const statistics::Correlations& correlations, int n_samples) {
    const UncertainCase numbers = uncertain_case(c, uncertain);
    const std::vector<std::string> names = numbers.names();
    const auto correlation = correlations.of(names);
    const auto root = statistics::triangular_root(correlation, names.size());
    const atlas::Prediction nominal = atlas::predict(numbers.set, model);
    Case values = numbers.set;
    const auto functions = [&](const std::vector<double>& independent) {
        contact::interruption_point();
        const std::vector<double> u =
            correlation.empty() ? independent : by_copula(independent, root);
        Case at = numbers.set;
        for (std::size_t i = 0; i < numbers.quantities.size(); ++i) {
            const CaseQuantity& number = numbers.quantities[i];
            number.of_case(at) = drawn(number, number.of_case(values), u[i]);
        }
        std::vector<double> found(nominal.entries.size() + 2, contact::undefined);
        const auto prediction = prediction_if_any(at, model);
        found[0] = prediction ? 0 : 1;
        if (!prediction) return found;
        found[1] = ratchets(prediction->state);
        for (std::size_t k = 0; k < nominal.entries.size(); ++k)
            if (const auto* entry = prediction->find(*nominal.entries[k].quantity))
                found[k + 2] = entry->value.value;
        return found;
    };
    const statistics::SobolSample sample = statistics::sobol_indices(
        functions, static_cast<int>(numbers.quantities.size()), n_samples);
    SampledPrediction result{.model = model, .n_samples = static_cast<int>(sample.points.size())};
    result.numbers = names;
    result.outside = sample.indices[0].mean;
    if (const auto states = defined_values(sample, 1); !states.empty()) {
        result.ratchets = 0;
        for (const double one : states)
            *result.ratchets += one / static_cast<double>(states.size());
    }
    constexpr std::size_t enough = 20;  // for quantiles of 2.5 %
    for (std::size_t k = 0; k < nominal.entries.size(); ++k)
        if (auto found = defined_values(sample, k + 2); found.size() >= enough)
            result.quantities.push_back(described(
                *nominal.entries[k].quantity, std::move(found),
                correlation.empty() ? std::optional(sample.indices[k + 2]) : std::nullopt));
    return result;
}

}  // namespace tricontact::experiments
