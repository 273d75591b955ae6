#include <immintrin.h>

#include "walking/kernels/kernel_step.h"

namespace tricontact::walking::kernels {
namespace {

struct Avx2 {
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

LaneFunctions avx2_lanes() {
    return lane_functions<Pack<Avx2>>();
}

}  // namespace tricontact::walking::kernels
