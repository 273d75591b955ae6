// A whole run with friction on a large grid, from the case to the end of its steps, by one and two
// threads: time by the clock, of the first thread and of all, and the peak memory (run one problem
// at a time).

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cmath>
#include <ctime>

#include "bem/model.h"
#include "bem/settings.h"
#include "contact/case.h"
#include "contact/cells.h"
#include "contact/run.h"

namespace tricontact::speed {
namespace {

/// A rough plane over a periodic half-space, or a rough ball, pressed in one step and loaded along
/// x in another; about `n` cells along a side of the grid, 16 in the shortest wave.
contact::Case rough_case(int n, bool is_free) {
    constexpr double length = 1e-4;
    contact::Case c;
    c.substrate = {25e6 * .75, .5};
    c.friction.coefficient = .5;
    c.of<contact::Cells>().spacing = length / n;
    c.of<bem::Settings>().tolerance = 1e-5;
    c.load.press_steps = 1;
    c.load.tangential_ratio = .5;
    c.indenter.roughness = contact::Roughness{.hurst = .8,
                                              .rms_slope = is_free ? .05 : 1.,
                                              .long_wavelength = length,
                                              .roll_off = length / 5,
                                              .short_wavelength = 16 * length / n,
                                              .seed = 1};
    if (is_free) {
        c.indenter.radius = 2 * length;
        // The grid reaches over Hertz' contact until the roughness is clear of its edge.
        c.load.normal_force = 4. / 3 * 25e6 * std::pow(.296 * length, 3) / c.indenter.radius;
    } else {
        c.indenter.shape = contact::Case::Shape::flat;
        c.period = length;
        c.load.normal_force = .05 * 25e6 * length * length;
    }
    return c;
}

double thread_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void rough_run(benchmark::State& state) {
    const contact::Case c = rough_case(static_cast<int>(state.range(0)), state.range(1) != 0);
    auto& to = state.counters;
    for (auto _ : state) {
        const auto cpu = std::clock();
        const double begin = thread_seconds();
        const auto model = bem::make_model(c, static_cast<int>(state.range(2)));
        to["first_makes_model_s"] = thread_seconds() - begin;
        const contact::History history = contact::run(c, *model);
        to["first_thread_s"] = thread_seconds() - begin;
        to["all_threads_s"] = static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC;
        to["cells"] = static_cast<double>(model->surface().normal_traction.size());
        to["normal"] = history.steps.back().normal_iterations;
        to["tangential"] = history.steps.back().tangential_iterations;
        to["shift_over_indentation"] = history.static_shift / history.steps.back().indentation;
    }
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    to["peak_memory_GB"] = static_cast<double>(usage.ru_maxrss) * 1024 / 1e9;
}
BENCHMARK(rough_run)
    ->ArgNames({"cells", "free", "threads"})
    ->ArgsProduct({{512, 1024, 2048}, {0, 1}, {1, 2}})
    ->UseRealTime()
    ->Unit(benchmark::kSecond)
    ->Iterations(1);

}  // namespace
}  // namespace tricontact::speed
