#include "experiments/identification/loops/loop_stiffness.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tricontact::experiments {

namespace {

constexpr double last_part = .05;  // of the way of a branch, before its reversal

/// 0 at the reversal behind which the branch begins, 1 at the other.
double way_of(const LoopRows& rows, std::size_t i) {
    const double x = rows.shifts[i] - rows.loop.centre;
    return (rows.loop.amplitude + (rows.rises[i] ? x : -x)) / rows.loop.amplitude / 2;
}

std::vector<std::size_t> rows_of_branch(const LoopRows& rows, bool rises, double from, double to) {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < rows.shifts.size(); ++i)
        if (const double way = way_of(rows, i); rows.rises[i] == rises && from <= way && way <= to)
            places.push_back(i);
    return places;
}

/// At its end, or the last one before it.
std::vector<std::size_t> end_of_branch(const LoopRows& rows, bool rises) {
    auto places = rows_of_branch(rows, rises, 1 - last_part, 1);
    if (!places.empty()) return places;
    places = rows_of_branch(rows, rises, 0, 1);
    return {*std::ranges::max_element(places, {}, [&](std::size_t i) { return way_of(rows, i); })};
}

}  // namespace

std::optional<RowWeights> initial_stiffness(const LoopRows& rows, double part) {
    RowWeights weights(rows.shifts.size(), 0.);
    int n_branches = 0;
    for (const bool rises : {true, false}) {
        const auto places = rows_of_branch(rows, rises, -1, part);
        const auto n = static_cast<double>(places.size());
        double mean = 0, squares = 0;
        for (const std::size_t i : places) mean += rows.shifts[i] / n;
        for (const std::size_t i : places) squares += std::pow(rows.shifts[i] - mean, 2);
        if (places.size() < 3 || !(squares > 0)) continue;
        for (const std::size_t i : places) weights[i] += (rows.shifts[i] - mean) / squares;
        ++n_branches;
    }
    if (n_branches == 0) return {};
    for (double& weight : weights) weight /= n_branches;
    return weights;
}

RowWeights secant_stiffness(const LoopRows& rows) {
    RowWeights weights(rows.shifts.size(), 0.);
    double way = 0;
    for (const bool rises : {true, false}) {
        const auto places = end_of_branch(rows, rises);
        const double share = (rises ? 1 : -1) / static_cast<double>(places.size());
        for (const std::size_t i : places) {
            weights[i] = share;
            way += share * rows.shifts[i];
        }
    }
    for (double& weight : weights) weight /= way;
    return weights;
}

double weighted(const RowWeights& weights, std::span<const double> values) {
    return std::inner_product(weights.begin(), weights.end(), values.begin(), 0.);
}

double weighted_error(const RowWeights& weights, const LoopRows& rows) {
    double variance = 0;
    for (std::size_t i = 0; i < weights.size(); ++i)
        variance += std::pow(weights[i] * rows.error(i), 2);
    return std::sqrt(variance);
}

}  // namespace tricontact::experiments
