// Micro-walking machines in the processor's vectors: steps of one machine per second and core, and
// what share of the processor's arithmetic they use; the design of experiments of the thesis.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "speed/arithmetic_peak.h"
#include "speed/cpu_timer.h"
#include "walking/kernels/batch.h"
#include "walking/machine/velocity_verlet.h"
#include "walking/machine/walk_case.h"

namespace tricontact::speed {
namespace {

using namespace walking;
constexpr double step = 1e-3;

/// Wetter (2016), eq. 4.1.26.
constexpr Kappas set_b{2, 1.2, 0.5, 1e-4, 0.68, 1e-4, 0.42, 1.18};

std::vector<Motion> starts_of(const std::vector<Machine>& machines) {
    std::vector<Motion> starts;
    for (const Machine& machine : machines) starts.push_back(motion_at_start(machine));
    return starts;
}

/// Arithmetic vector instructions of a step of the two-spot model, counted in
/// kernel_step.h: with a fused multiply-add and one instruction for the clamp, with the clamp in
/// three, with multiplications and additions apart.
double instructions(Kernel kernel) {
    switch (kernel) {
        case Kernel::avx512:
            return 57;
        case Kernel::avx2:
            return 63;
        default:
            return 84;
    }
}

/// `lane_steps`: of one machine, per second on one core, the best of many short runs; `of_peak`:
/// the share of the arithmetic instructions that the core can do, measured in turn with the runs.
void kernel_speed(benchmark::State& state, Kernel kernel, Machine::Model model) {
    constexpr std::int64_t n_steps = 5'000;
    const std::vector<Machine> machines(240, {.kappas = set_b, .model = model});
    Batch batch(machines, starts_of(machines), step, kernel);
    std::vector<StretchSums> sums(machines.size());
    double best = 0, peak = 0;
    for (auto _ : state) {
        const CpuTimer timer;
        batch.advance(n_steps, sums);
        const double seconds = timer.seconds();
        state.SetIterationTime(seconds);
        best = std::max(best, static_cast<double>(n_steps * machines.size()) / seconds);
        peak = std::max(peak, arithmetic_peak(kernel));
    }
    state.counters["lane_steps"] = best;
    const int lanes = 1 << static_cast<int>(kernel);  // of a vector
    if (model == Machine::Model::two_spot && kernel != Kernel::plain)
        state.counters["of_peak"] = best * instructions(kernel) / (lanes * peak);
}

/// The same of the integrator of one machine.
void one_machine(benchmark::State& state) {
    const Machine machine{.kappas = set_b};
    VelocityVerlet run(machine, motion_at_start(machine), step);
    double best = 0;
    for (auto _ : state) {
        constexpr int n_steps = 100'000;
        const CpuTimer timer;
        for (int n = 0; n < n_steps; ++n) run.advance();
        best = std::max(best, n_steps / timer.seconds());
    }
    state.counters["lane_steps"] = best;
}

/// Wetter (2016), section 4.2.2: three levels of eight parameters.
std::vector<Machine> design_of_experiments() {
    constexpr double levels[8][3] = {{.1, 1, 10},        {1, 1.2, 1.4}, {.5, 1, 1.5},
                                     {1e-4, 1e-3, 1e-2}, {.2, .4, .6},  {1e-4, 1e-3, 1e-2},
                                     {.5, 1, 1.5},       {-.8, 0, .8}};
    std::vector<Machine> machines;
    for (int i = 0; i < 6561; ++i) {
        double k[8];
        for (int j = 0, rest = i; j < 8; ++j, rest /= 3) k[j] = levels[j][rest % 3];
        machines.push_back({.kappas = {k[0], k[1], k[2], k[3], k[4], k[5], k[6], k[7]}});
    }
    return machines;
}

/// 6561 machines, 4e6 steps each, statistics of the second half. `finite`: runs whose results are;
/// `tilted`: that were stopped early; `lane_steps`: made in all.
void design(benchmark::State& state) {
    const std::vector<Machine> machines = design_of_experiments();
    const std::vector<Motion> starts = starts_of(machines);
    for (auto _ : state) {
        Batch batch(machines, starts, step);
        std::vector<StretchSums> sums(machines.size());
        batch.advance(2'000'000, {});
        batch.advance(2'000'000, sums);
        double finite = 0, tilted = 0, lane_steps = 0;
        for (std::size_t i = 0; i < machines.size(); ++i) {
            const Motion motion = batch.motion(i);
            finite += std::isfinite(sums[i].spring_force + motion.x + motion.z + motion.phi);
            tilted += batch.tilted(i).has_value();
            lane_steps += motion.time / step;
        }
        state.counters["finite"] = finite;
        state.counters["tilted"] = tilted;
        state.counters["lane_steps"] = lane_steps;
    }
}
BENCHMARK(design)->Name("design_of_experiments")->Iterations(1)->Unit(benchmark::kSecond);

void register_kernels() {
    benchmark::RegisterBenchmark("one_machine", one_machine)->Unit(benchmark::kMillisecond);
    constexpr const char* names[] = {"plain", "sse2", "avx2", "avx512"};
    for (const Kernel kernel : available_kernels())
        for (const auto model : {Machine::Model::two_spot, Machine::Model::prism}) {
            const std::string name = names[static_cast<int>(kernel)];
            const char* shape = model == Machine::Model::prism ? "/prism" : "/two-spot";
            benchmark::RegisterBenchmark((name + shape).c_str(), kernel_speed, kernel, model)
                ->Iterations(100)
                ->UseManualTime()
                ->Unit(benchmark::kMillisecond);
        }
}

}  // namespace
}  // namespace tricontact::speed

int main(int argc, char** argv) {
    tricontact::speed::register_kernels();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
