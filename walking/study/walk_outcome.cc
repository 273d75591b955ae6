#include "walking/study/walk_outcome.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "contact/special_values.h"
#include "report/json_number.h"
#include "walking/machine/energy.h"
#include "walking/machine/machine.h"
#include "walking/machine/motion.h"
#include "walking/report/walk_readings.h"
#include "walking/run/walk_judge.h"

namespace tricontact::walking {

namespace {

using Drift = WalkResult::Drift;
using json = nlohmann::ordered_json;

WalkOutcome::SecondHalf second_half(const Machine& machine, const Walk& walk) {
    if (walk.result.tilting_time || walk.windows.empty())
        return {contact::undefined, contact::undefined, contact::undefined};
    const StretchSums sums = total(std::span(walk.windows).subspan(walk.windows.size() / 2));
    const double sliding = sliding_force(machine);
    const double rest = static_displacement(machine);
    return {sums.spring_force / static_cast<double>(sums.steps) / sliding, sums.z_min / rest,
            sums.z_max / rest};
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

/// A number of the outcome by its name, as it is written and read.
struct Number {
    const char* name;
    double& (*of)(WalkOutcome& outcome);
};

constexpr Number numbers_of_result[] = {
    {"mu_e", [](WalkOutcome& o) -> double& { return o.result.mu_e; }},
    {"mu_e_error", [](WalkOutcome& o) -> double& { return o.result.mu_e_error; }},
    {"z_min_ratio", [](WalkOutcome& o) -> double& { return o.result.z_min_ratio; }},
    {"z_max_ratio", [](WalkOutcome& o) -> double& { return o.result.z_max_ratio; }},
    {"stick_time_1", [](WalkOutcome& o) -> double& { return o.result.spots.front().stick_time; }},
    {"stick_time_2", [](WalkOutcome& o) -> double& { return o.result.spots.back().stick_time; }},
    {"correlation_1", [](WalkOutcome& o) -> double& { return o.result.spots.front().correlation; }},
    {"correlation_2", [](WalkOutcome& o) -> double& { return o.result.spots.back().correlation; }},
    {"kinetic_energy", [](WalkOutcome& o) -> double& { return o.result.kinetic_energy; }},
    {"phi_min", [](WalkOutcome& o) -> double& { return o.result.phi_min; }},
    {"phi_max", [](WalkOutcome& o) -> double& { return o.result.phi_max; }},
    {"transient", [](WalkOutcome& o) -> double& { return o.result.transient; }},
    {"observed", [](WalkOutcome& o) -> double& { return o.result.observed; }},
    {"mu_e_second_half", [](WalkOutcome& o) -> double& { return o.second_half.mu_e; }},
    {"z_min_ratio_second_half",
     [](WalkOutcome& o) -> double& { return o.second_half.z_min_ratio; }},
    {"z_max_ratio_second_half",
     [](WalkOutcome& o) -> double& { return o.second_half.z_max_ratio; }},
    {"frequency", [](WalkOutcome& o) -> double& { return o.vibration.frequency; }},
    {"frequency_error", [](WalkOutcome& o) -> double& { return o.vibration.frequency_error; }},
    {"instability", [](WalkOutcome& o) -> double& { return o.vibration.instability; }},
    {"largest_phi", [](WalkOutcome& o) -> double& { return o.largest_phi; }},
    {"initial_energy", [](WalkOutcome& o) -> double& { return o.initial_energy; }},
};

constexpr std::pair<const char*, std::vector<float> MotionSamples::*> lists_of_samples[] = {
    {"displacement", &MotionSamples::displacement},
    {"z", &MotionSamples::z},
    {"phi", &MotionSamples::phi},
    {"spring_force", &MotionSamples::spring_force},
};

double five_digits(float value) {
    return std::stod(fmt::format("{:.5g}", value));
}

json samples_json(const MotionSamples& samples) {
    json result{{"interval", five_digits(static_cast<float>(samples.interval))}};
    for (const auto& [name, member] : lists_of_samples) {
        json& list = result[name] = json::array();
        for (const float value : samples.*member) list.push_back(five_digits(value));
    }
    return result;
}

double number_in(const json& value) {
    return value.is_null() ? contact::undefined : value.get<double>();
}

std::optional<double> optional_in(const json& value) {
    if (value.is_null()) return {};
    return value.get<double>();
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
        std::vector<std::string> all{"regime"};
        for (const Number& number : numbers_of_result) all.emplace_back(number.name);
        all.insert(all.end(), {"period", "section_points", "transient_over", "tilting_time",
                               "shift_per_period", "shift_per_period_error", "airborne"});
        return all;
    }();
    return names;
}

json walk_results(const WalkOutcome& outcome) {
    WalkOutcome whole = outcome;
    if (whole.result.spots.empty())
        whole.result.spots.push_back({contact::undefined, contact::undefined});
    json results{{"regime", word_of(outcome.result.regime)}};
    for (const Number& each : numbers_of_result)
        results[each.name] = report::number(each.of(whole));
    results["period"] = report::number(outcome.result.period);
    results["section_points"] = outcome.result.section_points;
    results["transient_over"] = outcome.result.transient_over;
    results["tilting_time"] = report::number(outcome.result.tilting_time);
    const auto drift = outcome.result.drift.value_or(
        Drift{contact::undefined, contact::undefined, contact::undefined});
    results["shift_per_period"] = report::number(drift.per_period);
    results["shift_per_period_error"] = report::number(drift.error);
    results["airborne"] = report::number(drift.airborne);
    if (outcome.samples.interval > 0) results["samples"] = samples_json(outcome.samples);
    return results;
}

WalkOutcome read_walk_results(const json& results) {
    WalkOutcome outcome;
    outcome.result.spots.resize(2);
    outcome.result.regime = regime_of(results.at("regime").get<std::string>());
    for (const Number& each : numbers_of_result)
        each.of(outcome) = number_in(results.at(each.name));
    outcome.result.period = optional_in(results.at("period"));
    outcome.result.section_points = results.at("section_points").get<int>();
    outcome.result.transient_over = results.at("transient_over").get<bool>();
    outcome.result.tilting_time = optional_in(results.at("tilting_time"));
    if (!results.at("shift_per_period").is_null())
        outcome.result.drift = Drift{number_in(results.at("shift_per_period")),
                                     number_in(results.at("shift_per_period_error")),
                                     number_in(results.at("airborne"))};
    if (const auto samples = results.find("samples"); samples != results.end()) {
        outcome.samples.interval = samples->at("interval").get<double>();
        for (const auto& [name, member] : lists_of_samples)
            outcome.samples.*member = samples->at(name).get<std::vector<float>>();
    }
    return outcome;
}

}  // namespace tricontact::walking
