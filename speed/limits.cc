// What the machine allows: memory bandwidth, and the transforms that a convolution consists of when
// they stay in the cache.

#include <benchmark/benchmark.h>

#include <vector>

#include "bem/grid_convolution.h"
#include "contact/base/fftw.h"

namespace tricontact::speed {
namespace {

/// a = b + s c (McCalpin 1995) on fields of n x n cells, those of one process on one core; 32 bytes
/// a cell: a is read before it is written.
void triad(benchmark::State& state) {
    const std::size_t n = state.range(0) * state.range(0);
    std::vector<double> a(n), b(n, 1.), c(n, 2.);
    for (auto _ : state) {
        for (std::size_t i = 0; i < n; ++i) a[i] = b[i] + 3 * c[i];
        benchmark::DoNotOptimize(a.data());
        benchmark::ClobberMemory();
    }
    state.counters["bytes_per_second"] = benchmark::Counter(
        32. * static_cast<double>(n), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(triad)->Arg(256)->Arg(1024)->Arg(4096)->Unit(benchmark::kMillisecond);

/// The transforms of one convolution on n x n cells, zero-padded or periodic: eight rows and eight
/// columns over and over again. What is left of a convolution is the way to the memory and back.
void transforms(benchmark::State& state) {
    constexpr int piece = 8;
    const int n = static_cast<int>(state.range(0)), padding = static_cast<int>(state.range(1));
    const int period_x = bem::good_fft_size(padding * n), waves = period_x / 2 + 1;
    const int period_y = bem::good_complex_fft_size(padding * n);
    using bem::FftwComplex, bem::FftwPlan;
    const auto rows =
        contact::fftw_zeros<bem::FftwReal>(static_cast<std::size_t>(piece) * period_x);
    const auto spectrum = contact::fftw_zeros<FftwComplex>(static_cast<std::size_t>(piece) * waves);
    const auto from = contact::fftw_zeros<FftwComplex>(static_cast<std::size_t>(piece) * period_y);
    const auto to = contact::fftw_zeros<FftwComplex>(static_cast<std::size_t>(piece) * period_y);
    const FftwPlan by_rows(fftw_plan_many_dft_r2c(1, &period_x, piece, rows.get(), nullptr, 1,
                                                  period_x, spectrum.get(), nullptr, 1, waves,
                                                  FFTW_ESTIMATE)),
        back_by_rows(fftw_plan_many_dft_c2r(1, &period_x, piece, spectrum.get(), nullptr, 1, waves,
                                            rows.get(), nullptr, 1, period_x, FFTW_ESTIMATE)),
        by_columns(fftw_plan_many_dft(1, &period_y, piece, from.get(), nullptr, 1, period_y,
                                      to.get(), nullptr, 1, period_y, FFTW_FORWARD, FFTW_ESTIMATE)),
        back_by_columns(fftw_plan_many_dft(1, &period_y, piece, to.get(), nullptr, 1, period_y,
                                           from.get(), nullptr, 1, period_y, FFTW_BACKWARD,
                                           FFTW_ESTIMATE));
    for (auto _ : state) {
        for (int i = 0; i < n; i += piece) {
            fftw_execute(by_rows.get());
            fftw_execute(back_by_rows.get());
        }
        for (int i = 0; i < waves; i += piece) {
            fftw_execute(by_columns.get());
            fftw_execute(back_by_columns.get());
        }
    }
}
BENCHMARK(transforms)
    ->ArgNames({"cells", "padding"})
    ->ArgsProduct({{512, 1024, 2048, 4096}, {1, 2}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tricontact::speed
