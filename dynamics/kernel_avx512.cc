#include <immintrin.h>

#include "dynamics/kernel_lanes.h"

namespace tricontact::dynamics::kernels {
namespace {

struct Pack {
    static constexpr int size = 8;
    __m512d v;

    static Pack load(const double* from) { return {_mm512_load_pd(from)}; }
    static Pack all(double value) { return {_mm512_set1_pd(value)}; }
    void store(double* to) const { _mm512_store_pd(to, v); }
};

inline Pack operator+(Pack a, Pack b) {
    return {_mm512_add_pd(a.v, b.v)};
}
inline Pack operator-(Pack a, Pack b) {
    return {_mm512_sub_pd(a.v, b.v)};
}
inline Pack operator*(Pack a, Pack b) {
    return {_mm512_mul_pd(a.v, b.v)};
}
inline Pack operator/(Pack a, Pack b) {
    return {_mm512_div_pd(a.v, b.v)};
}
inline Pack multiply_add(Pack a, Pack b, Pack c) {
    return {_mm512_fmadd_pd(a.v, b.v, c.v)};
}
inline Pack multiply_subtract(Pack a, Pack b, Pack c) {
    return {_mm512_fmsub_pd(a.v, b.v, c.v)};
}
inline Pack negative_multiply_add(Pack a, Pack b, Pack c) {
    return {_mm512_fnmadd_pd(a.v, b.v, c.v)};
}
inline Pack min(Pack a, Pack b) {
    return {_mm512_min_pd(a.v, b.v)};
}
inline Pack max(Pack a, Pack b) {
    return {_mm512_max_pd(a.v, b.v)};
}
inline Pack square_root(Pack a) {
    return {_mm512_sqrt_pd(a.v)};
}
/// Between -bound and bound: the smaller magnitude, with the sign of a.
inline Pack clamp(Pack a, Pack bound) {
    return {_mm512_range_pd(a.v, bound.v, 0b0010)};
}
inline Pack count_zero(Pack count, Pack a) {
    const __mmask8 zero = _mm512_cmp_pd_mask(a.v, _mm512_setzero_pd(), _CMP_EQ_OQ);
    return {_mm512_mask_add_pd(count.v, zero, count.v, _mm512_set1_pd(1))};
}

}  // namespace

LaneFunctions avx512_lanes() {
    return lane_functions<Pack, 3>();
}

}  // namespace tricontact::dynamics::kernels
