// What the finite element layer costs: condensing it, taking it from the cache, stepping on it.
// Sizes are the benchmarks' arguments, in hundredths of a millimetre.

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <filesystem>

#include "contact/load_path.h"
#include "contact/run.h"
#include "fem/case/model.h"
#include "fem/settings.h"
#include "speed/rig.h"

namespace tricontact::speed {
namespace {

contact::Case layer(const benchmark::State& state, const std::string& cache) {
    contact::Case c = rig(0.24, 0.56);
    c.indenter.material.reset();
    c.layer.thickness = 8e-3;
    c.of<fem::Settings>().size = 1e-5 * static_cast<double>(state.range(0));
    c.of<fem::Settings>().cache = cache;
    c.rolling->steps = contact::Case::Steps::increment;
    c.rolling->increment = 2e-4;
    c.rolling->run_all = true;
    c.rolling->periods = 3;
    return c;
}

std::string cache_folder() {
    return std::filesystem::temp_directory_path() / "tricontact_benchmark_layers";
}

/// Probe of the contact, mesh and condensation; peak memory of the process: one size at a time.
void condensation(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(fem::make_model(layer(state, "none"), {}));
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    state.counters["peak_GB"] = static_cast<double>(usage.ru_maxrss) / 1e6;
}
BENCHMARK(condensation)->Arg(100)->Arg(50)->Arg(35)->Unit(benchmark::kSecond)->Iterations(1);

/// The same from the cache: what a second run waits before its first step.
void from_cache(benchmark::State& state) {
    const contact::Case c = layer(state, cache_folder());
    fem::make_model(c, {});
    for (auto _ : state) benchmark::DoNotOptimize(fem::make_model(c, {}));
}
BENCHMARK(from_cache)->Arg(100)->Arg(50)->Unit(benchmark::kSecond)->Iterations(3);

/// Displacements and stresses inside, for a section at the end of a run, the layer from the cache.
void section(benchmark::State& state) {
    const contact::Case c = layer(state, cache_folder());
    const auto model = fem::make_model(c, {});
    model->advance(contact::press_step(c));
    for (auto _ : state) benchmark::DoNotOptimize(model->interior());
}
BENCHMARK(section)->Arg(100)->Arg(50)->Unit(benchmark::kSecond)->Iterations(1);

/// 20 steps of pressing, then three periods; `ms_per_step` and `s_per_400_steps` of CPU time.
void layer_rolling(benchmark::State& state) {
    const contact::Case c = layer(state, cache_folder());
    double steps = 0, cpu = 0, normal = 0, tangential = 0;
    for (auto _ : state) {
        const auto model = fem::make_model(c, {});
        const contact::History history = contact::run(c, *model);
        steps += static_cast<double>(history.steps.size());
        cpu += history.cpu_s;
        for (const auto& step : history.steps) {
            normal += step.normal_iterations;
            tangential += step.tangential_iterations;
        }
    }
    state.counters["normal_per_step"] = normal / steps;  // factors of the points in contact, about
    state.counters["tangential_per_step"] = tangential / steps;  // products among them
    state.counters["ms_per_step"] = 1e3 * cpu / steps;
    state.counters["s_per_400_steps"] = 400 * cpu / steps;
}
BENCHMARK(layer_rolling)->Arg(100)->Arg(50)->Unit(benchmark::kSecond)->Iterations(1);

}  // namespace
}  // namespace tricontact::speed
