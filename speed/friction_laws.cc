// What a law of friction costs: runs of the rig by each model, each beside the same run under
// Coulomb's law, in turn. `of_coulomb`: ratio of the medians. So do springs of the interface beside
// a rigid one (`of_rigid`), a layer that flows and hardens, and friction that falls with the speed
// of slip in steady rolling.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "bem/model.h"
#include "bem/settings.h"
#include "contact/run.h"
#include "mdr/layer_model.h"
#include "mdr/model.h"
#include "mdr/settings.h"
#include "rolling/run.h"
#include "speed/cpu_timer.h"
#include "speed/rig.h"

namespace tricontact::speed {
namespace {

using MakeModel = std::unique_ptr<contact::Model> (*)(const contact::Case&);

std::unique_ptr<contact::Model> springs(const contact::Case& c) {
    return mdr::make_model(c);
}
std::unique_ptr<contact::Model> layer_springs(const contact::Case& c) {
    return mdr::make_layer_model(c);
}
std::unique_ptr<contact::Model> cells(const contact::Case& c) {
    return bem::make_model(c, 1);
}
std::unique_ptr<contact::Model> layer_cells(const contact::Case& c) {
    return bem::make_model(c, 1, bem::Body::layer);
}

contact::Friction law(int number) {
    const std::array laws{
        contact::Friction{.coefficient = .57}, contact::Friction{.shear_strength = 1e5},
        contact::Friction{.coefficient = .57, .pressure_exponent = .7, .reference_pressure = 2e5},
        contact::Friction{.coefficient = .57, .strength_limit = 1e5}};
    return laws[static_cast<std::size_t>(number)];
}

/// The rig on its layer of 3 mm, which models of the half-space do not see.
contact::Case rig_on_layer(int periods) {
    contact::Case c = rig(.2, .4);
    c.layer.thickness = 3e-3;
    c.rolling->run_all = true;
    c.rolling->periods = periods;
    c.of<mdr::Settings>().springs = 20000;
    return c;
}

contact::Case relaxing(contact::Case c) {
    c.relaxation = {{{1, .1}, {1, 1}}};
    c.rolling->speed = 5e-3;
    return c;
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

/// Of the medians of CPU times, both in turn.
double ratio_of(const std::function<void()>& own, const std::function<void()>& other) {
    constexpr int runs = 9;
    std::vector<double> own_s, other_s;
    for (int k = 0; k < runs; ++k) {
        const CpuTimer first;
        other();
        other_s.push_back(first.seconds());
        const CpuTimer second;
        own();
        own_s.push_back(second.seconds());
    }
    return median(own_s) / median(other_s);
}

std::function<void()> run_of(const contact::Case& c, MakeModel make) {
    return [&c, make] {
        const auto model = make(c);
        benchmark::DoNotOptimize(contact::run(c, *model).steps.size());
    };
}

void under_law(benchmark::State& state, MakeModel make, int periods, bool relaxes) {
    const contact::Case coulomb = relaxes ? relaxing(rig_on_layer(periods)) : rig_on_layer(periods);
    contact::Case c = coulomb;
    c.friction = law(static_cast<int>(state.range(0)));
    for (auto _ : state)
        state.counters["of_coulomb"] = ratio_of(run_of(c, make), run_of(coulomb, make));
}

void on_springs(benchmark::State& state, MakeModel make, int periods) {
    const contact::Case rigid = rig_on_layer(periods);
    contact::Case c = rigid;
    // k_n a/E* is about 3, k_t as much.
    c.interface = {.normal_stiffness = 5e9, .tangential_stiffness = 5e9};
    for (auto _ : state)
        state.counters["of_rigid"] = ratio_of(run_of(c, make), run_of(rigid, make));
}

#define UNDER_LAWS(name, ...)                       \
    BENCHMARK_CAPTURE(under_law, name, __VA_ARGS__) \
        ->ArgName("law")                            \
        ->DenseRange(1, 3)                          \
        ->Unit(benchmark::kSecond)                  \
        ->Iterations(1)
UNDER_LAWS(springs, springs, 12, false);
UNDER_LAWS(relaxing_springs, springs, 4, true);
UNDER_LAWS(layer_springs, layer_springs, 4, false);
UNDER_LAWS(relaxing_layer_springs, layer_springs, 2, true);
UNDER_LAWS(cells, cells, 12, false);
UNDER_LAWS(relaxing_cells, cells, 4, true);
UNDER_LAWS(layer_cells, layer_cells, 2, false);

#define ON_SPRINGS(name, ...) \
    BENCHMARK_CAPTURE(on_springs, name, __VA_ARGS__)->Unit(benchmark::kSecond)->Iterations(1)
ON_SPRINGS(layer_springs, layer_springs, 4);
ON_SPRINGS(cells, cells, 12);
ON_SPRINGS(layer_cells, layer_cells, 2);

/// Steady rolling of the rig's sphere under .6 mu F_N, whose friction falls by a third at 1 % slip.
void falling(benchmark::State& state) {
    const contact::Case c = rig(.2, .4);
    const auto compliance = bem::case_compliance(c, 1, bem::Body::half_space);
    rolling::RollingProblem problem;
    problem.indenter = c.make_indenter();
    problem.friction = c.friction.law();
    problem.normal.value = *c.load.normal_force;
    problem.drive.force[0] = .6 * c.friction_coefficient() * *c.load.normal_force;
    problem.tolerance = c.of<bem::Settings>().tolerance;
    problem.speed = 1;
    rolling::RollingProblem rated = problem;
    rated.rate = {.drops = {.19}, .speeds = {.01}};
    const auto run = [&](const rolling::RollingProblem& one) {
        return [&] { rolling::steady_rolling(*compliance, one); };
    };
    for (auto _ : state) state.counters["of_coulomb"] = ratio_of(run(rated), run(problem));
}
/// At half the creepage of a force that slides: a search from slow slip, and one from fast slip
/// that knows what the first has found.
void falling_both_ends(benchmark::State& state) {
    const contact::Case c = rig(.2, .4);
    const auto compliance = bem::case_compliance(c, 1, bem::Body::half_space);
    rolling::RollingProblem problem;
    problem.indenter = c.make_indenter();
    problem.friction = c.friction.law();
    problem.normal.value = *c.load.normal_force;
    problem.drive.creepage = {.025, 0};
    problem.tolerance = c.of<bem::Settings>().tolerance;
    problem.speed = 1;
    rolling::RollingProblem slow = problem;
    slow.rate = {.drops = {.1}, .speeds = {.01}};
    rolling::RollingProblem fast = slow;
    fast.slip_start = rolling::SlipStart::fast;
    const auto found = rolling::steady_rolling(*compliance, slow);
    fast.other_state = &found.surface;
    const auto run = [&](const rolling::RollingProblem& one) {
        return [&] { rolling::steady_rolling(*compliance, one); };
    };
    for (auto _ : state) {
        state.counters["of_coulomb"] = ratio_of(run(slow), run(problem));
        state.counters["other_of_coulomb"] = ratio_of(run(fast), run(problem));
    }
}
BENCHMARK(falling_both_ends)->Unit(benchmark::kSecond)->Iterations(1);

/// A ball drawn over rubber by a shift and back, 120 cells in a, with a layer that flows from 0.08
/// MPa on and hardens by so many MPa/m.
void hardening(benchmark::State& state) {
    constexpr double depth = 3e-4;
    contact::Case coulomb = rig(.2, .4);
    coulomb.rolling.reset();
    coulomb.load = {};
    coulomb.load.indentation = depth;
    coulomb.load.tangential_force = 0;
    coulomb.indenter.material.reset();
    coulomb.of<contact::Cells>().spacing = std::sqrt(coulomb.indenter.radius * depth) / 120;
    coulomb.prescribed_path.emplace();
    for (const double shift : {0., 260e-6, 180e-6}) {
        contact::PrescribedPath::Row row;
        row.normal = {contact::NormalControl::Kind::indentation, depth};
        row.tangential[0] = {contact::TangentialControl::Kind::shift, shift};
        row.tangential[1] = {contact::TangentialControl::Kind::shift, 0};
        row.steps = 10;
        coulomb.prescribed_path->rows.push_back(row);
    }
    contact::Case c = coulomb;
    c.friction.yield = contact::InterfaceYield{8e4, 1e6 * static_cast<double>(state.range(0))};
    for (auto _ : state)
        state.counters["of_coulomb"] = ratio_of(run_of(c, cells), run_of(coulomb, cells));
}
BENCHMARK(hardening)
    ->ArgName("MPa_per_m")
    ->Arg(50)
    ->Arg(500)
    ->Arg(5000)
    ->Unit(benchmark::kSecond)
    ->Iterations(1);

BENCHMARK(falling)->Unit(benchmark::kSecond)->Iterations(1);

}  // namespace
}  // namespace tricontact::speed
