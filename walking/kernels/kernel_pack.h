#pragma once

#include <utility>

#include "walking/kernels/kernel_sums.h"

namespace tricontact::walking::kernels {

template <class Pack, int n_packs>
PackFields<Pack> fields_of_pack(typename Pack::Number* fields, int pack) {
    return {fields + pack * Pack::size, n_packs * Pack::size};
}

/// Several packs of lanes step by step side by side: one waits for its results while others
/// compute.
template <class Contact, class Sums, class Pack, int... i>
void advance_packs(typename Pack::Number* fields, std::int64_t n_steps,
                   std::integer_sequence<int, i...>) {
    constexpr int n = sizeof...(i);
    PackState<Pack> states[n];
    PackStep<Pack> last[n];
    Sums sums[n];
    const auto of = [&](int pack) { return fields_of_pack<Pack, n>(fields, pack); };
    (states[i].load(of(i)), ...);
    (sums[i].start(states[i], of(i)), ...);
    for (std::int64_t step = 1; step < n_steps; ++step)
        (sums[i].add(states[i], advance<Contact>(states[i], of(i))), ...);
    ((last[i] = advance<Contact>(states[i], of(i))), ...);
    (sums[i].add(states[i], last[i]), ...);
    (states[i].store(of(i)), ...);
    (of(i).set(slip_1, last[i].left.slip), ...);
    (of(i).set(slip_2, last[i].right.slip), ...);
    (sums[i].store(of(i)), ...);
}

template <class Contact, class Sums, class Pack, int n_packs>
__attribute__((flatten)) void advance_lanes(typename Pack::Number* fields, std::int64_t n_steps) {
    advance_packs<Contact, Sums, Pack>(fields, n_steps, std::make_integer_sequence<int, n_packs>());
}

template <class Pack, int n_packs>
LaneFunctions<typename Pack::Number> lane_functions() {
    using Flat = FlatContact<Pack>;
    using Prism = PrismContact<Pack>;
    return {n_packs * Pack::size, advance_lanes<Flat, MotionSums<Pack>, Pack, n_packs>,
            advance_lanes<Flat, AllSums<Pack>, Pack, n_packs>,
            advance_lanes<Prism, MotionSums<Pack>, Pack, n_packs>,
            advance_lanes<Prism, AllSums<Pack>, Pack, n_packs>};
}

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

}  // namespace tricontact::walking::kernels
