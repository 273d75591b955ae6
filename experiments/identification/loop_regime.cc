#include "experiments/identification/loop_regime.h"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>

#include "experiments/identification/identification_models.h"
#include "experiments/identification/law_parameters.h"

namespace tricontact::experiments {

namespace {

// Ways to sliding are alike within this, beyond which none is looked at: e^3 is certain.
constexpr double same_way = .002, farthest_way = 3;
constexpr double difference = 1e-3;  // of a parameter, relative

/// Relative standard error of the shift at which all slides, linearised.
double error_of_sliding(const IdentificationInput& input, const Identification& found) {
    const auto best = found.best();
    const auto shift_of = [&](const std::vector<double>& values) {
        const IdentifiedRig rig = rig_with(input, found.free, values);
        return loop_curve(rig, *input.rig.load.normal_force).sliding_shift();
    };
    const double middle = shift_of(best);
    std::vector<double> slopes;
    for (std::size_t k = 0; k < best.size(); ++k) {
        auto moved = best;
        moved[k] = found.free[k].changed(best[k], difference);
        slopes.push_back((shift_of(moved) / middle - 1) / difference);
    }
    double variance = 0;
    for (std::size_t k = 0; k < slopes.size(); ++k)
        for (std::size_t l = 0; l < slopes.size(); ++l)
            variance += slopes[k] * found.logarithmic.adjusted[k][l] * slopes[l];
    return std::sqrt(std::max(1e-12, variance));
}

}  // namespace

SlidingChance::SlidingChance(const IdentificationInput& input, const IdentificationTask& task,
                             const Identification& found)
    : found_(found), squares_(task, [&] {
          std::vector<double> errors;
          for (const TableFit& table : found.tables)
              errors.insert(errors.end(), table.standard_errors.begin(),
                            table.standard_errors.end());
          return errors;
      }()) {
    const auto is_friction = [](const FreeParameter& p) { return is_of_law(p.key); };
    const auto place = std::ranges::find_if(found.free, is_friction);
    friction_ = static_cast<std::size_t>(place - found.free.begin());
    has_profile_ = std::ranges::count_if(found.free, is_friction) == 1 &&
                   place->scale == FreeParameter::Scale::logarithmic &&
                   (input.rig.friction.is_coulomb() || place->key == strength_key);
    if (!has_profile_) relative_error_ = error_of_sliding(input, found);
}

double SlidingChance::deviations(double way) const {
    if (!has_profile_) return std::abs(std::log(way)) / relative_error_;
    const FreeParameter& p = found_.free[friction_];
    const double moved = std::clamp(found_.parameters[friction_].value * way, p.low, p.high);
    const auto fit = squares_.profile(friction_, p.coordinate(moved),
                                      coordinates_of(found_.free, found_.best()));
    const double excess = std::max(0., fit.sum_of_squares - found_.sum_of_squares);
    const double widening = found_.widening.empty() ? 1 : found_.widening[friction_];
    return std::sqrt(excess / found_.logarithmic.inflation(friction_)) / std::max(1., widening);
}

double SlidingChance::at(double way) {
    const double logarithm = std::clamp(std::log(way), -farthest_way, farthest_way);
    const double rounded = std::round(logarithm / same_way) * same_way;
    auto known = known_.find(rounded);
    if (known == known_.end()) known = known_.emplace(rounded, deviations(std::exp(rounded))).first;
    return gsl_cdf_ugaussian_P(std::copysign(known->second, logarithm));
}

comparisons::SlipRegime LoopFinding::regime() const {
    using enum comparisons::SlipRegime;
    if (slides > std::max(sticks, slips_partly())) return gross_slip;
    return sticks > slips_partly() ? stick : partial_slip;
}

std::pair<std::string, double> regime_of_series(std::span<const LoopFinding> loops) {
    using enum comparisons::SlipRegime;
    const auto slides = [](const LoopFinding& loop) { return loop.slides; };
    const auto [least, most] = std::ranges::minmax(loops, {}, slides);
    const double all = least.slides, none = 1 - most.slides,
                 some = std::min(most.slides, 1 - least.slides);
    if (all >= std::max(none, some)) return {name_of(gross_slip), all};
    if (some > none) return {"mixed", some};
    const auto sticks = [](const LoopFinding& loop) { return loop.sticks; };
    const double closed = std::ranges::min(loops, {}, sticks).sticks;
    const double open = 1 - std::ranges::min(loops, {}, sticks).sticks - most.slides;
    if (closed > open) return {name_of(stick), closed};
    return {name_of(partial_slip), std::max(0., open)};
}

}  // namespace tricontact::experiments
