#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "comparisons/shakedown/rolling_points.h"

namespace tricontact::comparisons {

/// One quantity of one point by two models.
struct PointDifference {
    double amplitude_ratio = 0, tangential_ratio = 0;  ///< w, f_T of the second model
    Computed first, second;

    double relative() const { return first.value / second.value - 1; }
    /// Half width of the bar of `relative`, both errors over the second value; NaN: not known.
    double bar() const { return (first.error + second.error) / std::abs(second.value); }
};

/// Two models side by side in one group: a quantity at the points where both have it.
struct ModelDifference {
    const Quantity* quantity = nullptr;
    std::string first, second, group;
    std::vector<PointDifference> points;  ///< not empty

    double median() const;  ///< of the magnitudes of the relative differences
    /// Of the points where the bars do not overlap, else of all.
    const PointDifference& worst() const;
    int n_with_bars() const;  ///< points where both models have a bar
    int n_different() const;  ///< of these: the bars do not overlap
};

/// Every pair of models, in the order of the points; each with its own w, f_T and U_max.
std::vector<ModelDifference> model_differences(const std::vector<RollingPoint>& points);

/// "differs by -12.3 % (median of magnitudes 9.8 %)", or what keeps that from being said: no bars,
/// or none beyond the numerical error.
std::string difference_sentence(const ModelDifference& difference);

}  // namespace tricontact::comparisons
