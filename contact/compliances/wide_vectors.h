#pragma once

#include <array>
#include <cstddef>
#include <cstring>

#include "contact/compliances/dense_products.h"

// Loops in the widest vectors of the processor: compiled once for each kind, of which the one that
// fits is chosen when the program starts. Each number is the same sum in the same order whatever
// the width is, and nothing is contracted: the same bytes on all of them.

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define TRICONTACT_WIDEST_VECTORS \
    __attribute__((target_clones("arch=x86-64-v4", "avx2", "default")))
#else
#define TRICONTACT_WIDEST_VECTORS
#endif
#define TRICONTACT_WITHIN [[gnu::always_inline]] inline

namespace tricontact::contact {

/// Numbers side by side, as many as the widest registers hold.
template <class Real>
struct Vector {
    typedef Real Lanes __attribute__((vector_size(64)));
    Lanes lanes;

    TRICONTACT_WITHIN static Vector load(const Real* from) {
        Vector v;
        std::memcpy(&v, from, sizeof v);
        return v;
    }
    TRICONTACT_WITHIN void store(Real* to) const { std::memcpy(to, this, sizeof *this); }
};
template <class Real>
constexpr std::size_t lanes = 64 / sizeof(Real);

constexpr std::size_t group = columns_in_group;

/// sum += sign `group` columns * factor, in their order.
template <class Real, int sign>
TRICONTACT_WITHIN void add_group(const std::array<const Real*, group>& column,
                                 const std::array<Real, group>& factor, std::size_t n, Real* sum) {
    std::size_t i = 0;
    for (; i + lanes<Real> <= n; i += lanes<Real>) {
        auto s = Vector<Real>::load(sum + i);
        for (std::size_t k = 0; k < group; ++k) {
            const auto term = Vector<Real>::load(column[k] + i).lanes * factor[k];
            s.lanes = sign > 0 ? s.lanes + term : s.lanes - term;
        }
        s.store(sum + i);
    }
    for (; i < n; ++i)
        for (std::size_t k = 0; k < group; ++k) {
            const Real term = column[k][i] * factor[k];
            sum[i] = sign > 0 ? sum[i] + term : sum[i] - term;
        }
}

}  // namespace tricontact::contact
