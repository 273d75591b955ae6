// What a map costs: its evaluation at one point, alone and beside nine others, at many points, and
// its fit.

#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "statistics/latin_hypercube.h"
#include "statistics/polynomial_fit.h"
#include "statistics/sample_sequence.h"

namespace tricontact::speed {
namespace {

using statistics::SparsePolynomial;

constexpr int n_variables = 4;

/// 400 terms, those of least product of (degree + 1): what a fit typically has.
SparsePolynomial hyperbolic_cross() {
    SparsePolynomial p{.n_variables = n_variables};
    for (std::uint8_t a = 0; a < 24; ++a)
        for (std::uint8_t b = 0; b < 24; ++b)
            for (std::uint8_t c = 0; c < 24; ++c)
                for (std::uint8_t d = 0; d < 24; ++d) {
                    if ((a + 1) * (b + 1) * (c + 1) * (d + 1) > 28 || p.n_terms() >= 400) continue;
                    p.degrees.insert(p.degrees.end(), {a, b, c, d});
                    p.coefficients.push_back(1. / (1 + a + b + c + d));
                }
    return p;
}

/// Ten polynomials share the table of a point: `polynomials` of them.
void evaluation(benchmark::State& state) {
    const std::vector<SparsePolynomial> maps(static_cast<std::size_t>(state.range(0)),
                                             hyperbolic_cross());
    const auto points = statistics::sample_points(1024, n_variables);
    statistics::ChebyshevTable table(n_variables);
    for (const SparsePolynomial& map : maps) table.cover(map);
    std::size_t i = 0;
    for (auto _ : state) {
        table.set_point(std::span(points).subspan(i++ % 1024 * n_variables, n_variables));
        for (const SparsePolynomial& map : maps) benchmark::DoNotOptimize(table.evaluate(map));
    }
    state.counters["terms"] = static_cast<double>(maps.front().n_terms());
}
BENCHMARK(evaluation)->ArgName("polynomials")->Arg(1)->Arg(10)->Unit(benchmark::kMicrosecond);

void million_points(benchmark::State& state) {
    const SparsePolynomial map = hyperbolic_cross();
    const auto points = statistics::sample_points(1'000'000, n_variables);
    for (auto _ : state) benchmark::DoNotOptimize(statistics::evaluate_all(map, points));
}
BENCHMARK(million_points)->Unit(benchmark::kMillisecond);

/// A root of the load with noise of 1e-4, `points` of four variables.
void fit(benchmark::State& state) {
    const auto n = static_cast<std::uint32_t>(state.range(0));
    const auto points = statistics::sample_points(n, n_variables);
    statistics::SplitMix64 random(1);
    std::vector<double> values;
    for (std::size_t i = 0; i < points.size(); i += n_variables) {
        const double load = 0.45 * (1 + points[i]) / (1 + 0.1 * points[i + 1]);
        values.push_back((1 - std::pow(1 - load, 2. / 3)) /
                             (2 + points[i + 2] / 2 + points[i + 3] / 5) +
                         2e-4 * (random.uniform() - 0.5));
    }
    double n_terms = 0;
    for (auto _ : state)
        n_terms = static_cast<double>(
            statistics::fit_polynomial(points, values, n_variables).polynomial.n_terms());
    state.counters["terms"] = n_terms;
}
BENCHMARK(fit)->ArgName("points")->Arg(500)->Arg(2000)->Arg(5000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tricontact::speed
