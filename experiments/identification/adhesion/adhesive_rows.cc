#include "experiments/identification/adhesion/adhesive_rows.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "statistics/estimate.h"

namespace tricontact::experiments {

namespace {

// Of the standard error of a force: noise alone is not so far below 0 in ten thousand rows.
constexpr double shown_tension = 8, no_tension = 4;

/// How often forces fall from above -no_tension to below -shown_tension errors.
int onsets(std::span<const double> forces, double error) {
    int n = 0;
    bool is_free = true;
    for (const double force : forces) {
        if (is_free && force < -shown_tension * error) ++n;
        if (force < -shown_tension * error) is_free = false;
        if (force > -no_tension * error) is_free = true;
    }
    return n;
}

/// By the median of the second differences, which a smooth curve leaves small.
double error_of_neighbours(const std::vector<double>& forces) {
    std::vector<double> differences;
    for (std::size_t i = 2; i < forces.size(); ++i)
        differences.push_back(std::abs(forces[i] - 2 * forces[i - 1] + forces[i - 2]));
    if (differences.empty()) return 0;
    constexpr double normal_median = .6745;
    return statistics::median(std::move(differences)) / (normal_median * std::sqrt(6.));
}

}  // namespace

AdhesiveRows adhesive_rows(const std::vector<double>& depths, const std::vector<double>& forces,
                           double error) {
    if (error == 0) error = error_of_neighbours(forces);
    const auto turn = std::ranges::max_element(depths) - depths.begin();
    const auto begin = forces.begin(), back = begin + turn;
    const auto least_in = std::min_element(begin, back + 1),
               least_out = std::min_element(back, forces.end());
    const double tension = -shown_tension * error;
    const bool jumps_in = *least_in < tension, jumps_off = *least_out < tension;
    AdhesiveRows found{.shows_jump = jumps_in || jumps_off};
    found.n_onsets =
        std::max(onsets({begin, back + 1}, error), onsets({back, forces.end()}, error));
    for (auto at = begin; at != forces.end(); ++at) {
        const bool approaches = at <= back;
        if (approaches && jumps_in && at <= least_in) continue;
        if (!approaches && jumps_off && at >= least_out) continue;
        found.rows.push_back(static_cast<std::size_t>(at - begin));
        found.ways.push_back(approaches  ? jumps_in ? AdhesiveWay::joined : AdhesiveWay::approach
                             : jumps_off ? AdhesiveWay::held
                                         : AdhesiveWay::separation);
    }
    return found;
}

}  // namespace tricontact::experiments
