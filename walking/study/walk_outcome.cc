#include "walking/study/walk_outcome.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <type_traits>

#include "contact/base/special_values.h"
#include "report/json_number.h"
#include "walking/machine/energy.h"
#include "walking/machine/machine.h"
#include "walking/machine/motion.h"
#include "walking/run/walk_judge.h"
#include "walking/run/walk_readings.h"

namespace tricontact::walking {

namespace {

using json = nlohmann::ordered_json;

WalkOutcome::SecondHalf second_half(const Machine& machine, const Walk& walk) {
    if (walk.result.tilting_time || walk.windows.empty())
        return {contact::undefined, contact::undefined, contact::undefined};
    WalkResult half;
    take_statistics(machine, total(std::span(walk.windows).subspan(walk.windows.size() / 2)), half);
    return {half.mu_e, half.z_min_ratio, half.z_max_ratio};
}

double largest_phi(const Walk& walk) {
    double largest = 0;
    for (const WalkWindow& window : walk.windows)
        if (window.sums.steps > 0)
            largest = std::max({largest, -window.sums.phi_min, window.sums.phi_max});
    return largest;
}

WalkOutcome::Vibration vibration(const Machine& machine, const Walk& walk) {
    if (walk.result.regime == Regime::steady && !walk.result.tilting_time)
        return {contact::undefined, contact::undefined, 0};
    const auto found = walk.result.tilting_time || walk.result.regime == Regime::sticking
                           ? std::nullopt
                           : vibration_of(machine, walk);
    if (!found) return {contact::undefined, contact::undefined, contact::undefined};
    return {found->characteristic.frequency, found->characteristic.error, found->instability};
}

// What the page of a map shows of each machine: some swings.
constexpr double sampled_time = 12;

MotionSamples samples_of(const Machine& machine, const Walk& walk) {
    MotionSamples samples;
    if (walk.tail.size() < 2 || walk.result.tilting_time) return samples;
    samples.interval = sampling_interval(walk);
    const auto n = static_cast<std::size_t>(std::lround(sampled_time / samples.interval)) + 1;
    for (const Snapshot& snapshot : std::span(walk.tail).last(std::min(n, walk.tail.size()))) {
        const Motion& motion = snapshot.motion;
        samples.displacement.push_back(static_cast<float>(motion.x - motion.base));
        samples.z.push_back(static_cast<float>(motion.z));
        samples.phi.push_back(static_cast<float>(motion.phi));
        samples.spring_force.push_back(static_cast<float>(spring_force(machine, motion)));
    }
    return samples;
}

/// Every word and number of an outcome that has spots and a drift, by its name in the order of the
/// table. Spots 1 and 2 are the first and the last.
template <class Visit>
void for_each_result(WalkOutcome& o, const Visit& visit) {
    WalkResult& r = o.result;
    visit("regime", r.regime);
    visit("mu_e", r.mu_e);
    visit("mu_e_error", r.mu_e_error);
    visit("z_min_ratio", r.z_min_ratio);
    visit("z_max_ratio", r.z_max_ratio);
    visit("stick_time_1", r.spots.front().stick_time);
    visit("stick_time_2", r.spots.back().stick_time);
    visit("correlation_1", r.spots.front().correlation);
    visit("correlation_2", r.spots.back().correlation);
    visit("kinetic_energy", r.kinetic_energy);
    visit("phi_min", r.phi_min);
    visit("phi_max", r.phi_max);
    visit("transient", r.transient);
    visit("observed", r.observed);
    visit("mu_e_second_half", o.second_half.mu_e);
    visit("z_min_ratio_second_half", o.second_half.z_min_ratio);
    visit("z_max_ratio_second_half", o.second_half.z_max_ratio);
    visit("frequency", o.vibration.frequency);
    visit("frequency_error", o.vibration.frequency_error);
    visit("instability", o.vibration.instability);
    visit("largest_phi", o.largest_phi);
    visit("initial_energy", o.initial_energy);
    visit("period", r.period);
    visit("section_points", r.section_points);
    visit("transient_over", r.transient_over);
    visit("tilting_time", r.tilting_time);
    visit("shift_per_period", r.drift->per_period);
    visit("shift_per_period_error", r.drift->error);
    visit("airborne", r.drift->airborne);
}

/// With undefined ones in place of spots and a drift that it has not.
WalkOutcome with_all_parts(WalkOutcome outcome) {
    constexpr double none = contact::undefined;
    WalkResult& result = outcome.result;
    if (result.spots.empty()) result.spots.push_back({none, none});
    if (!result.drift) result.drift = {none, none, none};
    return outcome;
}

constexpr std::pair<const char*, std::vector<float> MotionSamples::*> lists_of_samples[] = {
    {"displacement", &MotionSamples::displacement},
    {"z", &MotionSamples::z},
    {"phi", &MotionSamples::phi},
    {"spring_force", &MotionSamples::spring_force},
};

double five_digits(float value) {
    return report::to_digits(value, 5);
}

json samples_json(const MotionSamples& samples) {
    json result{{"interval", five_digits(static_cast<float>(samples.interval))}};
    for (const auto& [name, member] : lists_of_samples) {
        json& list = result[name] = json::array();
        for (const float value : samples.*member) list.push_back(five_digits(value));
    }
    return result;
}

Regime regime_of(const std::string& word) {
    for (const Regime regime : all_regimes)
        if (word_of(regime) == word) return regime;
    throw std::invalid_argument("no regime is called " + word);
}

}  // namespace

double initial_energy(const Machine& machine, const Start& start) {
    return stored_energy(machine, springs_of(machine), motion_at_start(machine, start)) /
           (machine.kappas.kappa4 * static_displacement(machine));
}

WalkOutcome outcome_of(const WalkCase& walk_case, const Walk& walk) {
    return {.result = walk.result,
            .second_half = second_half(walk_case.machine, walk),
            .vibration = vibration(walk_case.machine, walk),
            .largest_phi = largest_phi(walk),
            .initial_energy = initial_energy(walk_case.machine, walk_case.start),
            .samples = samples_of(walk_case.machine, walk)};
}

const std::vector<std::string>& walk_result_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        WalkOutcome any = with_all_parts({});
        for_each_result(any, [&](const char* name, const auto&) { all.emplace_back(name); });
        return all;
    }();
    return names;
}

json walk_results(const WalkOutcome& outcome) {
    WalkOutcome whole = with_all_parts(outcome);
    json results;
    for_each_result(whole, [&]<class Value>(const char* name, const Value& value) {
        if constexpr (std::is_same_v<Value, Regime>)
            results[name] = word_of(value);
        else if constexpr (std::is_integral_v<Value>)
            results[name] = value;
        else
            results[name] = report::number(value);
    });
    if (outcome.samples.interval > 0) results["samples"] = samples_json(outcome.samples);
    return results;
}

WalkOutcome read_walk_results(const json& results) {
    WalkOutcome outcome;
    outcome.result.spots.resize(2);
    outcome.result.drift.emplace();
    for_each_result(outcome, [&]<class Value>(const char* name, Value& value) {
        const json& given = results.at(name);
        if constexpr (std::is_same_v<Value, Regime>)
            value = regime_of(given.get<std::string>());
        else if constexpr (std::is_integral_v<Value>)
            given.get_to(value);
        else if (!given.is_null())
            value = given.get<double>();
        else if constexpr (std::is_same_v<Value, double>)
            value = contact::undefined;
    });
    if (std::isnan(outcome.result.drift->per_period)) outcome.result.drift.reset();
    if (const auto samples = results.find("samples"); samples != results.end()) {
        outcome.samples.interval = samples->at("interval").get<double>();
        for (const auto& [name, member] : lists_of_samples)
            outcome.samples.*member = samples->at(name).get<std::vector<float>>();
    }
    return outcome;
}

}  // namespace tricontact::walking
