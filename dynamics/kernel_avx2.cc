#include <immintrin.h>

#include "dynamics/kernel_lanes.h"

namespace tricontact::dynamics::kernels {
namespace {

template <class Number>
struct Vector;
template <>
struct Vector<float> {
    using Register = __m256;
};
template <>
struct Vector<double> {
    using Register = __m256d;
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
    return {_mm256_fmadd_pd(a.v, b.v, c.v)};
}
inline Floats multiply_add(Floats a, Floats b, Floats c) {
    return {_mm256_fmadd_ps(a.v, b.v, c.v)};
}
inline Doubles multiply_subtract(Doubles a, Doubles b, Doubles c) {
    return {_mm256_fmsub_pd(a.v, b.v, c.v)};
}
inline Floats multiply_subtract(Floats a, Floats b, Floats c) {
    return {_mm256_fmsub_ps(a.v, b.v, c.v)};
}
inline Doubles negative_multiply_add(Doubles a, Doubles b, Doubles c) {
    return {_mm256_fnmadd_pd(a.v, b.v, c.v)};
}
inline Floats negative_multiply_add(Floats a, Floats b, Floats c) {
    return {_mm256_fnmadd_ps(a.v, b.v, c.v)};
}
inline Doubles min(Doubles a, Doubles b) {
    return {_mm256_min_pd(a.v, b.v)};
}
inline Floats min(Floats a, Floats b) {
    return {_mm256_min_ps(a.v, b.v)};
}
inline Doubles max(Doubles a, Doubles b) {
    return {_mm256_max_pd(a.v, b.v)};
}
inline Floats max(Floats a, Floats b) {
    return {_mm256_max_ps(a.v, b.v)};
}
inline Doubles square_root(Doubles a) {
    return {_mm256_sqrt_pd(a.v)};
}
inline Floats square_root(Floats a) {
    return {_mm256_sqrt_ps(a.v)};
}

inline Doubles clamp(Doubles a, Doubles bound) {
    return min(max(a, Doubles{-bound.v}), bound);
}
inline Floats clamp(Floats a, Floats bound) {
    return min(max(a, Floats{-bound.v}), bound);
}

inline Doubles count_zero(Doubles count, Doubles a) {
    const __m256d zero = _mm256_cmp_pd(a.v, _mm256_setzero_pd(), _CMP_EQ_OQ);
    return count + Doubles{_mm256_and_pd(zero, _mm256_set1_pd(1))};
}
inline Floats count_zero(Floats count, Floats a) {
    const __m256 zero = _mm256_cmp_ps(a.v, _mm256_setzero_ps(), _CMP_EQ_OQ);
    return count + Floats{_mm256_and_ps(zero, _mm256_set1_ps(1))};
}

}  // namespace

template <class Number>
LaneFunctions<Number> avx2_lanes() {
    return lane_functions<Pack<Number>, 3>();
}
template LaneFunctions<float> avx2_lanes();
template LaneFunctions<double> avx2_lanes();

}  // namespace tricontact::dynamics::kernels
