#include "experiments/identification/loops/loop_fit.h"

#include <algorithm>
#include <cmath>

namespace tricontact::experiments {

namespace {

constexpr std::size_t n_all = n_of_loop + 1;
using Numbers = std::array<double, n_all>;
using Square = std::array<Numbers, n_all>;

constexpr double amplitude_margin = .1;                     // of the amplitude
constexpr double least_friction = .05, most_friction = 20;  // over the curve's
constexpr int most_steps = 30, most_halvings = 6;
constexpr double step_tolerance = 1e-8;  // of the box
constexpr double rounding = 1e-12;
// Of the sum of squares: 1e-7 of the residuals, which differences of the outer fit resolve.
constexpr double least_gain = 1e-14;
// Of the largest in its row and column: two numbers that do the same share what they do.
constexpr double ridge = 1e-10;

// Of what the rows say of centre and amplitude: so much weight have the extreme shifts, which
// decide where the rows say nothing, as of loops that are nearly closed.
constexpr double weight_of_extremes = 1e-3;

struct Box {
    Numbers low, high;
};

/// Solves the part of a positive system that is free, by scaled elimination with a ridge.
Numbers solved(Square a, Numbers b, const std::array<bool, n_all>& free) {
    Numbers size, x{};
    for (std::size_t i = 0; i < n_all; ++i) size[i] = std::sqrt(std::max(a[i][i], 1e-300));
    for (std::size_t i = 0; i < n_all; ++i) {
        for (std::size_t k = 0; k < n_all; ++k)
            a[i][k] = free[i] && free[k] ? a[i][k] / (size[i] * size[k]) : 0.;
        a[i][i] = free[i] && a[i][i] > 0 ? 1 + ridge : 1;
        b[i] = free[i] ? b[i] / size[i] : 0;
    }
    for (std::size_t k = 0; k < n_all; ++k)
        for (std::size_t i = k + 1; i < n_all; ++i) {
            const double factor = a[i][k] / a[k][k];
            for (std::size_t j = k; j < n_all; ++j) a[i][j] -= factor * a[k][j];
            b[i] -= factor * b[k];
        }
    for (std::size_t i = n_all; i-- > 0;) {
        x[i] = b[i];
        for (std::size_t k = i + 1; k < n_all; ++k) x[i] -= a[i][k] * x[k];
        x[i] /= a[i][i];
    }
    for (std::size_t i = 0; i < n_all; ++i) x[i] /= size[i];
    return x;
}

struct Normal {
    Square information{};
    Numbers gradient{};
};

Normal normal_of(const LoopRows& rows, const FittedLoop& fit) {
    Normal normal;
    for (std::size_t i = 0; i < rows.forces.size(); ++i) {
        const double weight = 1 / (rows.error(i) * rows.error(i));
        const double residual = rows.forces[i] - fit.forces[i];
        for (std::size_t k = 0; k < n_all; ++k) {
            normal.gradient[k] += weight * fit.slopes[k][i] * residual;
            for (std::size_t l = 0; l < n_all; ++l)
                normal.information[k][l] += weight * fit.slopes[k][i] * fit.slopes[l][i];
        }
    }
    return normal;
}

/// Gauss and Newton's step within the box: what would leave it stays at its edge.
Numbers step_within(const Normal& normal, LoopState state, const Box& box,
                    std::array<bool, n_all> free) {
    Numbers held{};
    for (std::size_t round = 0; round < n_all; ++round) {
        Numbers right = normal.gradient;
        for (std::size_t i = 0; i < n_all; ++i)
            for (std::size_t k = 0; k < n_all; ++k) right[i] -= normal.information[i][k] * held[k];
        Numbers step = solved(normal.information, right, free);
        bool all_inside = true;
        for (std::size_t k = 0; k < n_all; ++k) {
            if (!free[k]) {
                step[k] = held[k];
                continue;
            }
            const double to = std::clamp(state[k] + step[k], box.low[k], box.high[k]);
            if (to == state[k] + step[k]) continue;
            held[k] = to - state[k];
            free[k] = false;
            all_inside = false;
        }
        if (all_inside) return step;
    }
    return held;
}

void add_covariance(const LoopRows& rows, const Box& box, const std::array<bool, n_all>& free,
                    FittedLoop& fit) {
    std::array<bool, n_all> inside = free;
    for (std::size_t k = 0; k < n_all; ++k)
        inside[k] = free[k] && fit.state[k] > box.low[k] && fit.state[k] < box.high[k];
    const Normal normal = normal_of(rows, fit);
    for (std::size_t k = 0; k < n_all; ++k) {
        Numbers unit{};
        unit[k] = 1;
        if (inside[k]) fit.covariance[k] = solved(normal.information, unit, inside);
    }
}

}  // namespace

FittedLoop loop_of_state(const LoopRows& rows, const LoopCurve& curve, const LoopState& state) {
    FittedLoop fit{.state = state};
    const std::size_t n = rows.shifts.size();
    fit.forces.reserve(n);
    for (auto& slopes : fit.slopes) slopes.reserve(n);
    // Of friction s a curve is s F(U/s): its slope by s is F/s - U/s dF/dU.
    const auto by_friction = [&](const LoopCurve::Point& p, double shift) {
        return (p.force - shift * p.slope) / state.friction;
    };
    const auto end = curve.at(state.amplitude, state.friction);
    for (std::size_t i = 0; i < n; ++i) {
        const double way =
            (state.amplitude + (rows.rises[i] ? 1 : -1) * (rows.shifts[i] - state.centre)) / 2;
        const auto point = curve.at(way, state.friction);
        const double sign = rows.rises[i] ? 1 : -1;
        const double force = state.force_offset + sign * (2 * point.force - end.force);
        fit.forces.push_back(force);
        fit.slopes[0].push_back(1);
        fit.slopes[1].push_back(-point.slope);
        fit.slopes[2].push_back(sign * (point.slope - end.slope));
        fit.slopes[3].push_back(sign *
                                (2 * by_friction(point, way) - by_friction(end, state.amplitude)));
        const double residual = (rows.forces[i] - force) / rows.error(i);
        fit.sum_of_squares += residual * residual;
    }
    return fit;
}

FittedLoop fit_loop(const LoopRows& rows, const LoopCurve& curve, double friction,
                    bool frees_friction, const LoopState* start) {
    const MeasuredLoop& loop = rows.loop;
    const double margin = amplitude_margin * loop.amplitude;
    const auto [least, most] = std::ranges::minmax(rows.forces);
    const Box box{{least, loop.centre - margin, loop.amplitude - margin, least_friction * friction},
                  {most, loop.centre + margin, loop.amplitude + margin, most_friction * friction}};
    const std::array free{true, true, true, frees_friction};
    LoopState seen{(least + most) / 2, loop.centre, loop.amplitude, friction};
    FittedLoop fit = loop_of_state(rows, curve, seen);
    const Normal first = normal_of(rows, fit);
    if (start) {
        FittedLoop nearby = loop_of_state(
            rows, curve, {start->force_offset, start->centre, start->amplitude, friction});
        if (nearby.sum_of_squares < fit.sum_of_squares) fit = std::move(nearby);
    }
    Numbers weights{};
    for (const std::size_t k : {1, 2}) weights[k] = weight_of_extremes * first.information[k][k];
    const auto penalty = [&](LoopState state) {
        double sum = 0;
        for (std::size_t k = 0; k < n_all; ++k) sum += weights[k] * std::pow(state[k] - seen[k], 2);
        return sum;
    };
    for (int i = 0; i < most_steps; ++i) {
        Normal normal = normal_of(rows, fit);
        for (std::size_t k = 0; k < n_all; ++k) {
            normal.information[k][k] += weights[k];
            normal.gradient[k] -= weights[k] * (fit.state[k] - seen[k]);
        }
        const Numbers step = step_within(normal, fit.state, box, free);
        double largest = 0, gain = 0;
        for (std::size_t k = 0; k < n_all; ++k) {
            largest = std::max(largest, std::abs(step[k]) / (box.high[k] - box.low[k]));
            gain += normal.gradient[k] * step[k];
        }
        const double sum = fit.sum_of_squares + penalty(fit.state);
        if (largest < step_tolerance || gain < least_gain * sum) break;
        double share = 1;
        bool is_better = false;
        for (int halving = 0; halving < most_halvings; ++halving, share /= 2) {
            LoopState next = fit.state;
            for (std::size_t k = 0; k < n_all; ++k) next[k] += share * step[k];
            FittedLoop there = loop_of_state(rows, curve, next);
            if (there.sum_of_squares + penalty(next) > (1 + rounding) * sum) continue;
            fit = std::move(there);
            is_better = true;
            break;
        }
        if (!is_better) break;
    }
    add_covariance(rows, box, free, fit);
    return fit;
}

}  // namespace tricontact::experiments
