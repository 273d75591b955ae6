#pragma once

#include <array>
#include <cstddef>

#include "contact/compensated_sum.h"

namespace tricontact::contact {

template <std::size_t n>
using Terms = std::array<double, n>;

/// The sum of what `add(sums, k)` adds for begin <= k < end: in four parts, which need not wait for
/// each other.
template <std::size_t n, class Add>
Terms<n> lane_sums(int begin, int end, Add add) {
    std::array<Terms<n>, 4> sums{};
    int k = begin;
    for (; k + 4 <= end; k += 4)
#pragma GCC unroll 4
        for (int lane = 0; lane < 4; ++lane) add(sums[lane], k + lane);
    for (; k < end; ++k) add(sums[0], k);
    Terms<n> total;
    for (std::size_t j = 0; j < n; ++j)
        total[j] = (sums[0][j] + sums[1][j]) + (sums[2][j] + sums[3][j]);
    return total;
}

/// The same over all k < count, see for_each_block().
template <std::size_t n, class Add>
Terms<n> block_sums(std::size_t count, Add add) {
    std::array<CompensatedSum, n> all;
    for_each_block(0, static_cast<int>(count), [&](int begin, int end) {
        const Terms<n> sums = lane_sums<n>(begin, end, add);
        for (std::size_t j = 0; j < n; ++j) all[j].add(sums[j]);
    });
    Terms<n> values;
    for (std::size_t j = 0; j < n; ++j) values[j] = all[j].value();
    return values;
}

}  // namespace tricontact::contact
