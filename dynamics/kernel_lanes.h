#pragma once

#include <utility>

#include "dynamics/kernel_sums.h"

namespace tricontact::dynamics::kernels {

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

}  // namespace tricontact::dynamics::kernels
