#include "dynamics/kernel_lanes.h"

namespace tricontact::dynamics::kernels {
namespace {

template <class Value>
struct Pack {
    using Number = Value;
    static constexpr int size = 1;

    Number v;

    static Pack load(const Number* from) { return {*from}; }
    static Pack all(Number value) { return {value}; }
    void store(Number* to) const { *to = v; }

    Pack operator+(Pack b) const { return {v + b.v}; }
    Pack operator-(Pack b) const { return {v - b.v}; }
    Pack operator*(Pack b) const { return {v * b.v}; }
    Pack operator/(Pack b) const { return {v / b.v}; }
    friend Pack multiply_add(Pack a, Pack b, Pack c) { return a * b + c; }
    friend Pack multiply_subtract(Pack a, Pack b, Pack c) { return a * b - c; }
    friend Pack negative_multiply_add(Pack a, Pack b, Pack c) { return c - a * b; }
    friend Pack min(Pack a, Pack b) { return {a.v < b.v ? a.v : b.v}; }
    friend Pack max(Pack a, Pack b) { return {a.v > b.v ? a.v : b.v}; }
    friend Pack clamp(Pack a, Pack bound) { return min(max(a, Pack{-bound.v}), bound); }
    friend Pack square_root(Pack a) { return {static_cast<Number>(__builtin_sqrt(a.v))}; }
    friend Pack count_zero(Pack count, Pack a) { return {a.v == 0 ? count.v + 1 : count.v}; }
};

}  // namespace

template <class Number>
LaneFunctions<Number> plain_lanes() {
    return lane_functions<Pack<Number>, 3>();
}
template LaneFunctions<float> plain_lanes();
template LaneFunctions<double> plain_lanes();

}  // namespace tricontact::dynamics::kernels
