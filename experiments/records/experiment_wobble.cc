#include <cmath>

#include "experiments/records/experiment_evaluation.h"

namespace tricontact::experiments {

double model_wobble(const contact::Case& c, const contact::History& history) {
    const double begin = history.steps.back().phase - 1;
    std::vector<double> ones, phase, offset, shift;
    for (const auto& step : history.steps) {
        if (step.phase < begin - 1e-9) continue;  // phases are sums of rounded fractions
        ones.push_back(1);
        phase.push_back(step.phase - begin);
        offset.push_back(step.offset[0] * std::cos(c.rolling->angle) +
                         step.offset[1] * std::sin(c.rolling->angle));
        shift.push_back(step.shift[0]);
    }
    return statistics::fit_linear({ones, phase, offset}, shift).parameters[2].value;
}

statistics::Uncertain pivot_height(const ExperimentEvaluation& e, double own_wobble) {
    const statistics::Estimate& measured = e.wobble->at_confidence;
    return {e.normalised->radius * (measured.value - own_wobble),
            e.normalised->radius * measured.standard_error};
}

}  // namespace tricontact::experiments
