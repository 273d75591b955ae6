#include <algorithm>
#include <cmath>

#include "experiments/records/experiment_evaluation.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::experiments {

namespace {

using contact::Case;

double tangential_ratio(const Case& c) {
    return *c.load.tangential_force /
           (c.friction_coefficient * contact::half_space_scales(c).normal_force);
}

/// Functions of the case and of one measured value, errors of both propagated.
class Propagation {
  public:
    Propagation(const Case& c, const std::vector<CaseQuantity>& quantities)
        : case_(c), quantities_(quantities) {
        Case copy = c;
        for (const CaseQuantity& quantity : quantities)
            inputs_.push_back({quantity.of_case(copy), quantity.standard_error});
    }

    template <class Function>
    Estimate operator()(Function f, const Estimate& measured) const {
        std::vector<Estimate> inputs = inputs_;
        inputs.push_back(measured);
        const std::function<double(std::vector<double>)> of_numbers =
            [&](const std::vector<double>& x) {
                Case changed = case_;
                for (std::size_t i = 0; i < quantities_.size(); ++i) {
                    const double largest = quantities_[i].largest;
                    if (x[i] > largest)
                        return 2 * of_numbers(with(x, i, largest)) -
                               of_numbers(with(x, i, 2 * largest - x[i]));
                    quantities_[i].of_case(changed) = x[i];
                }
                return f(changed, x.back());
            };
        return statistics::propagate(of_numbers, inputs).result;
    }
    template <class Function>
    Estimate operator()(Function f) const {
        return (*this)([&](const Case& c, double) { return f(c); }, Estimate{});
    }

  private:
    static std::vector<double> with(std::vector<double> x, std::size_t i, double value) {
        x[i] = value;
        return x;
    }

    const Case& case_;
    const std::vector<CaseQuantity>& quantities_;
    std::vector<Estimate> inputs_;
};

}  // namespace

Case as_the_rig_sets(Case c, double normal_force, double amplitude) {
    if (c.load.tangential_ratio) {
        c.load.tangential_force = *c.load.tangential_ratio * c.friction_coefficient * normal_force;
        c.load.tangential_ratio.reset();
    }
    if (c.rolling && c.rolling->amplitude_ratio) {
        c.rolling->amplitude = amplitude;
        c.rolling->amplitude_ratio.reset();
    }
    return c;
}

void normalise(ExperimentEvaluation& e, const Case& given,
               const std::vector<CaseQuantity>& quantities) {
    const contact::HalfSpaceScales hertz = contact::half_space_scales(given);
    const double amplitude =
        given.rolling ? contact::rolling_amplitude(*given.rolling, hertz.contact_radius) : 0;
    const Case c = as_the_rig_sets(given, hertz.normal_force, amplitude);
    const Propagation propagated(c, quantities);
    const auto over_unit = [](const Case& k, double shift) {
        return shift / contact::half_space_scales(k).unit_shift;
    };
    const auto over_radius = [](const Case& k, double amplitude) {
        return amplitude / contact::half_space_scales(k).contact_radius;
    };
    const bool limit = e.limit_amplitude.has_value();
    NormalisedResults r;
    r.tangential_ratio = propagated(tangential_ratio);
    r.amplitude_ratio = propagated(
        over_radius, limit ? e.limit_amplitude->at_confidence : Estimate{e.amplitude, 0});
    r.unit_shift =
        propagated([](const Case& k) { return contact::half_space_scales(k).unit_shift; });
    r.static_ratio = propagated(over_unit, e.static_shift.at_confidence);
    Estimate last = e.final_shift.at_confidence;
    if (limit) last = e.limit_shift->at_confidence;
    if (!std::isfinite(last.standard_error)) last.standard_error = 0;  // lines nearly parallel
    r.final_ratio = propagated(over_unit, last);
    r.increment_ratio = propagated(over_unit, e.increment.at_confidence);
    r.exact_limit = propagated([](const Case& k) {
        return theory::amplitude_limit(std::clamp(tangential_ratio(k), 0., 1.));
    });
    r.thesis_limit = propagated([](const Case& k) { return 1 - tangential_ratio(k); });

    r.radius = c.indenter.radius;
    e.normalised = r;
}

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

Estimate pivot_height(const ExperimentEvaluation& e, double own_wobble) {
    const Estimate& measured = e.wobble->at_confidence;
    return {e.normalised->radius * (measured.value - own_wobble),
            e.normalised->radius * measured.standard_error};
}

}  // namespace tricontact::experiments
