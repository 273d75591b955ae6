#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/uncertain_case.h"
#include "atlas/prediction.h"
#include "statistics/sobol_indices.h"

namespace tricontact::app {

/// A predicted quantity over the uncertain numbers of a case.
struct SampledQuantity {
    const comparisons::Quantity* quantity = nullptr;
    double mean = 0, standard_deviation = 0;
    double low = 0, high = 0;  ///< quantiles of 2.5 and 97.5 %
    statistics::SobolIndices indices;
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
/// which are independent. What lies beyond the end of a number's range is mirrored there.
/// Quantities are those that the prediction of the values has, of samples that have them. Throws
/// contact::InputError as atlas::predict() and uncertain_case().
SampledPrediction sampled_prediction(const contact::Case& c, const std::string& model,
                                     const std::vector<io::UncertainKey>& uncertain, int n_samples);

}  // namespace tricontact::app
