#pragma once

#include <array>
#include <cstddef>

#include "contact/base/compensated_sum.h"
#include "contact/compliances/point_sums.h"

namespace tricontact::contact {

/// lane_sums() over all k < count, see for_each_block().
template <std::size_t n, class Add>
Sums<n> block_sums(std::size_t count, Add add) {
    std::array<CompensatedSum, n> all;
    for_each_block(0, static_cast<int>(count), [&](int begin, int end) {
        const Sums<n> sums = lane_sums<n>(begin, end, add);
        for (std::size_t j = 0; j < n; ++j) all[j].add(sums[j]);
    });
    Sums<n> total;
    for (std::size_t j = 0; j < n; ++j) total[j] = all[j].value();
    return total;
}

}  // namespace tricontact::contact
