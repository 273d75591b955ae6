#include "comparisons/shakedown/fitted_form.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "contact/base/error.h"
#include "contact/base/special_values.h"

namespace tricontact::comparisons {

namespace {

// Of the observed values, below which their spread is rounding: nothing varies that a fit explains.
constexpr double rounding_of_observed = 1e-9;

}  // namespace

Goodness goodness(const std::vector<double>& observed, const std::vector<double>& fitted) {
    const double mean = std::accumulate(observed.begin(), observed.end(), 0.) /
                        static_cast<double>(observed.size());
    Goodness g;
    double spread = 0;
    for (std::size_t i = 0; i < observed.size(); ++i) {
        g.explained += (fitted[i] - mean) * (fitted[i] - mean);
        g.residual += (observed[i] - fitted[i]) * (observed[i] - fitted[i]);
        spread = std::max(spread, std::abs(observed[i] - mean));
    }
    g.r_squared = spread > rounding_of_observed * std::abs(mean)
                      ? g.explained / (g.explained + g.residual)
                      : contact::undefined;
    return g;
}

std::optional<FittedForm> fit_form(const std::string& form,
                                   const std::vector<std::string>& parameters,
                                   const std::vector<std::vector<double>>& columns,
                                   const std::vector<double>& observed, double confidence,
                                   std::size_t least_n, const std::vector<double>& offset) {
    const std::size_t n = observed.size();
    if (n < least_n || n <= parameters.size()) return {};
    std::vector<double> y = observed;
    for (std::size_t i = 0; i < offset.size(); ++i) y[i] -= offset[i];
    FittedForm result{.form = form, .parameters = parameters, .fit = {}, .of_left_side = {}};
    try {
        result.fit = statistics::fit_linear(columns, y, {.confidence = confidence});
    } catch (const contact::NotConverged&) {
        return {};
    }
    std::vector<double> fitted = result.fit.fitted;
    for (std::size_t i = 0; i < offset.size(); ++i) fitted[i] += offset[i];
    result.of_left_side = goodness(observed, fitted);
    return result;
}

}  // namespace tricontact::comparisons
