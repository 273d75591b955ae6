#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "contact/case.h"
#include "experiments/records/experiment_evaluation.h"
#include "experiments/validation/comparison_error.h"

namespace tricontact::experiments {

/// What is known beforehand about the record of a quantity.
struct RecordPlan {
    std::optional<double> scatter;  ///< standard deviation over repeated runs [m]
    std::optional<double> step;     ///< of the recorded shift [m]
    int repeats = 1;
};

/// A result [m] of a case; throws contact::InputError where it has none.
using CaseResult = std::function<double(const contact::Case&)>;

/// What the numbers of a case give to a result.
struct InputErrors {
    std::vector<UncertaintySource> sources;
    double covariance = 0;  ///< as of a ComparisonError
};

/// By a standard error of each number and central differences; of a number at the end of its range
/// by a difference to its inside. `set`: see as_the_rig_sets(). `correlation`: of the quantities;
/// empty: independent.
InputErrors input_errors(const CaseResult& result, const contact::Case& set,
                         const std::vector<CaseQuantity>& quantities,
                         const statistics::Correlations::Matrix& correlation = {});

/// The comparison of a result that is yet to be measured: measured and computed are equal. Adds
/// what the record will give: the scatter of the mean of the runs, known by one value less than
/// there are runs from two runs on (as experiment takes it from them), and the step, uniform.
ComparisonError planned_comparison(double computed, InputErrors inputs, const RecordPlan& record);

}  // namespace tricontact::experiments
