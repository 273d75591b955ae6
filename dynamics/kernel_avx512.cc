#include <immintrin.h>

#include "dynamics/kernel_lanes.h"

namespace tricontact::dynamics::kernels {
namespace {

template <class Number>
struct Vector;
template <>
struct Vector<float> {
    using Register = __m512;
};
template <>
struct Vector<double> {
    using Register = __m512d;
};

template <class Value>
struct Pack {
    using Number = Value;
    using Register = typename Vector<Number>::Register;
    static constexpr int size = sizeof(Register) / sizeof(Number);

    Register v;

    static Pack load(const Number* from) { return {*reinterpret_cast<const Register*>(from)}; }
    static Pack all(Number value) { return {value + Register{}}; }
    void store(Number* to) const { *reinterpret_cast<Register*>(to) = v; }

    Pack operator+(Pack b) const { return {v + b.v}; }
    Pack operator-(Pack b) const { return {v - b.v}; }
    Pack operator*(Pack b) const { return {v * b.v}; }
    Pack operator/(Pack b) const { return {v / b.v}; }
};

using Floats = Pack<float>;
using Doubles = Pack<double>;

inline Doubles multiply_add(Doubles a, Doubles b, Doubles c) {
    return {_mm512_fmadd_pd(a.v, b.v, c.v)};
}
inline Floats multiply_add(Floats a, Floats b, Floats c) {
    return {_mm512_fmadd_ps(a.v, b.v, c.v)};
}
inline Doubles multiply_subtract(Doubles a, Doubles b, Doubles c) {
    return {_mm512_fmsub_pd(a.v, b.v, c.v)};
}
inline Floats multiply_subtract(Floats a, Floats b, Floats c) {
    return {_mm512_fmsub_ps(a.v, b.v, c.v)};
}
inline Doubles negative_multiply_add(Doubles a, Doubles b, Doubles c) {
    return {_mm512_fnmadd_pd(a.v, b.v, c.v)};
}
inline Floats negative_multiply_add(Floats a, Floats b, Floats c) {
    return {_mm512_fnmadd_ps(a.v, b.v, c.v)};
}
inline Doubles min(Doubles a, Doubles b) {
    return {_mm512_min_pd(a.v, b.v)};
}
inline Floats min(Floats a, Floats b) {
    return {_mm512_min_ps(a.v, b.v)};
}
inline Doubles max(Doubles a, Doubles b) {
    return {_mm512_max_pd(a.v, b.v)};
}
inline Floats max(Floats a, Floats b) {
    return {_mm512_max_ps(a.v, b.v)};
}
inline Doubles square_root(Doubles a) {
    return {_mm512_sqrt_pd(a.v)};
}
inline Floats square_root(Floats a) {
    return {_mm512_sqrt_ps(a.v)};
}

/// Between -bound and bound: the smaller magnitude, with the sign of a.
inline Doubles clamp(Doubles a, Doubles bound) {
    return {_mm512_range_pd(a.v, bound.v, 0b0010)};
}
inline Floats clamp(Floats a, Floats bound) {
    return {_mm512_range_ps(a.v, bound.v, 0b0010)};
}

inline Doubles count_zero(Doubles count, Doubles a) {
    const __mmask8 zero = _mm512_cmp_pd_mask(a.v, _mm512_setzero_pd(), _CMP_EQ_OQ);
    return {_mm512_mask_add_pd(count.v, zero, count.v, _mm512_set1_pd(1))};
}
inline Floats count_zero(Floats count, Floats a) {
    const __mmask16 zero = _mm512_cmp_ps_mask(a.v, _mm512_setzero_ps(), _CMP_EQ_OQ);
    return {_mm512_mask_add_ps(count.v, zero, count.v, _mm512_set1_ps(1))};
}

}  // namespace

template <class Number>
LaneFunctions<Number> avx512_lanes() {
    return lane_functions<Pack<Number>, 3>();
}
template LaneFunctions<float> avx512_lanes();
template LaneFunctions<double> avx512_lanes();

}  // namespace tricontact::dynamics::kernels
