// Frictionless contact on large grids: time per iteration over the time of its one convolution, and
// the peak memory of the process (run one size at a time: --benchmark_filter=1024).

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include "bem/grid_compliance.h"
#include "contact/solvers/contact_region.h"
#include "contact/solvers/normal_solver.h"
#include "speed/rig.h"

namespace tricontact::speed {
namespace {

contact::ContactPoints grid_of(int n) {
    // 0.9 of the grid's width is in contact.
    const double spacing = 2 * half_space_scales(rig(0, 0)).contact_radius / (0.9 * n);
    return contact::ContactPoints::grid(n, n, {-(n - 1) * spacing / 2, -(n - 1) * spacing / 2},
                                        {spacing, spacing});
}

double peak_memory_GB() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss * 1024. / 1e9;
}

void normal_contact(benchmark::State& state) {
    const contact::Case c = rig(0, 0);
    const auto compliance =
        bem::half_space_compliance(c.materials(), grid_of(static_cast<int>(state.range(0))), 1);
    const auto height = heights_over(compliance->points(), *c.make_indenter(), {0, 0});
    const contact::NormalSolver solver(*compliance, 1e-8);
    double iterations = 0;
    for (auto _ : state)
        iterations += solver.solve(height, {contact::NormalControl::Kind::force, 21.1}).iterations;
    state.counters["iterations"] = iterations / static_cast<double>(state.iterations());
    state.counters["s_per_iteration"] =
        benchmark::Counter(iterations, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    state.counters["peak_memory_GB"] = peak_memory_GB();
}
BENCHMARK(normal_contact)->Arg(256)->Arg(1024)->Arg(2048)->Unit(benchmark::kSecond)->Iterations(1);

void normal_convolution(benchmark::State& state) {
    const contact::ContactPoints grid = grid_of(static_cast<int>(state.range(0)));
    const auto compliance = bem::half_space_compliance(rig(0, 0).materials(), grid, 1);
    std::vector<double> p(grid.size(), 1.0), u(grid.size());
    for (auto _ : state) compliance->normal(p, u);
}
BENCHMARK(normal_convolution)->Arg(256)->Arg(1024)->Arg(2048)->Unit(benchmark::kSecond);

}  // namespace
}  // namespace tricontact::speed
