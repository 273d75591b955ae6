// What the jumps within a step lose.

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "contact/solvers/adhesive_normal.h"

namespace tricontact::contact {

namespace {

/// What is set free in a step, over w and the area that attracts, from which on it is looked at
/// closer: whether halves of the step show it to be the error of an integral, or it is bisected,
/// for an integral by trapezoids knows where a jump was to the step that it is in.
constexpr double is_seen = 3e-4, like_a_rule = .1;
/// Errors of integrals that are left, over what is stored: of smooth parts of the way nothing is
/// set free.
constexpr double most_unbalanced = 2e-4;
/// A jump by F is then known to F/2 times a 4096th of the step.
constexpr int most_bisections = 12;

}  // namespace

double AdhesiveNormal::attracted_area(const NormalSolution& s) const {
    const auto& area = compliance_.points().area;
    double sum = 0;
    for (std::size_t i = 0; i < area.size(); ++i)
        sum += area[i] * s.tension[i] / attraction_.strength;
    return sum;
}

/// What is set free on the way, by the trapezoidal rule: work less what is stored.
double AdhesiveNormal::freed(const NormalSolution& before, const NormalSolution& after) const {
    const double work =
        .5 * (before.force + after.force) * (after.indentation - before.indentation);
    return work - (after.energy - before.energy);
}

/// Empty at the end of a branch, where iterates converge too slowly.
std::optional<NormalSolution> AdhesiveNormal::settled(const std::vector<double>& height,
                                                      const NormalControl& control,
                                                      const NormalSolution& before) const {
    try {
        return settle(height, control, before);
    } catch (const NotConverged&) {
        return {};
    }
}

NormalSolution AdhesiveNormal::resolve(const std::vector<double>& height, const NormalControl& from,
                                       const NormalControl& to, const NormalSolution& before,
                                       NormalSolution after, int depth) const {
    const double unit =
        attraction_.work() * std::max(attracted_area(before), attracted_area(after));
    const double stored = unit + std::max(std::abs(before.energy), std::abs(after.energy));
    const double whole = freed(before, after);
    const auto smooth = [&](double missing) {
        after.released = 0;
        after.unbalanced = stored > 0 ? missing / stored : 0;
    };
    smooth(whole);
    if (!(std::abs(whole) > is_seen * unit)) return after;
    NormalControl half = to;
    half.value = (from.value + to.value) / 2;
    std::optional<NormalSolution> between;
    if (depth < most_bisections) between = settled(height, half, before);
    if (!between) {
        smooth(0);
        after.released = whole;
        return after;
    }
    after.iterations += between->iterations;
    // Of a smooth change the rule's error is a quarter of that of the whole step.
    const double halves = freed(before, *between) + freed(*between, after);
    const double by_simpson = (4 * halves - whole) / 3;
    if (std::abs(halves - whole / 4) <= like_a_rule * std::abs(whole) &&
        std::abs(by_simpson) <= most_unbalanced * stored) {
        smooth(by_simpson);
        return after;
    }
    const NormalSolution first =
        resolve(height, from, half, before, *std::move(between), depth + 1);
    auto there = settled(height, to, first);
    NormalSolution last =
        resolve(height, half, to, first, there ? *std::move(there) : std::move(after), depth + 1);
    last.released += first.released;
    last.unbalanced = larger(std::abs(first.unbalanced), std::abs(last.unbalanced));
    last.iterations += first.iterations;
    return last;
}

NormalSolution AdhesiveNormal::follow(const std::vector<double>& height,
                                      const NormalControl& control,
                                      const NormalSolution& before) const {
    if (cells_ || !before.attracts()) return settle(height, control, before);
    const bool by_force = control.kind == NormalControl::Kind::force;
    return resolve(height, {control.kind, by_force ? before.force : before.indentation}, control,
                   before, settle(height, control, before), 0);
}

}  // namespace tricontact::contact
