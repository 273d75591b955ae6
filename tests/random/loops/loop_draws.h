#pragma once

#include <fmt/format.h>

#include <map>
#include <numbers>
#include <string>
#include <utility>

#include "contact/model_makers.h"
#include "experiments/identification/identification_models.h"
#include "experiments/identification/loop_findings.h"
#include "experiments/identification/loops/measured_loop.h"
#include "experiments/identification/row_weights.h"
#include "tests/random/loops/driven_loop.h"
#include "tests/random/random_rig.h"

// Fretting rigs drawn at random and what identify finds of their loops, whatever makes these. A rig
// of tests has: draw(random), all its numbers; start(), at rest under normal_force; lead(amplitude,
// friction) to a first reversal; cycle(amplitude, friction), a Driven; sliding_shift(), roughly;
// set_load(force); as_case(); `model`, which finds it; young, friction, rig_stiffness,
// normal_force.

namespace tricontact {
using experiments::IdentificationInput;

constexpr double stated_level = .95, level_margin = .02, rightly_named = .97;
constexpr int n_cycles = 3;
constexpr double cycles_between = 500;  // recorded ones

struct DrawnLoops {
    IdentificationInput input;
    std::map<std::string, double> truth;  // by key
    std::vector<TrueLoop> loops;
    std::vector<std::string> regimes;  // of the series
};

inline std::string true_regime(const std::vector<TrueLoop>& loops) {
    const auto n = std::ranges::count(loops, true, &TrueLoop::slides);
    if (n == std::ssize(loops)) return "gross-slip";
    if (n > 0) return "mixed";
    const auto closed = [](const TrueLoop& loop) {
        return loop.ratio < experiments::closed_loop_ratio;
    };
    return std::ranges::all_of(loops, closed) ? "stick" : "partial-slip";
}

/// Amplitudes over that of sliding, of each of the four series.
inline std::vector<double> drawn_ways(Random& random, double drift) {
    // With a strong drift all of the second load's cycles may be on either side of sliding.
    return {between(random, {.3, .75}), between(random, {1.5, 3}),
            std::abs(drift) > .4 ? 1. : between(random, {.03, .08}), between(random, {1.5, 3})};
}

template <class Rig>
DrawnLoops drawn_loops(Random& random, int number) {
    Rig rig;
    rig.draw(random);
    const double drift = number % 4 == 0 ? 0
                         : number % 4 == 1
                             ? std::copysign(between(random, {.5, .8}), random() % 2 ? 1. : -1.)
                             : between(random, {-.2, .2});
    const double second_load = rig.normal_force * between(random, {3, 8});
    const auto ways = drawn_ways(random, drift);
    const double noise = between(random, Rig::noise), shift_noise = between(random, {.0005, .003});
    std::normal_distribution<double> gauss;
    DrawnLoops drawn;
    drawn.truth = {{"substrate.young", rig.young},
                   {"friction.coefficient", rig.friction},
                   {"rig.tangential_stiffness", rig.rig_stiffness},
                   {"friction_drift", drift}};
    experiments::LoopColumns columns;
    std::vector<double> force_errors, shift_errors;
    const double error = noise * rig.friction * rig.normal_force;
    for (std::size_t series = 0; series < ways.size(); ++series) {
        if (series == 2) rig.normal_force = second_load;
        const double amplitude = ways[series] * rig.sliding_shift();
        const double offset = between(random, {-1, 1}) * amplitude,
                     force_offset = between(random, {-.1, .1}) * rig.friction * rig.normal_force,
                     shift_drift = between(random, {-.05, .05}) * amplitude;
        rig.start(amplitude);
        std::vector<TrueLoop> loops;
        for (int recorded = 0; recorded < n_cycles; ++recorded) {
            const double mu = rig.friction * (1 + drift * (recorded - 1.) / 2);
            const double cycle = 1 + cycles_between * recorded;
            // Between two of them so many cycles pass that each is a steady one.
            rig.cycle(amplitude, mu);
            const DrivenLoop loop = rig.cycle(amplitude, mu);
            loops.push_back(loop.truth);
            for (std::size_t i = 0; i < loop.shifts.size(); ++i) {
                columns.cycles.push_back(cycle);
                columns.amplitudes.push_back(amplitude);
                columns.normal_forces.push_back(rig.normal_force);
                columns.shifts.push_back(offset + shift_drift * recorded + loop.shifts[i] +
                                         shift_noise * amplitude * gauss(random));
                columns.forces.push_back(force_offset + loop.forces[i] + error * gauss(random));
                force_errors.push_back(error);
                shift_errors.push_back(shift_noise * amplitude);
            }
        }
        drawn.regimes.push_back(true_regime(loops));
        drawn.loops.insert(drawn.loops.end(), loops.begin(), loops.end());
    }
    IdentificationInput::Table table{.measurement = IdentificationInput::Measurement::friction_loop,
                                     .given = columns.shifts,
                                     .observed = columns.forces,
                                     .loops = experiments::measured_loops(columns)};
    if (number % 2) table.standard_errors = table.row_errors.observed = force_errors;
    if (number % 2) table.row_errors.given = shift_errors;
    contact::Case& c = drawn.input.rig;
    c = rig.as_case();
    c.substrate.young = rig.young * between(random, {.4, 2});
    c.friction = {.coefficient = 2 * rig.friction};
    c.load.normal_force = second_load;
    drawn.input.models = {Rig::model};
    drawn.input.tables = {std::move(table)};
    drawn.input.parameters = experiments::free_parameters(
        drawn.input, {"substrate.young", "friction.coefficient", "rig.tangential_stiffness"});
    return drawn;
}

struct Held {
    int all = 0, held = 0;

    void add(bool holds) {
        ++all;
        held += holds;
    }
    double part() const { return static_cast<double>(held) / all; }
};

inline void count(DrawnLoops drawn, const std::string& errors, std::map<std::string, Held>& held,
                  Held& named, std::map<std::string, int>& confused) {
    const contact::ModelMakers makers;
    const std::string model = drawn.input.models.front();
    experiments::weigh_rows(drawn.input, {makers, 1});
    auto task = experiments::task_of(drawn.input, model);
    task.model = experiments::prediction_of(model, drawn.input, {makers, 1});
    const auto found = experiments::identify(task);
    for (std::size_t k = 0; k < found.free.size(); ++k) {
        const auto& [low, high] = found.parameters[k].likelihood;
        const double value = drawn.truth.at(found.free[k].key);
        for (const std::string& row : {found.free[k].symbol, errors, std::string("all")})
            held[row].add(low <= value && value <= high);
    }
    const auto findings = experiments::loop_findings(drawn.input, task, found);
    for (std::size_t i = 0; i < findings.loops.size(); ++i) {
        const auto& loop = findings.loops[i];
        const TrueLoop& truth = drawn.loops[i];
        held["energy"].add(loop.energy.low <= truth.energy && truth.energy <= loop.energy.high);
        if (truth.slides)
            held["mu of a cycle"].add(loop.friction.low <= truth.friction &&
                                      truth.friction <= loop.friction.high);
    }
    for (std::size_t s = 0; s < findings.series.size(); ++s) {
        named.add(findings.series[s].regime == drawn.regimes[s]);
        if (findings.series[s].regime != drawn.regimes[s])
            ++confused[drawn.regimes[s] + " named " + findings.series[s].regime];
        ++confused["(" + drawn.regimes[s] + ")"];
    }
}

template <class Rig>
int check_loops(std::uint64_t seed, int n) {
    Random random(seed);
    std::map<std::string, Held> held;
    std::map<std::string, int> confused;
    Held named;
    for (int i = 0; i < n; ++i)
        count(drawn_loops<Rig>(random, i), i % 2 ? "stated errors" : "estimated errors", held,
              named, confused);
    bool holds = true;
    for (const auto& [row, of] : held) {
        fmt::print("{:16} {:5} intervals, {:.3g} % hold\n", row, of.all, 100 * of.part());
        const double scatter = 3 * std::sqrt(stated_level * (1 - stated_level) / of.all);
        holds = holds && std::abs(of.part() - stated_level) < level_margin + scatter;
    }
    fmt::print("{:.3g} % of {} regimes named rightly\n", 100 * named.part(), named.all);
    for (const auto& [words, times] : confused) fmt::print("  {}: {}\n", words, times);
    holds = holds && named.part() > rightly_named - 3 * std::sqrt(.03 * .97 / named.all);
    return holds ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace tricontact
