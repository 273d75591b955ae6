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

/// Contact radius at which `share`, of the load that is sought and increasing with the radius, is
/// one; infinite beyond `largest`. Logarithms of both are nearly on a straight line (forces of a
/// half-space go as a^3, indentations as a^2, of a cone as a^2 and a), which the search follows.
template <typename Function>
double find_radius(Function share, double start, double largest, double thickness) {
    const auto excess = [&](double x) {
        const double s = share(std::exp(x) * thickness);
        return s > 0 ? std::log(s) : std::log(std::numeric_limits<double>::min());
    };
    const double end = std::log(largest / thickness), nearest = std::log(1e-12);
    double low = std::min(std::log(start / thickness), end - std::log(2.)), high = low,
           at_low = excess(low), at_high = at_low;
    // Somewhat beyond where a^2 has it, so that the root is passed in one step.
    const auto step = [](double at) { return std::max(std::log(2.), .55 * std::abs(at)); };
    if (at_low < 0) {
        do {
            if (high >= end) return std::numeric_limits<double>::infinity();
            low = high;
            at_low = at_high;
            high = std::min(low + std::min(step(at_low), std::log(8.)), end);
            at_high = excess(high);
        } while (at_high < 0);
    } else {
        do {
            high = low;
            at_high = at_low;
            low -= step(at_high);
            if (low < nearest && high <= nearest)
                throw contact::NotConverged(
                    "layer contact: no contact radius found above 1e-12 of the thickness; use the "
                    "half-space");
            low = std::max(low, nearest);
            at_low = excess(low);
        } while (at_low >= 0);
    }
    // Over the bracket's width: to 2^-50 of a factor of the radius, wherever zero is.
    const double width = high - low;
    const double part = contact::bracketed_root(
        [&](double t) { return excess(low + (t - 1) * width); }, 1., 2., at_low, at_high, 50);
    return thickness * std::exp(low + (part - 1) * width);
}

}  // namespace tricontact::theory
