// What a steady state of rolling costs: elastic, and over a relaxing half-space, whose kernel has
// crept along the way, or which is rolled over until nothing changes.

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <memory>

#include "bem/grid_compliance.h"
#include "bem/settings.h"
#include "bem/steady_model.h"
#include "contact/bodies/indenter.h"
#include "contact/cells.h"
#include "contact/friction/friction.h"
#include "contact/relaxing_case.h"
#include "rolling/run.h"
#include "speed/cpu_timer.h"

namespace tricontact::speed {
namespace {

/// A cylinder of 80 cells, visc_cylindr of the program CONTACT, on rubber that relaxes to half of
/// its stiffness on a way of so many mm; or a sphere on it.
contact::Case rolled(double way_mm, bool sphere) {
    contact::Case c;
    c.indenter.radius = .05;
    if (!sphere) {
        c.indenter.shape = contact::Case::Shape::cylinder;
        c.indenter.length = 1;
    }
    c.substrate = {800e6, .4};
    c.contact.coupling = false;
    c.relaxation = {{{1, way_mm * 1e-3}}};
    c.friction.coefficient = .3;
    c.load.normal_force = sphere ? 5e3 : 6e5;
    c.tractive_rolling.emplace();
    c.tractive_rolling->speed = 1;
    if (sphere)
        c.of<contact::Cells>().per_radius = 20;
    else
        c.of<contact::Cells>().spacing = .16e-3;
    c.of<bem::Settings>().tolerance = 1e-5;
    return c;
}

rolling::RollingProblem problem_of(const contact::Case& c) {
    rolling::RollingProblem problem;
    problem.indenter = c.make_indenter();
    problem.friction = c.friction.law();
    problem.normal.value = *c.load.normal_force;
    problem.drive.force[0] = .6 * c.friction_coefficient() * *c.load.normal_force;
    problem.coupling = false;
    problem.tolerance = c.of<bem::Settings>().tolerance;
    problem.speed = c.tractive_rolling->speed;
    return problem;
}

/// Kernel included: `ms` of CPU a point, `products` of the compliance, and the time of an elastic
/// point, `over_elastic`.
void steady_point(benchmark::State& state, bool sphere) {
    const contact::Case c = rolled(static_cast<double>(state.range(0)), sphere);
    const contact::Case elastic = contact::with_relaxing_ratio(c, 1);
    const rolling::RollingProblem problem = problem_of(c);
    double relaxing_s = 0, elastic_s = 0, products = 0, n = 0;
    for (auto _ : state) {
        const CpuTimer first;
        const auto steady = bem::steady_compliance(c, 1, bem::Body::half_space);
        products += rolling::steady_rolling(*steady, problem).state.iterations;
        relaxing_s += first.seconds();
        const CpuTimer second;
        const auto compliance = bem::case_compliance(elastic, 1, bem::Body::half_space);
        benchmark::DoNotOptimize(rolling::steady_rolling(*compliance, problem).state.force);
        elastic_s += second.seconds();
        ++n;
    }
    state.counters["ms"] = 1e3 * relaxing_s / n;
    state.counters["products"] = products / n;
    state.counters["over_elastic"] = relaxing_s / elastic_s;
}
BENCHMARK_CAPTURE(steady_point, cylinder, false)
    ->Arg(9)
    ->Arg(45)
    ->Arg(2000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(steady_point, sphere, true)->Arg(9)->Unit(benchmark::kMillisecond);

enum class Driven : std::uint8_t { creeps, spins, pulled };

/// A sphere on 2 n + 7 cells a side at a creepage of 0.7 mu a/R, spinning by mu/(2 R), or under 0.6
/// of its friction: `products` of the compliance, those of normal contact included, `ms` of CPU
/// without the kernel, and the larger component of the `force` [N].
void driven_sphere(benchmark::State& state, Driven driven) {
    constexpr double radius = .07, a = 4e-3, friction = .35;
    const auto n = static_cast<int>(state.range(0));
    const contact::MaterialPair materials{{}, {3e6, .3}};
    const double h = a / n, first = -(n + 3) * h, unit = friction * a / radius;
    const auto compliance = bem::half_space_compliance(
        materials, contact::ContactPoints::grid(2 * n + 7, 2 * n + 7, {first, first}, {h, h}), 1);
    rolling::RollingProblem problem;
    problem.indenter = std::make_shared<contact::Paraboloid>(radius);
    problem.friction = contact::Friction{friction}.law();
    problem.normal.value = 4. / 3 * materials.effective_modulus() * std::pow(a, 3) / radius;
    problem.coupling = false;
    if (driven == Driven::pulled)
        problem.drive.force[0] = .6 * friction * problem.normal.value;
    else
        problem.drive.creepage = {driven == Driven::creeps ? .7 * unit : 0, 0};
    if (driven == Driven::spins) problem.drive.spin = .5 * unit / a;
    double products = 0, seconds = 0, runs = 0, force = 0;
    for (auto _ : state) {
        const CpuTimer timer;
        const auto steady = rolling::steady_rolling(*compliance, problem).state;
        products += steady.iterations;
        force = steady.force[driven == Driven::spins ? 1 : 0];
        seconds += timer.seconds();
        ++runs;
    }
    state.counters["products"] = products / runs;
    state.counters["ms"] = 1e3 * seconds / runs;
    state.counters["force"] = force;
}
BENCHMARK_CAPTURE(driven_sphere, creeps, Driven::creeps)
    ->Arg(24)
    ->Arg(68)
    ->Arg(146)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(driven_sphere, spins, Driven::spins)
    ->Arg(24)
    ->Arg(68)
    ->Arg(146)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(driven_sphere, pulled, Driven::pulled)
    ->Arg(24)
    ->Arg(68)
    ->Arg(146)
    ->Unit(benchmark::kMillisecond);

/// Rolled on until nothing changes, over the steady state by itself (`over_steady`).
void rolled_until_steady(benchmark::State& state) {
    const contact::Case c = rolled(static_cast<double>(state.range(0)), false);
    const rolling::RollingProblem problem = problem_of(c);
    double rolled_s = 0, steady_s = 0;
    for (auto _ : state) {
        const CpuTimer first;
        const auto substrate = bem::make_substrate(c, 1, bem::Body::half_space);
        benchmark::DoNotOptimize(rolling::steady_rolling(*substrate, problem).state.force);
        rolled_s += first.seconds();
        const CpuTimer second;
        const auto steady = bem::steady_compliance(c, 1, bem::Body::half_space);
        benchmark::DoNotOptimize(rolling::steady_rolling(*steady, problem).state.force);
        steady_s += second.seconds();
    }
    state.counters["over_steady"] = rolled_s / steady_s;
}
BENCHMARK(rolled_until_steady)->Arg(9)->Arg(45)->Unit(benchmark::kSecond)->Iterations(1);

}  // namespace
}  // namespace tricontact::speed
