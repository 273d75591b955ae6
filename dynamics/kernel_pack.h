#pragma once

#include "dynamics/kernel_lanes.h"

namespace tricontact::dynamics::kernels {

/// As many numbers as a register of the processor holds. `Instructions` are those of a unit, in a
/// namespace without name (kernel_step.h): functions of registers.
template <class Instructions>
struct Pack {
    using Number = typename Instructions::Number;
    using Register = typename Instructions::Register;
    static constexpr int size = sizeof(Register) / sizeof(Number);
    static constexpr bool fused = requires(Register a) { Instructions::fmadd(a, a, a); };

    Register v;

    static Pack load(const Number* from) { return {*reinterpret_cast<const Register*>(from)}; }
    static Pack all(Number value) { return {value + Register{}}; }
    void store(Number* to) const { *reinterpret_cast<Register*>(to) = v; }

    Pack operator+(Pack b) const { return {v + b.v}; }
    Pack operator-(Pack b) const { return {v - b.v}; }
    Pack operator*(Pack b) const { return {v * b.v}; }
    Pack operator/(Pack b) const { return {v / b.v}; }
    friend Pack multiply_add(Pack a, Pack b, Pack c) {
        if constexpr (fused)
            return {Instructions::fmadd(a.v, b.v, c.v)};
        else
            return a * b + c;
    }
    friend Pack multiply_subtract(Pack a, Pack b, Pack c) {
        if constexpr (fused)
            return {Instructions::fmsub(a.v, b.v, c.v)};
        else
            return a * b - c;
    }
    friend Pack negative_multiply_add(Pack a, Pack b, Pack c) {
        if constexpr (fused)
            return {Instructions::fnmadd(a.v, b.v, c.v)};
        else
            return c - a * b;
    }
    friend Pack min(Pack a, Pack b) { return {Instructions::min(a.v, b.v)}; }
    friend Pack max(Pack a, Pack b) { return {Instructions::max(a.v, b.v)}; }
    friend Pack square_root(Pack a) { return {Instructions::sqrt(a.v)}; }
    /// Between -bound and bound: the smaller magnitude, with the sign of a.
    friend Pack clamp(Pack a, Pack bound) {
        if constexpr (requires { Instructions::clamp(a.v, bound.v); })
            return {Instructions::clamp(a.v, bound.v)};
        else
            return min(max(a, Pack{-bound.v}), bound);
    }
    friend Pack count_zero(Pack count, Pack a) { return {Instructions::count_zero(count.v, a.v)}; }
};

}  // namespace tricontact::dynamics::kernels
