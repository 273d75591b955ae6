#include "mdr/tangential_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "contact/base/compensated_sum.h"
#include "contact/base/error.h"
#include "contact/base/special_values.h"

namespace tricontact::mdr {

namespace {

using contact::CompensatedSum;
using contact::for_each_block;

/// Shares of the increment that carry the springs: all of it.
struct Whole {
    constexpr double operator[](int) const { return 1; }
};

struct ClampedSum {
    double sum = 0;     // of the deflections
    double n_free = 0;  // springs within their bounds, by their shares: derivative of the sum
    double bounds = 0;  // sum of the bounds
};

template <class Shares>
ClampedSum clamped_sum(std::span<const double> deflections, std::span<const double> bounds,
                       const Shares carried, double increment) {
    const double* const u = deflections.data();
    const double* const bound = bounds.data();
    CompensatedSum all, all_bounds;
    double all_free = 0;
    for_each_block(0, static_cast<int>(bounds.size()), [&](int begin, int end) {
        double sum = 0, n_free = 0, total = 0;
#pragma omp simd reduction(+ : sum, n_free, total)
        for (int i = begin; i < end; ++i) {
            const double trial = u[i] + carried[i] * increment;
            const double clamped = std::min(std::max(trial, -bound[i]), bound[i]);
            sum += clamped;
            n_free += clamped == trial ? carried[i] : 0.;
            total += bound[i];
        }
        all.add(sum);
        all_bounds.add(total);
        all_free += n_free;
    });
    return {all.value(), all_free, all_bounds.value()};
}

template <class Shares>
ShiftSolution search(std::span<const double> deflections, std::span<const double> bounds,
                     const Shares carried, double target, double farthest) {
    double low = -farthest, high = farthest;
    double previous_residual = contact::infinity;
    ShiftSolution solution;
    for (solution.iterations = 1; solution.iterations <= 200; ++solution.iterations) {
        const ClampedSum at = clamped_sum(deflections, bounds, carried, solution.increment);
        const double missing = target - at.sum;
        solution.residual = std::abs(missing) / at.bounds;
        // Newton's last step lands on the exact piece: what is left is the rounding of the sum.
        if (solution.residual <= 1e-13) return solution;
        (missing > 0 ? low : high) = solution.increment;
        const double newton = solution.increment + missing / at.n_free;  // infinite if none is free
        const bool trusted =
            newton > low && newton < high && std::abs(missing) <= previous_residual / 2;
        const double next = trusted ? newton : std::midpoint(low, high);
        previous_residual = std::abs(missing);
        if (next == solution.increment || next <= low || next >= high) {
            if (solution.residual <= 1e-12) return solution;
            break;
        }
        solution.increment = next;
    }
    throw contact::NotConverged(fmt::format(
        "spring bed: tangential force not found after {} steps, residual {:.3g} of the friction "
        "limit, {} springs in contact",
        solution.iterations, solution.residual, bounds.size()));
}

template <class Shares>
SlipSums take(std::span<const double> before, std::span<const double> bounds, const Shares carried,
              double increment, double negligible, std::span<double> after) {
    const double* const old = before.data();
    const double* const bound = bounds.data();
    double* const u = after.data();
    CompensatedSum all_deflection, all_dissipated, all_trapezoidal, all_stored, all_energy,
        all_unmet;
    double n_stick = 0, lowest_work = 0, bound_excess = 0;
    for_each_block(0, static_cast<int>(bounds.size()), [&](int begin, int end) {
        double deflection = 0, dissipated = 0, trapezoidal = 0, stored = 0, energy = 0, unmet = 0;
#pragma omp simd reduction(+ : deflection, dissipated, trapezoidal, stored, n_stick, energy, unmet) \
    reduction(min : lowest_work) reduction(max : bound_excess)
        for (int i = begin; i < end; ++i) {
            const double way = carried[i] * increment, trial = old[i] + way;
            u[i] = std::min(std::max(trial, -bound[i]), bound[i]);
            const double slip = trial - u[i];  // exactly zero where it sticks
            const double work = u[i] * slip;
            deflection += u[i];
            dissipated += std::abs(work);
            trapezoidal += (work + old[i] * slip) / 2;
            stored += (u[i] * u[i] - old[i] * old[i]) / 2;
            energy += u[i] * u[i] / 2;
            unmet += u[i] * (increment - way) / 2;
            n_stick += std::abs(slip) <= negligible ? 1. : 0.;
            lowest_work = std::min(lowest_work, work);
            bound_excess = std::max(bound_excess, std::abs(u[i]) - bound[i]);
        }
        all_deflection.add(deflection);
        all_dissipated.add(dissipated);
        all_trapezoidal.add(trapezoidal);
        all_stored.add(stored);
        all_energy.add(energy);
        all_unmet.add(unmet);
    });
    return {.deflection = all_deflection.value(),
            .dissipated = all_dissipated.value(),
            .trapezoidal = all_trapezoidal.value(),
            .stored = all_stored.value(),
            .lowest_work = lowest_work,
            .bound_excess = bound_excess,
            .n_stick = n_stick,
            .energy = all_energy.value(),
            .unmet = all_unmet.value()};
}

}  // namespace

ShiftSolution find_increment(std::span<const double> deflections, std::span<const double> bounds,
                             double target, double farthest) {
    return search(deflections, bounds, Whole(), target, farthest);
}

ShiftSolution find_increment(std::span<const double> deflections, std::span<const double> bounds,
                             std::span<const double> carried, double target) {
    double farthest = 0;
    for (std::size_t i = 0; i < bounds.size(); ++i)
        farthest = std::max(farthest, (std::abs(deflections[i]) + bounds[i]) / carried[i]);
    return search(deflections, bounds, carried.data(), target, farthest);
}

SlipSums take_step(std::span<const double> before, std::span<const double> bounds, double increment,
                   double negligible, std::span<double> after) {
    return take(before, bounds, Whole(), increment, negligible, after);
}

SlipSums take_step(std::span<const double> before, std::span<const double> bounds,
                   std::span<const double> carried, double increment, double negligible,
                   std::span<double> after) {
    return take(before, bounds, carried.data(), increment, negligible, after);
}

}  // namespace tricontact::mdr
