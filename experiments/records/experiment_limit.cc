#include "experiments/records/experiment_limit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "statistics/error_propagation.h"

namespace tricontact::experiments {

namespace {

statistics::Fit line_of(const StageEvaluation& stage, double origin, double confidence) {
    std::vector<double> time = stage.time;
    for (double& t : time) t -= origin;
    return fit_polynomial(time, stage.shift, 1, confidence);
}

}  // namespace

LineIntersection intersect(const StageEvaluation& before, const StageEvaluation& after,
                           double confidence) {
    const double origin = after.time.front();  // near the intersection
    const statistics::Fit lines[] = {line_of(before, origin, confidence),
                                     line_of(after, origin, confidence)};
    std::vector<Estimate> numbers;
    std::vector<std::vector<double>> correlation(4, std::vector<double>(4, 0.));
    for (std::size_t l = 0; l < 2; ++l)
        for (std::size_t k = 0; k < 2; ++k) {
            const Estimate& p = lines[l].parameters[k];
            numbers.push_back(p);
            for (std::size_t j = 0; j < 2; ++j) {
                const double both = p.standard_error * lines[l].parameters[j].standard_error;
                correlation[2 * l + k][2 * l + j] =
                    both > 0 ? lines[l].covariance[k][j] / both : (j == k ? 1. : 0.);
            }
        }
    const auto time = [](const std::vector<double>& p) { return (p[2] - p[0]) / (p[1] - p[3]); };
    const auto shift = [&](const std::vector<double>& p) { return p[0] + p[1] * time(p); };

    LineIntersection result;
    result.slopes[0] = numbers[1].value;
    result.slopes[1] = numbers[3].value;
    const std::vector<double> p{numbers[0].value, numbers[1].value, numbers[2].value,
                                numbers[3].value};
    result.time = origin + time(p);
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    result.shift = {shift(p), nan, nan, nan};
    // First order fails where the difference of the slopes is not well above its error.
    const double difference = std::abs(numbers[3].value - numbers[1].value);
    if (difference < 3 * std::hypot(numbers[1].standard_error, numbers[3].standard_error))
        return result;
    const double error = statistics::propagate(shift, numbers, correlation).result.standard_error;
    const int freedom = std::min(lines[0].degrees_of_freedom, lines[1].degrees_of_freedom);
    result.shift =
        statistics::with_interval(shift(p), error, statistics::student_t(confidence, freedom));
    return result;
}

std::optional<LimitReading> read_limit(const RunEvaluation& run,
                                       contact::State StageEvaluation::*verdict,
                                       double confidence) {
    using contact::State;
    const auto& stages = run.stages;
    const auto first = std::ranges::find(stages, State::ratcheting, verdict);
    if (first == stages.end()) return {};
    const auto last = std::find_if(std::make_reverse_iterator(first), stages.rend(),
                                   [&](const auto& s) { return s.*verdict == State::shakedown; });
    if (last == stages.rend()) return {};
    LimitReading reading;
    reading.ratcheting = static_cast<std::size_t>(first - stages.begin());
    reading.shakedown = static_cast<std::size_t>(stages.rend() - last) - 1;
    reading.amplitude_low = last->amplitude;
    reading.amplitude_high = first->amplitude;
    reading.lines = intersect(*last, *first, confidence);
    return reading;
}

}  // namespace tricontact::experiments
