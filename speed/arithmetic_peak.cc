#include "speed/arithmetic_peak.h"

#include <benchmark/benchmark.h>
#include <immintrin.h>

#include <algorithm>

#include "speed/cpu_timer.h"

namespace tricontact::speed {
namespace {

using walking::Kernel;

// More than latency (4 cycles) times instructions a cycle (2), fewer than there are registers.
constexpr int n_chains = 12;
constexpr int n_rounds = 100'000;

__attribute__((target("avx512f"))) void avx512_chains() {
    __m512d x[n_chains] = {};
    const __m512d a = _mm512_set1_pd(0.5);
    benchmark::DoNotOptimize(x);  // else they are one and the same
    for (int round = 0; round < n_rounds; ++round) {
#pragma GCC unroll 12
        for (int i = 0; i < n_chains; ++i) x[i] = _mm512_fmadd_pd(x[i], a, a);
    }
    benchmark::DoNotOptimize(x);
}

__attribute__((target("avx2,fma"))) void avx2_chains() {
    __m256d x[n_chains] = {};
    const __m256d a = _mm256_set1_pd(0.5);
    benchmark::DoNotOptimize(x);
    for (int round = 0; round < n_rounds; ++round) {
#pragma GCC unroll 12
        for (int i = 0; i < n_chains; ++i) x[i] = _mm256_fmadd_pd(x[i], a, a);
    }
    benchmark::DoNotOptimize(x);
}

void sse2_chains() {
    __m128d x[n_chains] = {};
    const __m128d a = _mm_set1_pd(0.5);
    benchmark::DoNotOptimize(x);
    for (int round = 0; round < n_rounds; round += 2) {
#pragma GCC unroll 12
        for (int i = 0; i < n_chains; ++i) x[i] = _mm_add_pd(_mm_mul_pd(x[i], a), a);
    }
    benchmark::DoNotOptimize(x);
}

void run_chains(Kernel kernel) {
    switch (kernel) {
        case Kernel::plain:
        case Kernel::sse2:
            return sse2_chains();
        case Kernel::avx2:
            return avx2_chains();
        case Kernel::avx512:
            return avx512_chains();
    }
}

}  // namespace

double arithmetic_peak(Kernel kernel) {
    double best = 0;
    for (int attempt = 0; attempt < 5; ++attempt) {
        const CpuTimer timer;
        run_chains(kernel);
        best = std::max(best, n_chains * static_cast<double>(n_rounds) / timer.seconds());
    }
    return best;
}

}  // namespace tricontact::speed
