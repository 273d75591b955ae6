#include <immintrin.h>

#include "dynamics/kernel_lanes.h"

namespace tricontact::dynamics::kernels {
namespace {

struct Pack {
    static constexpr int size = 4;
    __m256d v;

    static Pack load(const double* from) { return {_mm256_load_pd(from)}; }
    static Pack all(double value) { return {_mm256_set1_pd(value)}; }
    void store(double* to) const { _mm256_store_pd(to, v); }
};

inline Pack operator+(Pack a, Pack b) {
    return {_mm256_add_pd(a.v, b.v)};
}
inline Pack operator-(Pack a, Pack b) {
    return {_mm256_sub_pd(a.v, b.v)};
}
inline Pack operator*(Pack a, Pack b) {
    return {_mm256_mul_pd(a.v, b.v)};
}
inline Pack operator/(Pack a, Pack b) {
    return {_mm256_div_pd(a.v, b.v)};
}
inline Pack multiply_add(Pack a, Pack b, Pack c) {
    return {_mm256_fmadd_pd(a.v, b.v, c.v)};
}
inline Pack multiply_subtract(Pack a, Pack b, Pack c) {
    return {_mm256_fmsub_pd(a.v, b.v, c.v)};
}
inline Pack negative_multiply_add(Pack a, Pack b, Pack c) {
    return {_mm256_fnmadd_pd(a.v, b.v, c.v)};
}
inline Pack min(Pack a, Pack b) {
    return {_mm256_min_pd(a.v, b.v)};
}
inline Pack max(Pack a, Pack b) {
    return {_mm256_max_pd(a.v, b.v)};
}
inline Pack square_root(Pack a) {
    return {_mm256_sqrt_pd(a.v)};
}
inline Pack clamp(Pack a, Pack bound) {
    const Pack negative{_mm256_xor_pd(bound.v, _mm256_set1_pd(-0.0))};
    return min(max(a, negative), bound);
}
inline Pack count_zero(Pack count, Pack a) {
    const __m256d zero = _mm256_cmp_pd(a.v, _mm256_setzero_pd(), _CMP_EQ_OQ);
    return count + Pack{_mm256_and_pd(zero, _mm256_set1_pd(1))};
}

}  // namespace

LaneFunctions avx2_lanes() {
    return lane_functions<Pack, 3>();
}

}  // namespace tricontact::dynamics::kernels
