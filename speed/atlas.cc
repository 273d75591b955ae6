// What a number from an atlas costs: one read at a point, alone and beside the other maps there, by
// the functions of contact_maps.h, and one of a million.

#include "atlas/atlas.h"

#include <benchmark/benchmark.h>

#include <numbers>
#include <vector>

#include "atlas/contact_maps.h"
#include "atlas/shipped.h"
#include "statistics/latin_hypercube.h"

namespace tricontact::speed {
namespace {

const atlas::Atlas& half_space() {
    return atlas::shipped("sphere_half_space");
}

std::vector<double> drawn_points(const atlas::Atlas& atlas, std::size_t n) {
    statistics::SplitMix64 random(1);
    std::vector<double> points;
    for (std::size_t i = 0; i < n; ++i)
        for (const atlas::Axis& axis : atlas.axes)
            points.push_back(axis.range.from +
                             random.uniform() * (axis.range.to - axis.range.from));
    return points;
}

/// The first `maps` of the atlas at a point: the settled shift, and kappa.
void read_at_a_point(benchmark::State& state) {
    const std::size_t n_axes = half_space().axes.size(), n_points = 1024;
    const std::vector<double> points = drawn_points(half_space(), n_points);
    atlas::Reader reader(half_space());
    std::size_t i = 0;
    for (auto _ : state) {
        reader.go_to(std::span(points).subspan(i++ % n_points * n_axes, n_axes));
        for (std::int64_t m = 0; m < state.range(0); ++m)
            benchmark::DoNotOptimize(reader.read(half_space().maps[static_cast<std::size_t>(m)]));
    }
}
BENCHMARK(read_at_a_point)->ArgName("maps")->Arg(1)->Arg(2)->Unit(benchmark::kMicrosecond);

void settled_shift_of_half_space(benchmark::State& state) {
    double w = .1;
    for (auto _ : state) {
        w = w < .6 ? w + 1e-3 : .1;
        benchmark::DoNotOptimize(atlas::settled_shift_ratio(w, .1, std::numbers::pi / 4, .4));
    }
}
BENCHMARK(settled_shift_of_half_space)->Unit(benchmark::kMicrosecond);

void pressed_layer(benchmark::State& state) {
    double thickness = .25;
    for (auto _ : state) {
        thickness = thickness < 30 ? thickness * 1.01 : .25;
        benchmark::DoNotOptimize(atlas::pressed_layer_ratios(thickness, .4));
    }
}
BENCHMARK(pressed_layer)->Unit(benchmark::kMicrosecond);

void million_points(benchmark::State& state, const char* name) {
    const atlas::Atlas& atlas = atlas::shipped(name);
    const std::vector<double> points = drawn_points(atlas, 1'000'000);
    for (auto _ : state)
        benchmark::DoNotOptimize(atlas::read_all(atlas, atlas.maps.front(), points));
}
BENCHMARK_CAPTURE(million_points, half_space, "sphere_half_space")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(million_points, layer, "sphere_layer")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tricontact::speed
