// What a step of oscillating rolling costs, and how much of that is Fourier transforms: the cost of
// a step over the cost of one convolution is the figure to compare between machines.

#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "bem/grid_compliance.h"
#include "bem/model.h"
#include "bem/settings.h"
#include "contact/compliances/active_operator.h"
#include "contact/run.h"
#include "contact/surface_model.h"
#include "mdr/model.h"
#include "mdr/settings.h"
#include "speed/rig.h"

namespace tricontact::speed {
namespace {

contact::Case bem_history() {
    contact::Case c = rig(0.24, 0.56);
    c.rolling->steps = contact::Case::Steps::increment;
    c.rolling->increment = 2e-4;
    c.rolling->run_all = true;
    return c;
}

/// The compliance on the grid that the rig's history uses, or on the half of it that tells all.
std::unique_ptr<bem::GridCompliance> rig_compliance(bool half) {
    const contact::Vector2 cell{2e-4, 2e-4};
    return bem::half_space_compliance(
        rig(0.24, 0.56).materials(),
        half ? contact::ContactPoints::mirrored_grid(61, 26, -6e-3, cell)
             : contact::ContactPoints::grid(61, 51, {-6e-3, -5e-3}, cell),
        1);
}

/// One tangential convolution: two fields there and back.
void tangential_convolution(benchmark::State& state) {
    const auto compliance = rig_compliance(state.range(0));
    const std::size_t n = compliance->points().size();
    contact::TangentialField t(n), u(n);
    compliance->tangential(t, u);
    for (auto _ : state) compliance->tangential(t, u);
}
BENCHMARK(tangential_convolution)->ArgName("half")->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);

/// Among the points in contact, which is how the solver asks for it; and the preconditioner.
template <bool preconditions>
void among_contact(benchmark::State& state) {
    constexpr double contact_radius = 4.5e-3;
    const auto compliance = rig_compliance(state.range(0));
    const auto& points = compliance->points();
    std::vector<std::size_t> active;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (std::hypot(points.x[i], points.y[i]) < contact_radius) active.push_back(i);
    const auto products = contact::make_active_operator(*compliance, active);
    contact::TangentialField t(active.size()), u(active.size());
    for (auto _ : state) preconditions ? products->precondition(t, u) : products->apply(t, u);
}
BENCHMARK(among_contact<false>)
    ->Name("contact_product")
    ->ArgName("half")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(among_contact<true>)
    ->Name("preconditioner")
    ->ArgName("half")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMicrosecond);

std::unique_ptr<contact::Model> on_whole_grid(const contact::Case& c) {
    return std::make_unique<contact::SurfaceModel>(
        "bem", *bem::make_substrate(c, 1, bem::Body::half_space), c.make_indenter(),
        c.friction.law(), c.of<bem::Settings>().tolerance, c.contact);
}

/// 12 periods at 0.2 mm, tolerance 1e-7; `ms_per_step` CPU, `convolutions_per_step` counted. On
/// half of the grid, as the model takes it, or on all of it, as it would where nothing is
/// symmetric.
void bem_rolling(benchmark::State& state) {
    const contact::Case c = bem_history();
    double steps = 0, convolutions = 0, cpu = 0;
    for (auto _ : state) {
        const auto model = state.range(0) ? bem::make_model(c, 1) : on_whole_grid(c);
        const contact::History history = contact::run(c, *model);
        steps += static_cast<double>(history.steps.size());
        cpu += history.cpu_s;
        for (const auto& step : history.steps) convolutions += step.tangential_iterations;
    }
    state.counters["ms_per_step"] = 1e3 * cpu / steps;
    state.counters["convolutions_per_step"] = convolutions / steps;
}
BENCHMARK(bem_rolling)->ArgName("half")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

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
    c.of<mdr::Settings>().springs = 1000;
    for (auto _ : state) {
        const auto model = mdr::make_model(c);
        benchmark::DoNotOptimize(contact::run(c, *model).static_shift);
    }
}
BENCHMARK(mdr_history)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tricontact::speed
