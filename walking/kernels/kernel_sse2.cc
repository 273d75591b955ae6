#include <emmintrin.h>

#include "walking/kernels/kernel_step.h"

namespace tricontact::walking::kernels {
namespace {

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

}  // namespace

LaneFunctions sse2_lanes() {
    return lane_functions<Pack<Sse2>>();
}

}  // namespace tricontact::walking::kernels
