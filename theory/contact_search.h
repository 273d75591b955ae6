#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "contact/base/error.h"
#include "contact/base/root.h"

// What the exact solutions of contact share; for their implementations.
namespace tricontact::theory {

/// Points per contact radius a that resolve it to rounding. The kernel is analytic up to 2b off
/// the real axis: n points leave exp(-2 n asinh(4b/a)) (Bernstein's ellipse), full precision from
/// n = 18.5/asinh(4b/a) on; the rest is margin.
inline int points_for(double radius_over_thickness) {
    return static_cast<int>(std::ceil(12 + 24 / std::asinh(4 / radius_over_thickness)));
}

/// The result of solve(n), n points being added until their key_values stand still to 1e-10.
template <typename Solve, typename Values>
auto converged(Solve solve, int fewest, Values key_values, std::string_view remedy) {
    auto coarse = solve(fewest);
    double change = 0;
    for (int n = fewest + fewest / 2; n <= 4 * fewest; n += n / 2) {
        auto fine = solve(n);
        const auto now = key_values(fine), before = key_values(coarse);
        change = 0;
        for (std::size_t i = 0; i < now.size(); ++i)
            change = std::max(change, std::abs(now[i] / before[i] - 1));
        if (change <= 1e-10) return fine;
        coarse = std::move(fine);
    }
    throw contact::NotConverged(fmt::format(
        "layer contact: with {} points in the contact radius the result still changes by {:.3g}; "
        "{}",
        4 * fewest, change, remedy));
}

/// Contact radius at which `excess`, increasing in it, vanishes; infinite beyond `largest`.
template <typename Function>
double find_radius(Function excess, double start, double largest, double thickness) {
    double low = std::min(start, largest / 2), high = low;
    if (excess(low) < 0) {
        do {
            if (high >= largest) return std::numeric_limits<double>::infinity();
            low = high;
            high = std::min(2 * high, largest);
        } while (excess(high) < 0);
    } else {
        do {
            high = low;
            low /= 4;
            if (low < 1e-12 * thickness)
                throw contact::NotConverged(
                    "layer contact: no contact radius found above 1e-12 of the thickness; use the "
                    "half-space");
        } while (excess(low) >= 0);
    }
    return contact::bracketed_root(excess, low, high, 50);
}

}  // namespace tricontact::theory
