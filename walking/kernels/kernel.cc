#include "walking/kernels/kernel_step.h"

#ifdef __x86_64__
#include <emmintrin.h>
#endif

namespace tricontact::walking {

std::vector<Kernel> available_kernels() {
    std::vector<Kernel> kernels{Kernel::plain};
#ifdef __x86_64__
    kernels.push_back(Kernel::sse2);  // every processor of this architecture
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        kernels.push_back(Kernel::avx2);
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
        kernels.push_back(Kernel::avx512);
#endif
    return kernels;
}

Kernel best_kernel() {
    return available_kernels().back();
}

namespace kernels {
namespace {

struct Plain {
    using Register = double;
    static double fmadd(double a, double b, double c) { return a * b + c; }
    static double fmsub(double a, double b, double c) { return a * b - c; }
    static double fnmadd(double a, double b, double c) { return c - a * b; }
    static double min(double a, double b) { return a < b ? a : b; }
    static double max(double a, double b) { return a > b ? a : b; }
    static double sqrt(double a) { return __builtin_sqrt(a); }
    static double count_zero(double count, double a) { return a == 0 ? count + 1 : count; }
};

#ifdef __x86_64__
struct Sse2 {
    using Register = __m128d;
    static Register fmadd(Register a, Register b, Register c) { return a * b + c; }
    static Register fmsub(Register a, Register b, Register c) { return a * b - c; }
    static Register fnmadd(Register a, Register b, Register c) { return c - a * b; }
    static Register min(Register a, Register b) { return _mm_min_pd(a, b); }
    static Register max(Register a, Register b) { return _mm_max_pd(a, b); }
    static Register sqrt(Register a) { return _mm_sqrt_pd(a); }
    static Register count_zero(Register count, Register a) {
        return count + _mm_and_pd(_mm_cmpeq_pd(a, _mm_setzero_pd()), _mm_set1_pd(1));
    }
};
#endif

}  // namespace

LaneFunctions functions_of(Kernel kernel) {
#ifdef __x86_64__
    if (kernel == Kernel::sse2) return lane_functions<Pack<Sse2>>();
    if (kernel == Kernel::avx2) return avx2_lanes();
    if (kernel == Kernel::avx512) return avx512_lanes();
#endif
    return lane_functions<Pack<Plain>>();
}

}  // namespace kernels

}  // namespace tricontact::walking
