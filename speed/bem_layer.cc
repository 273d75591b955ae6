// What the layer without a mesh costs, and what a relaxing substrate adds.

#include <benchmark/benchmark.h>

#include "bem/grid_compliance.h"
#include "bem/model.h"
#include "contact/run.h"
#include "speed/rig.h"
#include "theory/layer/layer_stack.h"

namespace tricontact::speed {
namespace {

contact::Case layer() {
    contact::Case c = rig(0.24, 0.56);
    c.indenter.material.reset();
    c.layer.thickness = 8e-3;
    return c;
}

/// All coefficients of the rig's grid, and their transforms.
void layer_coefficients(benchmark::State& state) {
    const contact::Case c = layer();
    const auto grid = contact::ContactPoints::grid(61, 51, {-6e-3, -5e-3}, {2e-4, 2e-4});
    contact::TangentialField t(grid.size()), u(grid.size());
    for (auto _ : state) {
        const auto compliance =
            bem::layer_compliance(theory::layers_of("bem-layer", c), {}, grid, 1);
        compliance->tangential(t, u);
    }
}
BENCHMARK(layer_coefficients)->Unit(benchmark::kSecond);

/// Coupled, by turning points until nothing moves, 0.2 mm cells, pressed in 20 steps.
void coupled_shakedown_point(benchmark::State& state) {
    contact::Case c = layer();
    c.rolling->steps = contact::Case::Steps::turning_points;
    c.rolling->periods = 100;
    contact::History history;
    for (auto _ : state) history = contact::run(c, *bem::make_model(c, 1, bem::Body::layer));
    int normal = 0, tangential = 0;
    for (const auto& step : history.steps) {
        normal += step.normal_iterations;
        tangential += step.tangential_iterations;
    }
    state.counters["steps"] = static_cast<double>(history.steps.size());
    state.counters["normal"] = normal;  // convolutions, about
    state.counters["tangential"] = tangential;
}
BENCHMARK(coupled_shakedown_point)->Unit(benchmark::kSecond);

/// 12 periods of 60 steps per quarter on the half-space, on a substrate of so many branches.
contact::Case fine_rolling(int n_branches) {
    contact::Case c = rig(0.24, 0.56);
    c.rolling->steps = contact::Case::Steps::per_quarter;
    c.rolling->steps_per_quarter = 60;
    c.rolling->run_all = true;
    if (n_branches == 0) return c;
    c.rolling->speed = 1e-3;
    c.relaxation.emplace();
    for (int b = 0; b < n_branches; ++b)
        c.relaxation->branches.push_back({.3, std::pow(10., b - 1)});
    return c;
}

void rolling_with_branches(benchmark::State& state) {
    const contact::Case c = fine_rolling(static_cast<int>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(contact::run(c, *bem::make_model(c, 1)).static_shift);
}
BENCHMARK(rolling_with_branches)->Arg(0)->Arg(1)->Arg(3)->Unit(benchmark::kSecond)->Iterations(1);

/// The same, uncoupled, on a substrate whose bulk does not relax.
void rolling_where_a_part_relaxes(benchmark::State& state) {
    contact::Case c = fine_rolling(static_cast<int>(state.range(0)));
    c.substrate.poisson = .45;
    c.relaxation->bulk = contact::Relaxation::Bulk::elastic;
    c.contact.coupling = false;
    for (auto _ : state)
        benchmark::DoNotOptimize(contact::run(c, *bem::make_model(c, 1)).static_shift);
}
BENCHMARK(rolling_where_a_part_relaxes)->Arg(1)->Arg(3)->Unit(benchmark::kSecond)->Iterations(1);

}  // namespace
}  // namespace tricontact::speed
