#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "contact/base/special_values.h"
#include "contact/base/vector2.h"

namespace tricontact::contact {

// What loops over the points of a contact add up, see Blocks::sum.

template <std::size_t n>
struct Sums {
    std::array<double, n> values{};
    double& operator[](std::size_t k) { return values[k]; }
    double operator[](std::size_t k) const { return values[k]; }
    Sums& operator+=(const Sums& other) {
        for (std::size_t k = 0; k < n; ++k) values[k] += other.values[k];
        return *this;
    }
};

/// The sum of what `add(sums, k)` adds for begin <= k < end: in four parts, which need not wait for
/// each other.
template <std::size_t n, class Index, class Add>
Sums<n> lane_sums(Index begin, Index end, Add add) {
    std::array<Sums<n>, 4> lanes{};
    Index k = begin;
    for (; k + 4 <= end; k += 4)
#pragma GCC unroll 4
        for (Index lane = 0; lane < 4; ++lane) add(lanes[lane], k + lane);
    for (; k < end; ++k) add(lanes[0], k);
    lanes[0] += lanes[1];
    lanes[2] += lanes[3];
    lanes[0] += lanes[2];
    return lanes[0];
}

/// NaN if any is one.
struct Largest {
    double value = 0;
    void add(double other) { value = larger(value, other); }
    Largest& operator+=(const Largest& other) {
        add(other.value);
        return *this;
    }
};

/// Of the gaps on a set [m].
struct GapSum {
    double square = 0, worst = 0;
    void add(double gap) {
        square += gap * gap;
        worst = std::max(worst, std::abs(gap));
    }
    GapSum& operator+=(const GapSum& other) {
        square += other.square;
        worst = larger(worst, other.worst);
        return *this;
    }
};

/// Of pressures and gaps everywhere.
struct ContactSum {
    double worst = 0, work = 0, force = 0, gaps = 0;  // gaps: of the next set
    std::size_t n_entered = 0;
    ContactSum& operator+=(const ContactSum& other) {
        worst = larger(worst, other.worst);
        work += other.work;
        force += other.force;
        gaps += other.gaps;
        n_entered += other.n_entered;
        return *this;
    }
};

/// Of friction: the residual, the force and whether all points that slip are on their bound.
struct Misfit {
    double worst = 0;
    Vector2 force{};
    bool on_bound = true;
    Misfit& operator+=(const Misfit& other) {
        worst = larger(worst, other.worst);
        force = force + other.force;
        on_bound = on_bound && other.on_bound;
        return *this;
    }
};

}  // namespace tricontact::contact
