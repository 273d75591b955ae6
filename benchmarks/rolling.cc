// What a step of oscillating rolling costs, and how much of that is Fourier transforms: the cost of
// a step over the cost of one convolution is the figure to compare between machines.

#include <benchmark/benchmark.h>
#include <fftw3.h>

#include "bem/grid_compliance.h"
#include "bem/model.h"
#include "benchmarks/rig.h"
#include "contact/run.h"
#include "mdr/model.h"

namespace tricontact::benchmarks {
namespace {

contact::Case bem_history() {
    contact::Case c = rig(0.24, 0.56);
    c.rolling->steps = contact::Case::Steps::increment;
    c.rolling->increment = 2e-4;
    c.rolling->run_all = true;
    return c;
}

/// The compliance on the grid that the rig's history uses.
std::unique_ptr<bem::GridCompliance> rig_compliance() {
    return bem::half_space_compliance(
        rig(0.24, 0.56).materials(),
        contact::ContactPoints::grid(61, 51, {-6e-3, -5e-3}, {2e-4, 2e-4}), 1);
}

/// One tangential convolution: two forward and two inverse transforms.
void tangential_convolution(benchmark::State& state) {
    const auto compliance = rig_compliance();
    const std::size_t n = compliance->points().size();
    contact::TangentialField t(n), u(n);
    compliance->tangential(t, u);
    for (auto _ : state) compliance->tangential(t, u);
}
BENCHMARK(tangential_convolution)->Unit(benchmark::kMicrosecond);

/// One application of the preconditioner: the same on the bare grid.
void preconditioner(benchmark::State& state) {
    const auto compliance = rig_compliance();
    const std::size_t n = compliance->points().size();
    contact::TangentialField r(n), z(n);
    compliance->precondition_tangential(r, z);
    for (auto _ : state) compliance->precondition_tangential(r, z);
}
BENCHMARK(preconditioner)->Unit(benchmark::kMicrosecond);

/// 12 periods at 0.2 mm, tolerance 1e-7; `ms_per_step` CPU, `convolutions_per_step` counted.
void bem_rolling(benchmark::State& state) {
    const contact::Case c = bem_history();
    double steps = 0, convolutions = 0, cpu = 0;
    for (auto _ : state) {
        const auto model = bem::make_model(c, 1);
        const contact::History history = contact::run(c, *model);
        steps += static_cast<double>(history.steps.size());
        cpu += history.cpu_s;
        for (const auto& step : history.steps) convolutions += step.tangential_iterations;
    }
    state.counters["ms_per_step"] = 1e3 * cpu / steps;
    state.counters["convolutions_per_step"] = convolutions / steps;
}
BENCHMARK(bem_rolling)->Unit(benchmark::kMillisecond);

/// Until nothing moves any more, or 12 periods, by turning points; (w, f_T) as in the table of the
/// thesis.
void bem_shakedown_by_turning_points(benchmark::State& state) {
    contact::Case c = rig(0.24, 0.56);
    c.rolling->steps = contact::Case::Steps::turning_points;
    for (auto _ : state) {
        const auto model = bem::make_model(c, 1);
        benchmark::DoNotOptimize(contact::run(c, *model).static_shift);
    }
}
BENCHMARK(bem_shakedown_by_turning_points)->Unit(benchmark::kMillisecond);

/// 1000 springs, 12 periods at 60 steps per quarter.
void mdr_history(benchmark::State& state) {
    contact::Case c = rig(0.24, 0.56);
    c.rolling->steps_per_quarter = 60;
    c.rolling->run_all = true;
    c.mdr.springs = 1000;
    for (auto _ : state) {
        const auto model = mdr::make_model(c);
        benchmark::DoNotOptimize(contact::run(c, *model).static_shift);
    }
}
BENCHMARK(mdr_history)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tricontact::benchmarks
