#include <algorithm>
#include <cmath>

#include "contact/base/special_values.h"
#include "experiments/records/experiment_evaluation.h"
#include "theory/rolling/body_rolling.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::experiments {

namespace {

using contact::Case;

double tangential_ratio(const Case& c) {
    return *c.load.tangential_force / contact::half_space_scales(c).friction_limit;
}

/// w of the half-space at which the case's F_T begins to ratchet.
double amplitude_limit(const Case& c) {
    const double f = std::clamp(tangential_ratio(c), 0., 1.);
    return c.friction.is_coulomb() ? theory::amplitude_limit(f)
                                   : theory::amplitude_limit(c, f).value();
}

using OfCase = std::function<double(const Case&, double measured)>;

/// f with these numbers of the case, and one measured value behind them. Beyond the largest value
/// that a number can have f is mirrored there.
double at_numbers(const OfCase& f, Case c, const std::vector<CaseQuantity>& quantities,
                  std::vector<double> x) {
    for (std::size_t i = 0; i < quantities.size(); ++i) {
        const double largest = quantities[i].largest, beyond = x[i];
        if (beyond > largest) {
            x[i] = largest;
            const double at_end = at_numbers(f, c, quantities, x);
            x[i] = 2 * largest - beyond;
            return 2 * at_end - at_numbers(f, c, quantities, x);
        }
        quantities[i].of_case(c) = x[i];
    }
    return f(c, x.back());
}

/// Errors of the case's numbers and of one measured value propagated.
Estimate propagated(const OfCase& f, Case c, const std::vector<CaseQuantity>& quantities,
                    statistics::Correlations::Matrix correlation, const Estimate& measured) {
    std::vector<Estimate> inputs;
    for (const CaseQuantity& quantity : quantities)
        inputs.push_back({quantity.of_case(c), quantity.standard_error});
    inputs.push_back(measured);
    if (!correlation.empty()) {  // the measured value is independent of them
        for (auto& row : correlation) row.push_back(0);
        correlation.emplace_back(inputs.size(), 0.).back() = 1;
    }
    return statistics::propagate(
               [&](const std::vector<double>& x) { return at_numbers(f, c, quantities, x); },
               inputs, correlation)
        .result;
}

}  // namespace

Case as_the_rig_sets(Case c, double friction_limit, double amplitude) {
    if (c.load.tangential_ratio) {
        c.load.tangential_force = *c.load.tangential_ratio * friction_limit;
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
    const Case c = as_the_rig_sets(given, hertz.friction_limit, amplitude);
    const auto result = [&](const OfCase& f, const Estimate& measured = {}) {
        return propagated(f, c, quantities, e.correlation, measured);
    };
    const auto over_unit = [](const Case& k, double shift) {
        return shift / contact::half_space_scales(k).unit_shift;
    };
    const auto over_radius = [](const Case& k, double measured) {
        return measured / contact::half_space_scales(k).contact_radius;
    };
    const bool limit = e.limit_amplitude.has_value();
    NormalisedResults r;
    r.tangential_ratio = result([](const Case& k, double) { return tangential_ratio(k); });
    r.amplitude_ratio =
        result(over_radius, limit ? e.limit_amplitude->at_confidence : Estimate{e.amplitude, 0});
    r.unit_shift =
        result([](const Case& k, double) { return contact::half_space_scales(k).unit_shift; });
    r.static_ratio = result(over_unit, e.static_shift.at_confidence);
    Estimate last = e.final_shift.at_confidence;
    if (limit) last = e.limit_shift->at_confidence;
    if (!std::isfinite(last.standard_error)) last.standard_error = 0;  // lines nearly parallel
    r.final_ratio = result(over_unit, last);
    r.increment_ratio = result(over_unit, e.increment.at_confidence);
    r.exact_limit = result([](const Case& k, double) { return amplitude_limit(k); });
    r.exact_limit_amplitude = result([](const Case& k, double) {
        return amplitude_limit(k) * contact::half_space_scales(k).contact_radius;
    });
    r.is_coulomb = c.friction.is_coulomb();
    r.thesis_limit = r.is_coulomb
                         ? result([](const Case& k, double) { return 1 - tangential_ratio(k); })
                         : Estimate{.value = contact::undefined};
    r.radius = c.indenter.radius;
    e.normalised = r;
}

double model_wobble(const std::vector<contact::StepRecord>& steps, double begin, double angle) {
    std::vector<double> ones, phase, offset, shift;
    for (const auto& step : steps) {
        if (step.phase < begin - 1e-9) continue;  // phases are sums of rounded fractions
        ones.push_back(1);
        phase.push_back(step.phase - begin);
        offset.push_back(step.offset[0] * std::cos(angle) + step.offset[1] * std::sin(angle));
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
