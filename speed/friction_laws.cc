// What a law of friction costs: runs of the rig on springs and on cells, each beside the same run
// under Coulomb's law, in turn. `of_coulomb`: ratio of the medians.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <vector>

#include "bem/model.h"
#include "contact/run.h"
#include "mdr/model.h"
#include "mdr/settings.h"
#include "speed/rig.h"

namespace tricontact::speed {
namespace {

contact::Friction law(int number) {
    const std::array laws{
        contact::Friction{.coefficient = .57}, contact::Friction{.shear_strength = 1e5},
        contact::Friction{.coefficient = .57, .pressure_exponent = .7, .reference_pressure = 2e5},
        contact::Friction{.coefficient = .57, .strength_limit = 1e5}};
    return laws[static_cast<std::size_t>(number)];
}

double seconds(const contact::Case& c, bool by_springs) {
    const auto begin = std::clock();
    const auto model = by_springs ? mdr::make_model(c) : bem::make_model(c, 1);
    contact::run(c, *model);
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

void run_under_law(benchmark::State& state) {
    constexpr int runs = 9;
    contact::Case c = rig(.2, .4), coulomb = c;
    for (contact::Case* one : {&c, &coulomb}) {
        one->rolling->run_all = true;
        one->rolling->periods = 12;
        one->of<mdr::Settings>().springs = 20000;
    }
    c.friction = law(static_cast<int>(state.range(1)));
    const bool by_springs = state.range(0) == 0;
    for (auto _ : state) {
        std::vector<double> own, of_coulomb;
        for (int k = 0; k < runs; ++k) {
            of_coulomb.push_back(seconds(coulomb, by_springs));
            own.push_back(seconds(c, by_springs));
        }
        state.counters["of_coulomb"] = median(own) / median(of_coulomb);
    }
}
BENCHMARK(run_under_law)
    ->ArgNames({"bem", "law"})
    ->ArgsProduct({{0, 1}, {1, 2, 3}})
    ->Unit(benchmark::kSecond)
    ->Iterations(1);

}  // namespace
}  // namespace tricontact::speed
