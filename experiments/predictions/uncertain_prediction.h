#pragma once

#include <optional>
#include <string>
#include <vector>

#include "atlas/prediction.h"
#include "experiments/predictions/uncertain_case.h"
#include "statistics/sobol_indices.h"

namespace tricontact::experiments {

/// A predicted quantity over the uncertain numbers of a case.
struct SampledQuantity {
    const comparisons::Quantity* quantity = nullptr;
    double mean = 0, standard_deviation = 0;
    double low = 0, high = 0;  ///< quantiles of 2.5 and 97.5 %
    /// Empty where numbers are correlated: the variance is no sum of shares then.
    std::optional<statistics::SobolIndices> indices;
};

/// What samples of the uncertain numbers make of a prediction.
struct SampledPrediction {
    std::string model;
    std::vector<std::string> numbers;  ///< keys, in the order of the indices
    int n_samples = 0;                 ///< drawn; Sobol's indices took some more
    double outside = 0;                ///< share of which the atlases say nothing
    std::optional<double> ratchets;    ///< share of the others; empty if nothing rolls
    std::vector<SampledQuantity> quantities;
};

/// By 2 n_samples points of Sobol's sequence through the quantiles of the numbers' distributions,
/// which are correlated by a Gaussian copula: the coefficients are those of the
/// normal variables behind them, and of the numbers themselves where these are normal (of uniform
/// ones they are (6/pi) asin(r/2), at most .018 less). What lies beyond the end of a number's range
/// is mirrored there. Quantities are those that the prediction of the values has, of samples that
/// have them. Throws contact::InputError as atlas::predict() and uncertain_case().
SampledPrediction sampled_prediction(const contact::Case& c, const std::string& model,
                                     const std::vector<io::UncertainKey>& uncertain,
                                     const statistics::Correlations& correlations, int n_samples);

}  // namespace tricontact::experiments
