#include <emmintrin.h>

#include "dynamics/kernel_lanes.h"

namespace tricontact::dynamics::kernels {
namespace {

struct Pack {
    static constexpr int size = 2;
    __m128d v;

    static Pack load(const double* from) { return {_mm_load_pd(from)}; }
    static Pack all(double value) { return {_mm_set1_pd(value)}; }
    void store(double* to) const { _mm_store_pd(to, v); }
};

inline Pack operator+(Pack a, Pack b) {
    return {_mm_add_pd(a.v, b.v)};
}
inline Pack operator-(Pack a, Pack b) {
    return {_mm_sub_pd(a.v, b.v)};
}
inline Pack operator*(Pack a, Pack b) {
    return {_mm_mul_pd(a.v, b.v)};
}
inline Pack operator/(Pack a, Pack b) {
    return {_mm_div_pd(a.v, b.v)};
}
inline Pack multiply_add(Pack a, Pack b, Pack c) {
    return a * b + c;
}
inline Pack multiply_subtract(Pack a, Pack b, Pack c) {
    return a * b - c;
}
inline Pack negative_multiply_add(Pack a, Pack b, Pack c) {
    return c - a * b;
}
inline Pack min(Pack a, Pack b) {
    return {_mm_min_pd(a.v, b.v)};
}
inline Pack max(Pack a, Pack b) {
    return {_mm_max_pd(a.v, b.v)};
}
inline Pack square_root(Pack a) {
    return {_mm_sqrt_pd(a.v)};
}
inline Pack clamp(Pack a, Pack bound) {
    const Pack negative{_mm_xor_pd(bound.v, _mm_set1_pd(-0.0))};
    return min(max(a, negative), bound);
}
inline Pack count_zero(Pack count, Pack a) {
    return count + Pack{_mm_and_pd(_mm_cmpeq_pd(a.v, _mm_setzero_pd()), _mm_set1_pd(1))};
}

}  // namespace

LaneFunctions sse2_lanes() {
    return lane_functions<Pack, 3>();
}

}  // namespace tricontact::dynamics::kernels
