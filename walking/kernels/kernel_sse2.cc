#include <emmintrin.h>

#include "walking/kernels/kernel_step.h"

namespace tricontact::walking::kernels {
namespace {

template <class Number>
struct Sse2;
template <>
struct Sse2<float> {
    using Number = float;
    using Register = __m128;
    static Register min(Register a, Register b) { return _mm_min_ps(a, b); }
    static Register max(Register a, Register b) { return _mm_max_ps(a, b); }
    static Register sqrt(Register a) { return _mm_sqrt_ps(a); }
    static Register count_zero(Register count, Register a) {
        return count + _mm_and_ps(_mm_cmpeq_ps(a, _mm_setzero_ps()), _mm_set1_ps(1));
    }
};
template <>
struct Sse2<double> {
    using Number = double;
    using Register = __m128d;
    static Register min(Register a, Register b) { return _mm_min_pd(a, b); }
    static Register max(Register a, Register b) { return _mm_max_pd(a, b); }
    static Register sqrt(Register a) { return _mm_sqrt_pd(a); }
    static Register count_zero(Register count, Register a) {
        return count + _mm_and_pd(_mm_cmpeq_pd(a, _mm_setzero_pd()), _mm_set1_pd(1));
    }
};

}  // namespace

template <class Number>
LaneFunctions<Number> sse2_lanes() {
    return lane_functions<Pack<Sse2<Number>>>();
}
template LaneFunctions<float> sse2_lanes();
template LaneFunctions<double> sse2_lanes();

}  // namespace tricontact::walking::kernels
