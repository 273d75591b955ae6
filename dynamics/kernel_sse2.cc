#include <emmintrin.h>

#include "dynamics/kernel_lanes.h"

namespace tricontact::dynamics::kernels {
namespace {

template <class Number>
struct Vector;
template <>
struct Vector<float> {
    using Register = __m128;
};
template <>
struct Vector<double> {
    using Register = __m128d;
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
    friend Pack multiply_add(Pack a, Pack b, Pack c) { return a * b + c; }
    friend Pack multiply_subtract(Pack a, Pack b, Pack c) { return a * b - c; }
    friend Pack negative_multiply_add(Pack a, Pack b, Pack c) { return c - a * b; }
};

using Floats = Pack<float>;
using Doubles = Pack<double>;

inline Doubles min(Doubles a, Doubles b) {
    return {_mm_min_pd(a.v, b.v)};
}
inline Floats min(Floats a, Floats b) {
    return {_mm_min_ps(a.v, b.v)};
}
inline Doubles max(Doubles a, Doubles b) {
    return {_mm_max_pd(a.v, b.v)};
}
inline Floats max(Floats a, Floats b) {
    return {_mm_max_ps(a.v, b.v)};
}
inline Doubles square_root(Doubles a) {
    return {_mm_sqrt_pd(a.v)};
}
inline Floats square_root(Floats a) {
    return {_mm_sqrt_ps(a.v)};
}

inline Doubles clamp(Doubles a, Doubles bound) {
    return min(max(a, Doubles{-bound.v}), bound);
}
inline Floats clamp(Floats a, Floats bound) {
    return min(max(a, Floats{-bound.v}), bound);
}

inline Doubles count_zero(Doubles count, Doubles a) {
    const __m128d zero = _mm_cmpeq_pd(a.v, _mm_setzero_pd());
    return count + Doubles{_mm_and_pd(zero, _mm_set1_pd(1))};
}
inline Floats count_zero(Floats count, Floats a) {
    const __m128 zero = _mm_cmpeq_ps(a.v, _mm_setzero_ps());
    return count + Floats{_mm_and_ps(zero, _mm_set1_ps(1))};
}

}  // namespace

template <class Number>
LaneFunctions<Number> sse2_lanes() {
    return lane_functions<Pack<Number>, 3>();
}
template LaneFunctions<float> sse2_lanes();
template LaneFunctions<double> sse2_lanes();

}  // namespace tricontact::dynamics::kernels
