#include <immintrin.h>

#include "walking/kernels/kernel_step.h"

namespace tricontact::walking::kernels {
namespace {

template <class Number>
struct Avx2;
template <>
struct Avx2<float> {
    using Number = float;
    using Register = __m256;
    static Register fmadd(Register a, Register b, Register c) { return _mm256_fmadd_ps(a, b, c); }
    static Register fmsub(Register a, Register b, Register c) { return _mm256_fmsub_ps(a, b, c); }
    static Register fnmadd(Register a, Register b, Register c) { return _mm256_fnmadd_ps(a, b, c); }
    static Register min(Register a, Register b) { return _mm256_min_ps(a, b); }
    static Register max(Register a, Register b) { return _mm256_max_ps(a, b); }
    static Register sqrt(Register a) { return _mm256_sqrt_ps(a); }
    static Register count_zero(Register count, Register a) {
        const Register zero = _mm256_cmp_ps(a, _mm256_setzero_ps(), _CMP_EQ_OQ);
        return count + _mm256_and_ps(zero, _mm256_set1_ps(1));
    }
};
template <>
struct Avx2<double> {
    using Number = double;
    using Register = __m256d;
    static Register fmadd(Register a, Register b, Register c) { return _mm256_fmadd_pd(a, b, c); }
    static Register fmsub(Register a, Register b, Register c) { return _mm256_fmsub_pd(a, b, c); }
    static Register fnmadd(Register a, Register b, Register c) { return _mm256_fnmadd_pd(a, b, c); }
    static Register min(Register a, Register b) { return _mm256_min_pd(a, b); }
    static Register max(Register a, Register b) { return _mm256_max_pd(a, b); }
    static Register sqrt(Register a) { return _mm256_sqrt_pd(a); }
    static Register count_zero(Register count, Register a) {
        const Register zero = _mm256_cmp_pd(a, _mm256_setzero_pd(), _CMP_EQ_OQ);
        return count + _mm256_and_pd(zero, _mm256_set1_pd(1));
    }
};

}  // namespace

template <class Number>
LaneFunctions<Number> avx2_lanes() {
    return lane_functions<Pack<Avx2<Number>>>();
}
template LaneFunctions<float> avx2_lanes();
template LaneFunctions<double> avx2_lanes();

}  // namespace tricontact::walking::kernels
