#include <immintrin.h>

#include "walking/kernels/kernel_step.h"

namespace tricontact::walking::kernels {
namespace {

template <class Number>
struct Avx512;
template <>
struct Avx512<float> {
    using Number = float;
    using Register = __m512;
    static Register fmadd(Register a, Register b, Register c) { return _mm512_fmadd_ps(a, b, c); }
    static Register fmsub(Register a, Register b, Register c) { return _mm512_fmsub_ps(a, b, c); }
    static Register fnmadd(Register a, Register b, Register c) { return _mm512_fnmadd_ps(a, b, c); }
    static Register min(Register a, Register b) { return _mm512_min_ps(a, b); }
    static Register max(Register a, Register b) { return _mm512_max_ps(a, b); }
    static Register sqrt(Register a) { return _mm512_sqrt_ps(a); }
    static Register clamp(Register a, Register bound) { return _mm512_range_ps(a, bound, 0b0010); }
    static Register count_zero(Register count, Register a) {
        const auto zero = _mm512_cmp_ps_mask(a, _mm512_setzero_ps(), _CMP_EQ_OQ);
        return _mm512_mask_add_ps(count, zero, count, _mm512_set1_ps(1));
    }
};
template <>
struct Avx512<double> {
    using Number = double;
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

template <class Number>
LaneFunctions<Number> avx512_lanes() {
    return lane_functions<Pack<Avx512<Number>>>();
}
template LaneFunctions<float> avx512_lanes();
template LaneFunctions<double> avx512_lanes();

}  // namespace tricontact::walking::kernels
