// Fretting rigs drawn at random: a sphere on a half-space, a spring of unknown stiffness in series,
// friction that drifts or not, offsets that drift, noise of force and shift, stated or not. A few
// cycles under two loads at two amplitudes each - closed loops, partial slip, gross slip, and
// cycles of which only some slide - are made by springs that are driven step by step. E, mu, k_rig
// and drift are found together: intervals of 95 % hold in 93 to 97 %, within the scatter of the
// draws, those of energies and of friction over the cycles as well; regimes are named rightly in
// 97 %. usage: random_loops SEED N
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
#include "tests/random/loop_rig.h"
#include "tests/random/random_rig.h"
#include "tests/random/seeded_main.h"

namespace tricontact {
namespace {

using experiments::IdentificationInput;

constexpr double stated_level = .95, level_margin = .02, rightly_named = .97;
constexpr int n_cycles = 3, n_rows = 40;
constexpr double cycles_between = 500;  // recorded ones

double log_between(Random& random, double low, double high) {
    return std::exp(between(random, {std::log(low), std::log(high)}));
}

struct TrueLoop {
    double energy = 0, friction = 0, ratio = 0;  // ratio: over 4 F U of the contact
    bool slides = false;
};

struct DrawnLoops {
    IdentificationInput input;
    std::map<std::string, double> truth;  // by key
    std::vector<TrueLoop> loops;
    std::vector<std::string> regimes;  // of the series
};

/// What one loop of the drive does, in fine steps, of which each n-th is a row.
struct Driven {
    std::vector<double> shifts, forces;
    TrueLoop truth;
};

Driven driven(LoopRig& rig, double amplitude, double mu) {
    constexpr int n_fine = 6;
    Driven loop{.truth = {.friction = mu}};
    rig.has_slid();
    double force = 0, shift = amplitude, largest_force = 0, largest_shift = 0;
    for (int i = 1; i <= n_rows * n_fine; ++i) {
        const double drive = amplitude * std::cos(2 * std::numbers::pi * i / (n_rows * n_fine));
        const double next = rig.move(drive, mu);
        loop.truth.energy += i == 1 ? 0 : (force + next) / 2 * (drive - shift);
        if (i == 1) loop.truth.energy += next * (drive - shift);
        force = next;
        shift = drive;
        largest_force = std::max(largest_force, std::abs(force));
        largest_shift = std::max(largest_shift, std::abs(rig.shift()));
        if (i % n_fine) continue;
        loop.shifts.push_back(drive);
        loop.forces.push_back(force);
    }
    loop.truth.ratio = loop.truth.energy / (4 * largest_force * largest_shift);
    loop.truth.slides = rig.has_slid();
    return loop;
}

std::string true_regime(const std::vector<TrueLoop>& loops) {
    const auto n = std::ranges::count(loops, true, &TrueLoop::slides);
    if (n == std::ssize(loops)) return "gross-slip";
    if (n > 0) return "mixed";
    const auto closed = [](const TrueLoop& loop) {
        return loop.ratio < experiments::closed_loop_ratio;
    };
    return std::ranges::all_of(loops, closed) ? "stick" : "partial-slip";
}

/// Amplitudes over that of sliding, of each of the four series.
std::vector<double> drawn_ways(Random& random, double drift) {
    // With a strong drift all of the second load's cycles may be on either side of sliding.
    return {between(random, {.3, .75}), between(random, {1.5, 3}),
            std::abs(drift) > .4 ? 1. : between(random, {.03, .08}), between(random, {1.5, 3})};
}

DrawnLoops drawn_loops(Random& random, int number) {
    LoopRig rig;
    rig.radius = log_between(random, 3e-3, 50e-3);
    rig.young = log_between(random, 2e9, 210e9);
    rig.poisson = between(random, {.25, .45});
    rig.friction = between(random, {.15, 1});
    rig.normal_force = log_between(random, 10, 500);
    rig.rig_stiffness = log_between(random, .4, 6) * 2 * rig.shear_modulus() * rig.contact_radius();
    const double drift = number % 4 == 0 ? 0
                         : number % 4 == 1
                             ? std::copysign(between(random, {.5, .8}), random() % 2 ? 1. : -1.)
                             : between(random, {-.2, .2});
    const double second_load = rig.normal_force * between(random, {3, 8});
    const auto ways = drawn_ways(random, drift);
    const double noise = between(random, {.003, .02}), shift_noise = between(random, {.0005, .003});
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
        rig.start();
        for (int i = 1; i <= 20; ++i) rig.move(amplitude * i / 20, rig.friction);
        std::vector<TrueLoop> loops;
        for (int recorded = 0; recorded < n_cycles; ++recorded) {
            const double mu = rig.friction * (1 + drift * (recorded - 1.) / 2);
            const double cycle = 1 + cycles_between * recorded;
            // Between two of them so many cycles pass that each is a steady one.
            driven(rig, amplitude, mu);
            Driven loop = driven(rig, amplitude, mu);
            loops.push_back(loop.truth);
            for (int i = 0; i < n_rows; ++i) {
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
    c.indenter.radius = rig.radius;
    c.substrate = {rig.young * between(random, {.4, 2}), rig.poisson};
    c.friction = {.coefficient = 2 * rig.friction};
    c.load.normal_force = second_load;
    drawn.input.models = {"half-space"};
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

void count(DrawnLoops drawn, const std::string& errors, std::map<std::string, Held>& held,
           Held& named, std::map<std::string, int>& confused) {
    const contact::ModelMakers makers;
    experiments::weigh_rows(drawn.input, {makers, 1});
    auto task = experiments::task_of(drawn.input, "half-space");
    task.model = experiments::prediction_of("half-space", drawn.input, {makers, 1});
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

int check(std::uint64_t seed, int n) {
    Random random(seed);
    std::map<std::string, Held> held;
    std::map<std::string, int> confused;
    Held named;
    for (int i = 0; i < n; ++i)
        count(drawn_loops(random, i), i % 2 ? "stated errors" : "estimated errors", held, named,
              confused);
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

}  // namespace
}  // namespace tricontact

int main(int argc, char** argv) {
    return tricontact::run_seeded(argc, argv, tricontact::check);
}
