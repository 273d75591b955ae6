#include "experiments/design/planned_comparison.h"

#include <cmath>

namespace tricontact::experiments {

InputErrors input_errors(const CaseResult& result, const contact::Case& set,
                         const std::vector<CaseQuantity>& quantities,
                         const statistics::Correlations::Matrix& correlation) {
    InputErrors errors;
    std::vector<double> changes;
    contact::Case at = set;
    for (const CaseQuantity& one : quantities) {
        double& number = one.of_case(at);
        const double value = number, error = one.standard_error;
        const bool at_end = value + error > one.largest;
        number = at_end ? value : value + error;
        const double above = result(at);
        number = value - error;
        const double below = result(at);
        number = value;
        changes.push_back((above - below) / (at_end ? 1 : 2));
        errors.sources.push_back({one.name, std::abs(changes.back())});
    }
    errors.covariance = statistics::covariance_part(changes, correlation);
    return errors;
}

ComparisonError planned_comparison(double computed, InputErrors inputs, const RecordPlan& record) {
    if (record.scatter) {
        UncertaintySource runs{"repeated runs", *record.scatter / std::sqrt(record.repeats)};
        if (record.repeats > 1) runs.degrees_of_freedom = record.repeats - 1;
        inputs.sources.push_back(std::move(runs));
    }
    // A uniform distribution over one step (JCGM 100:2008, 4.3.7).
    if (record.step) inputs.sources.push_back({"record.resolution", *record.step / std::sqrt(12.)});
    return {computed, computed, std::move(inputs.sources), inputs.covariance};
}

}  // namespace tricontact::experiments
