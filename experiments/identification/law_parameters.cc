#include "experiments/identification/law_parameters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/half_space_scales.h"
#include "experiments/identification/friction_values.h"
#include "experiments/identification/layer_contact.h"
#include "experiments/identification/loop_values.h"

namespace tricontact::experiments {

namespace {

using Measurement = IdentificationInput::Measurement;
using Scale = FreeParameter::Scale;

// Of a number around its guess; of one that may be zero, over it.
constexpr double widest_number = 1e3, widest_from_zero = 100;
constexpr double largest_exponent = 2;  // as [friction] has it
constexpr double guessed_exponent = .8;
// Whatever held was this far from sliding, until more is known.
constexpr double guessed_margin = 1.3;

/// What friction may carry under the largest load.
struct Guess {
    double normal_force = 0, friction = 0;  // [N]
};

Guess guess_of(const IdentificationInput& input) {
    Guess guess;
    const auto take = [&](double normal_force, double friction) {
        if (normal_force < guess.normal_force) return;
        if (normal_force > guess.normal_force) guess.friction = 0;
        guess.normal_force = normal_force;
        guess.friction = std::max(guess.friction, friction);
    };
    for (const auto* shifts : input.all(Measurement::static_shift))
        for (const LoadedRows& load : rows_by_load(*shifts, input.rig, shifts->given))
            take(load.normal_force, guessed_margin * std::ranges::max(load.given));
    for (const auto* measured : input.all(Measurement::friction_loop))
        for (const MeasuredLoop& loop : measured->loops.loops) {
            const auto forces = rows_of(*measured, loop).forces;
            const auto [least, most] = std::ranges::minmax(forces);
            take(load_of(loop, input.rig), (most - least) / 2);
        }
    const auto all_sliding = input.all(Measurement::sliding_force);
    if (!all_sliding.empty()) guess = {};  // which shows it
    for (const auto* sliding : all_sliding)
        for (std::size_t row = 0; row < sliding->given.size(); ++row)
            take(sliding->given[row], sliding->observed[row]);
    return guess;
}

/// Of Hertz' contact of the guessed rig [m^2].
double area_under(const IdentificationInput& input, const Guess& guess) {
    const contact::HalfSpaceScales hertz = contact::hertz_scales(
        input.rig.materials(), input.rig.indenter.radius, guess.normal_force, 1);
    return std::numbers::pi * std::pow(hertz.contact_radius, 2);
}

double one_digit(double value) {
    const double power = std::pow(10., std::floor(std::log10(value)));
    return std::round(value / power) * power;
}

FreeParameter sized(FreeParameter p, double guess) {
    p.scale = Scale::from_zero;
    p.size = guess;
    p.low = 0;
    p.high = widest_from_zero * guess;
    p.start = .2 * guess;
    p.further_starts = {.8 * guess};
    return p;
}

FreeParameter around(FreeParameter p, double guess) {
    p.scale = Scale::logarithmic;
    p.low = guess / widest_number;
    p.high = guess * widest_number;
    p.start = guess;
    return p;
}

/// Of a law whose other number only lessens what this one gives: its guess is the least one, but
/// for noise, and it may be infinite.
FreeParameter above(FreeParameter p, double guess) {
    constexpr double least = .3;
    p.scale = Scale::reciprocal;
    p.low = least * guess;
    p.high = guess * widest_number;
    p.start = guessed_margin * guess;
    return p;
}

FreeParameter strength_of(std::string_view key, std::string name, std::string symbol) {
    return {.key = std::string(key),
            .name = std::move(name),
            .symbol = std::move(symbol),
            .unit = "Pa"};
}

FreeParameter unnamed_coefficient() {
    return {.key = "friction.coefficient", .name = "friction_coefficient", .symbol = "mu"};
}

}  // namespace

double largest_held_ratio(const IdentificationInput& input) {
    double ratio = 0;
    for (const auto* shifts : input.all(Measurement::static_shift))
        for (const LoadedRows& load : rows_by_load(*shifts, input.rig, shifts->given))
            ratio = std::max(ratio, std::ranges::max(load.given) / load.normal_force);
    return ratio;
}

FreeParameter coulomb_parameter(const IdentificationInput& input) {
    const double held = largest_held_ratio(input);
    if (held > 0) return friction_parameter(held);
    const Guess guess = guess_of(input);
    return around(unnamed_coefficient(), guess.friction / guess.normal_force);
}

bool is_of_law(std::string_view key) {
    return key == coefficient_key || key == strength_key || key == exponent_key ||
           key == strength_limit_key;
}

io::MeasurementLaw stated_law(const contact::Friction& friction) {
    return {.has_strength = friction.shear_strength.has_value(),
            .has_coefficient = friction.coefficient.has_value(),
            .has_exponent = friction.pressure_exponent.has_value(),
            .has_limit = friction.strength_limit.has_value()};
}

FreeParameter law_parameter(const IdentificationInput& input, const io::MeasurementLaw& law,
                            std::string_view key) {
    if (key == coefficient_key && law.n_numbers() == 1) return coulomb_parameter(input);
    if (key == exponent_key)
        return {.key = std::string(key),
                .name = "pressure_exponent",
                .symbol = "n",
                .scale = Scale::from_zero,
                .low = 0,
                .high = largest_exponent,
                .start = input.rig.friction.pressure_exponent.value_or(guessed_exponent),
                .size = 1,
                .further_starts = {.3}};
    const Guess guess = guess_of(input);
    const double mean = guess.friction / area_under(input, guess),
                 ratio = guess.friction / guess.normal_force;
    if (key == strength_limit_key)
        return above(strength_of(key, "strength_limit_Pa", "tau_cap"), mean);
    if (key == strength_key) {
        const auto p = strength_of(key, "shear_strength_Pa", "tau_0");
        return law.has_coefficient ? sized(p, mean) : around(p, mean);
    }
    return law.has_strength ? sized(unnamed_coefficient(), ratio)
           : law.has_limit  ? above(unnamed_coefficient(), ratio)
                            : around(unnamed_coefficient(), ratio);
}

IdentificationInput with_law(const IdentificationInput& input, const io::MeasurementLaw& law) {
    IdentificationInput result = input;
    const Guess guess = guess_of(input);
    const double area = area_under(input, guess), mean = guess.friction / area;
    contact::Friction friction;
    const auto find = [&](std::string_view key) {
        result.parameters.push_back(law_parameter(input, law, key));
    };
    if (law.has_strength) {
        friction.shear_strength = mean;
        find(strength_key);
    }
    if (law.has_coefficient) {
        friction.coefficient = guess.friction / guess.normal_force;
        find(coefficient_key);
    }
    if (law.has_exponent) {
        friction.reference_pressure = one_digit(guess.normal_force / area);
        friction.pressure_exponent = guessed_exponent;
        find(exponent_key);
    }
    if (law.has_limit) {
        friction.strength_limit = guessed_margin * mean;
        find(strength_limit_key);
    }
    result.rig.friction = friction;
    return result;
}

double mean_friction(bool on_layer, const contact::Case& rig, double normal_force) {
    const contact::NormalControl load{contact::NormalControl::Kind::force, normal_force};
    const double radius =
        (on_layer ? layer_press(rig, load) : half_space_press(rig, load)).contact_radius;
    return sliding_forces(on_layer, rig, {normal_force}).front() /
           (std::numbers::pi * radius * radius);
}

LoadRange loads_of_friction(const IdentificationInput& input) {
    std::vector<double> loads;
    for (const auto* sliding : input.all(Measurement::sliding_force))
        loads.insert(loads.end(), sliding->given.begin(), sliding->given.end());
    for (const auto* shifts : input.all(Measurement::static_shift))
        for (const LoadedRows& load : rows_by_load(*shifts, input.rig, shifts->given))
            loads.push_back(load.normal_force);
    for (const auto* measured : input.all(Measurement::friction_loop))
        for (const MeasuredLoop& loop : measured->loops.loops)
            loads.push_back(load_of(loop, input.rig));
    const auto [least, largest] = std::ranges::minmax(loads);
    return {least, largest};
}

}  // namespace tricontact::experiments
