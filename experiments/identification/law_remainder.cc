// What of a law of friction the tables leave open beside one that it contains.

#include "experiments/identification/law_remainder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "contact/half_space_scales.h"
#include "experiments/identification/friction_values.h"
#include "experiments/identification/identification_models.h"
#include "experiments/identification/law_parameters.h"
#include "io/case/measurement_models.h"
#include "report/format.h"

namespace tricontact::experiments {

namespace {

double found_number(const LawFit& fit, std::string_view key) {
    return fit.found.parameters[*fit.found.find(std::string(key))].value;
}

Interval found_interval(const LawFit& fit, std::string_view key) {
    return fit.found.parameters[*fit.found.find(std::string(key))].likelihood;
}

std::string part_text(const char* what, const std::string& end, double part) {
    return fmt::format("{} {}, {} % of friction", what, end,
                       report::significant(100 * std::min(part, 1.), 2));
}

std::string range_text(const char* what, const Interval& range) {
    return fmt::format("{} from {} to {}", what, report::significant(range.low, 2),
                       report::significant(range.high, 2));
}

/// A strength and a power of the pressure in other coordinates: the friction of a point at the mean
/// pressure p_m of the middle load, its exponent there, m = d ln tau/d ln p, and where n is from m
/// to its largest value.
struct LocalPower {
    double reference_pressure = 0, pressure = 0, largest = 0;  // p_r, p_m [Pa], n

    /// tau_0, mu, n of tau [Pa], m and the place of n.
    std::array<double, 3> numbers(double friction, double exponent, double place) const {
        const double n = exponent + place * (largest - exponent);
        const double part = n > 0 ? exponent / n : 0;
        const double mu =
            part * friction / reference_pressure * std::pow(reference_pressure / pressure, n);
        return {(1 - part) * friction, mu, n};
    }
};

LocalPower local_power(const LawFit& wide, const LoadRange& loads) {
    const contact::HalfSpaceScales hertz = contact::hertz_scales(
        wide.input.rig.materials(), wide.input.rig.indenter.radius, loads.middle(), 1);
    const double mean = loads.middle() / (std::numbers::pi * std::pow(hertz.contact_radius, 2));
    return {*wide.input.rig.friction.reference_pressure, mean,
            wide.found.free[*wide.found.find(std::string(exponent_key))].high};
}

/// Of d ln tau/d ln p under the middle load.
Interval local_exponents(const std::string& model, const LawFit& wide, const LoadRange& loads,
                         const contact::ModelRunner& runner) {
    const LocalPower local = local_power(wide, loads);
    IdentificationTask task = task_of(wide.input, model);
    const auto [strength, coefficient, exponent] = std::array{
        *wide.found.find(std::string(strength_key)), *wide.found.find(std::string(coefficient_key)),
        *wide.found.find(std::string(exponent_key))};
    task.model = [=, predicted =
                         prediction_of(model, wide.input, runner)](std::vector<double> values) {
        const auto numbers = local.numbers(values[strength], values[coefficient], values[exponent]);
        values[strength] = numbers[0];
        values[coefficient] = numbers[1];
        values[exponent] = numbers[2];
        return predicted(values);
    };
    constexpr double widest = 1e3;
    const double n = found_number(wide, exponent_key),
                 power = found_number(wide, coefficient_key) * local.reference_pressure *
                         std::pow(local.pressure / local.reference_pressure, n),
                 friction = found_number(wide, strength_key) + power;
    task.parameters[strength] = {.key = "tau",
                                 .name = "tau",
                                 .symbol = "tau",
                                 .unit = "Pa",
                                 .low = friction / widest,
                                 .high = friction * widest,
                                 .start = friction};
    task.parameters[coefficient] = {.key = "m",
                                    .name = "m",
                                    .symbol = "m",
                                    .scale = FreeParameter::Scale::from_zero,
                                    .low = 0,
                                    .high = local.largest,
                                    .start = n * power / friction,
                                    .size = 1};
    task.parameters[exponent] = {.key = "place",
                                 .name = "place",
                                 .symbol = "place",
                                 .scale = FreeParameter::Scale::from_zero,
                                 .low = 0,
                                 .high = 1,
                                 .start = .8,
                                 .size = 1,
                                 .further_starts = {.2}};
    return identify(task).parameters[coefficient].likelihood;
}

/// A wider law beside a narrower one.
struct LawPair {
    const std::string& model_;
    const LawFit &narrow_, &wide_;
    const LoadRange loads_ = loads_of_friction(wide_.input);
    const bool on_layer_ = io::measurement_model(model_).is_layer;
    const contact::Case rig_ = rig_with(wide_.input, wide_.found.free, wide_.found.best()).as_case;

    std::string shown(std::string_view key, double value) const {
        return wide_.found.free[*wide_.found.find(std::string(key))].shown(value);
    }
    double sliding_force(const contact::Case& rig) const {
        return sliding_forces(on_layer_, rig, {loads_.middle()}).front();
    }

    std::string strength() const {
        const double end = found_interval(wide_, strength_key).high;
        const double part = end / mean_friction(on_layer_, rig_, loads_.middle());
        return part <= negligible_part ? ""
                                       : part_text("tau_0 up to", shown(strength_key, end), part);
    }
    /// Of mu p beside a strength.
    std::string coefficient() const {
        const double end = found_interval(wide_, coefficient_key).high;
        const double part = end * loads_.middle() / sliding_force(rig_);
        return part <= negligible_part ? ""
                                       : part_text("mu up to", shown(coefficient_key, end), part);
    }
    static std::string exponent(const char* symbol, const Interval& n, double target) {
        const double off = std::max(std::abs(n.low - target), std::abs(n.high - target));
        return off <= negligible_part ? "" : range_text(symbol, n);
    }
    /// What the cap takes from mu p, or mu p from the cap.
    std::string limit(std::string_view key) const {
        const bool is_cap = key == strength_limit_key;
        const double end = found_interval(wide_, key).low;
        contact::Case at_end = rig_, without = rig_;
        (is_cap ? at_end.friction.strength_limit : at_end.friction.coefficient) = end;
        if (is_cap)
            without.friction.strength_limit.reset();
        else
            without.friction = {.shear_strength = found_number(wide_, strength_limit_key)};
        const double part = 1 - sliding_force(at_end) / sliding_force(without);
        return part <= negligible_part
                   ? ""
                   : part_text(is_cap ? "tau_cap down to" : "mu down to", shown(key, end), part);
    }
    std::string beside_strength(const contact::ModelRunner& runner) const {
        if (wide_.law->has_limit) return limit(coefficient_key);
        if (!wide_.law->has_exponent) return coefficient();
        if (!wide_.law->has_strength) return exponent("n", found_interval(wide_, exponent_key), 0);
        // mu may be large where n = 0, and n where mu = 0.
        return exponent("d ln tau/d ln p", local_exponents(model_, wide_, loads_, runner), 0);
    }
};

}  // namespace

std::string what_is_left(const std::string& model, const LawFit& narrow, const LawFit& wide,
                         const contact::ModelRunner& runner) {
    const LawPair pair{model, narrow, wide};
    const io::MeasurementLaw &of = *narrow.law, &in = *wide.law;
    if (!of.has_coefficient) return pair.beside_strength(runner);
    std::string left;
    const auto add = [&](const std::string& one) {
        left += (left.empty() || one.empty() ? "" : ", ") + one;
    };
    if (in.has_strength && !of.has_strength) add(pair.strength());
    if (in.has_exponent && !of.has_exponent)
        add(LawPair::exponent("n", found_interval(wide, exponent_key), 1));
    if (in.has_limit && !of.has_limit) add(pair.limit(strength_limit_key));
    return left;
}

}  // namespace tricontact::experiments
