// What finite strains cost beside the linear layer on the same mesh: a step of rolling, pressing
// from nothing, a settled shift. Sizes are the benchmarks' arguments, in hundredths of a
// millimetre.

#include <benchmark/benchmark.h>

#include <filesystem>

#include "contact/run.h"
#include "contact/surface_model.h"
#include "fem/case/layer_condenser.h"
#include "fem/case/model.h"
#include "fem/finite_strain/strained_model.h"
#include "fem/settings.h"
#include "speed/cpu_timer.h"
#include "speed/rig.h"

namespace tricontact::speed {
namespace {

using contact::Case;

Case rubber(double w, double size) {
    Case c = rig(w, .56);
    c.indenter.material.reset();
    c.law = Case::Law::neo_hookean;
    c.layer.thickness = 8e-3;
    c.load.press_steps = 5;
    c.of<fem::Settings>().size = size;
    c.of<fem::Settings>().cache =
        std::filesystem::temp_directory_path() / "tricontact_benchmark_layers";
    c.rolling->amplitude_ratio.reset();
    c.rolling->amplitude = w * 4.3638e-3;  // of the linear layer's contact radius
    return c;
}

double size_of(const benchmark::State& state) {
    return 1e-5 * static_cast<double>(state.range(0));
}

/// Both models on one mesh.
struct Layer {
    explicit Layer(const Case& c) : layer(fem::LayerCondenser(c, {}).make(fem::make_mesh(c, {}))) {
        linear = std::make_unique<contact::SurfaceModel>(
            "fem", layer, c.make_indenter(), c.friction.law(), c.of<fem::Settings>().tolerance,
            c.contact);
        strained = std::make_unique<fem::StrainedModel>(fem::StrainedModel::Setup{
            .layer = layer,
            .indenter = c.make_indenter(),
            .rolling_radius = c.indenter.radius,
            .friction = c.friction.law(),
            .tolerance = fem::of_fem_tolerance * c.of<fem::Settings>().tolerance,
            .relaxation = {}});
    }
    std::shared_ptr<const fem::CondensedCompliance> layer;
    std::unique_ptr<contact::Model> linear, strained;
};

/// Per step of rolling by .2 mm, CPU time: `ms`, `ms_linear`, `ms_beyond`; mean and largest
/// `iterations`; `unknowns` of the whole body.
void strained_rolling(benchmark::State& state) {
    Case c = rubber(.24, size_of(state));
    c.rolling->steps = Case::Steps::increment;
    c.rolling->increment = 2e-4;
    c.rolling->run_all = true;
    c.rolling->periods = 1;
    Layer both(c);
    const contact::LoadPath path = contact::make_load_path(c, *c.load.normal_force, 4.3638e-3);
    for (auto* model : {both.linear.get(), both.strained.get()})
        for (const auto* steps : {&path.pressing, &path.loading})
            for (const auto& step : *steps) model->advance(step);
    double linear = 0, strained = 0, iterations = 0, most = 0;
    const auto seconds = [](contact::Model& model, const contact::LoadStep& step, int& taken) {
        const CpuTimer timer;
        taken = model.advance(step).tangential_iterations;
        return timer.seconds();
    };
    for (auto _ : state)
        for (const auto& step : path.period) {
            int taken = 0;
            linear += seconds(*both.linear, step, taken);
            strained += seconds(*both.strained, step, taken);
            iterations += taken;
            most = std::max(most, static_cast<double>(taken));
        }
    const double steps = static_cast<double>(path.period.size() * state.iterations());
    state.counters["ms"] = 1e3 * strained / steps;
    state.counters["ms_linear"] = 1e3 * linear / steps;
    state.counters["ms_beyond"] = 1e3 * (strained - linear) / steps;
    state.counters["iterations"] = iterations / steps;
    state.counters["most_iterations"] = most;
    state.counters["unknowns"] = both.layer->corrected().discretisation.unknowns.n;
}
BENCHMARK(strained_rolling)->Arg(100)->Arg(50)->Unit(benchmark::kSecond)->Iterations(1);

/// In one step from nothing, without friction, on elements of 1 mm; the load [N] is the argument.
void strained_pressing(benchmark::State& state) {
    Case c = rubber(.24, 1e-3);
    c.rolling.reset();
    c.load.normal_force = static_cast<double>(state.range(0));
    const Layer both(c);
    contact::LoadStep step = contact::press_step(c);
    step.friction = false;
    double iterations = 0;
    for (auto _ : state) {
        both.strained->release();
        iterations = both.strained->advance(step).normal_iterations;
    }
    state.counters["iterations"] = iterations;
}
BENCHMARK(strained_pressing)
    ->Arg(5)
    ->Arg(21)
    ->Arg(42)
    ->Arg(84)
    ->Arg(168)
    ->Unit(benchmark::kMillisecond);

/// The whole run by turning points until it stands; `settled_um` [um], w = .24 and f_T = .56.
void strained_settled(benchmark::State& state) {
    Case c = rubber(.24, size_of(state));
    c.rolling->steps = Case::Steps::turning_points;
    contact::History history;
    for (auto _ : state) history = contact::run(c, *fem::make_model(c, {}));
    state.counters["periods"] = static_cast<double>(history.shift_per_period.size());
    state.counters["steps"] = static_cast<double>(history.steps.size());
    state.counters["settled_um"] = 1e6 * history.shift_per_period.back();
}
BENCHMARK(strained_settled)->Arg(100)->Unit(benchmark::kSecond)->Iterations(1);

}  // namespace
}  // namespace tricontact::speed
