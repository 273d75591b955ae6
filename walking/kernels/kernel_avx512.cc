#include <immintrin.h>

#include "walking/kernels/kernel_step.h"

namespace tricontact::walking::kernels {
namespace {

struct Avx512 {
    using Register = __m512d;
    static Register fmadd(Register a, Register b, Register c) { return _mm512_fmadd_pd(a, b, c); }
    static Register fmsub(Register a, Register b, Register c) { return _mm512_fmsub_pd(a, b, c); }
    static Register fnmadd(Register a, Register b, Register c) { return _mm512_fnmadd_pd(a, b, c); }
    static Register min(Register a, Register b) { return _mm512_min_pd(a, b); }
    static Register max(Register a, Register b) { return _mm512_max_pd(a, b); }
    static Register sqrt(Register a) { return _mm512_sqrt_pd(a); }
    static Register clamp(Register a, Register bound) { return _mm512_range_pd(a, bound, 0b0010); }
    static Register count_zero(Register count, Register a) {
        const auto zero = _mm512_cmp_pd_mask(a, _mm512_setzero_pd(), _CMP_EQ_OQ);
        return _mm512_mask_add_pd(count, zero, count, _mm512_set1_pd(1));
    }
};

}  // namespace

LaneFunctions avx512_lanes() {
    return lane_functions<Pack<Avx512>>();
}

}  // namespace tricontact::walking::kernels
