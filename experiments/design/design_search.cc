#include "experiments/design/design_search.h"

#include <gsl/gsl_multimin.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>

#include "contact/base/special_values.h"

namespace tricontact::experiments {

namespace {

constexpr std::array<int, 4> scan_points{21, 9, 5, 4};  // along each of one to four axes
constexpr int map_points = 9;
constexpr double same = 1.01;       // times the worst ratio: binds as well
constexpr double outside = 0.02;    // of a range, beyond a bound that may be in the way
constexpr double at_bound = 1e-3;   // of a range
constexpr double unknown_log = 50;  // instead of the logarithm of an infinite ratio

using Ratios = DesignRatios;

/// Points of an n-dimensional grid over the unit cube, first coordinate fastest.
std::vector<std::vector<double>> cube_grid(std::size_t n_axes, int n) {
    std::vector<std::vector<double>> places{std::vector<double>(n_axes)};
    for (std::size_t axis = n_axes; axis-- > 0;) {
        std::vector<std::vector<double>> more;
        for (const auto& place : places)
            for (int i = 0; i < n; ++i) {
                more.push_back(place);
                more.back()[axis] = static_cast<double>(i) / (n - 1);
            }
        places = std::move(more);
    }
    return places;
}

bool are_neighbours(const DesignPoint& a, const DesignPoint& b, double step) {
    for (std::size_t i = 0; i < a.fractions.size(); ++i)
        if (std::abs(a.fractions[i] - b.fractions[i]) > 1.5 * step) return false;
    return true;
}

/// The best minima of the grid, none beside another, at most two.
std::vector<DesignPoint> starts(const DesignSolution& s) {
    constexpr std::size_t most = 2;
    const double step = 1. / (s.points_per_axis - 1);
    std::vector<DesignPoint> sorted = s.grid, chosen;
    std::ranges::stable_sort(sorted, {}, &DesignPoint::worst);
    for (const DesignPoint& p : sorted) {
        const bool is_minimum = std::ranges::none_of(s.grid, [&](const DesignPoint& other) {
            return other.worst() < p.worst() && are_neighbours(other, p, step);
        });
        const bool is_new = std::ranges::none_of(
            chosen, [&](const DesignPoint& other) { return are_neighbours(other, p, step); });
        if (is_minimum && is_new && std::isfinite(p.worst())) chosen.push_back(p);
        if (chosen.size() == most) break;
    }
    return chosen;
}

/// What the simplex sees: the logarithm of the worst ratio at the nearest place in the box, more
/// outside.
struct Objective {
    const Ratios& ratios_;
    DesignPoint best_;

    double operator()(const gsl_vector& x) {
        DesignPoint p;
        double beyond = 0;
        for (std::size_t i = 0; i < x.size; ++i) {
            const double at = gsl_vector_get(&x, i);
            p.fractions.push_back(std::clamp(at, 0., 1.));
            beyond += std::abs(at - p.fractions.back());
        }
        p.ratios = ratios_(p.fractions);
        const double worst = p.worst();
        if (worst < best_.worst()) best_ = std::move(p);
        return (std::isfinite(worst) ? std::log(worst) : unknown_log) + beyond;
    }
};

struct FreeVector {
    void operator()(gsl_vector* v) const { gsl_vector_free(v); }
};
struct FreeMinimizer {
    void operator()(gsl_multimin_fminimizer* m) const { gsl_multimin_fminimizer_free(m); }
};

/// One simplex of this size from the objective's best place on.
void descend(Objective& objective, double size) {
    constexpr int most_steps = 25;
    constexpr double finest = 3e-4;
    const std::size_t n = objective.best_.fractions.size();
    const std::unique_ptr<gsl_vector, FreeVector> start(gsl_vector_alloc(n)),
        steps(gsl_vector_alloc(n));
    for (std::size_t i = 0; i < n; ++i) {
        const double at = objective.best_.fractions[i];
        gsl_vector_set(start.get(), i, at);
        gsl_vector_set(steps.get(), i, at > 0.5 ? -size : size);
    }
    gsl_multimin_function function{
        [](const gsl_vector* x, void* of) { return (*static_cast<Objective*>(of))(*x); }, n,
        &objective};
    const std::unique_ptr<gsl_multimin_fminimizer, FreeMinimizer> simplex(
        gsl_multimin_fminimizer_alloc(gsl_multimin_fminimizer_nmsimplex2, n));
    gsl_multimin_fminimizer_set(simplex.get(), &function, start.get(), steps.get());
    for (int step = 0; step < most_steps; ++step)
        if (gsl_multimin_fminimizer_iterate(simplex.get()) != 0 ||
            gsl_multimin_fminimizer_size(simplex.get()) < finest)
            break;
}

/// Simplices end early in a crease: further ones begin where the last one ended.
DesignPoint refined(const Ratios& ratios, const DesignPoint& start, double step) {
    Objective objective{ratios, start};
    for (const double size : {step, step / 4}) descend(objective, size);
    return objective.best_;
}

DesignPoint moved(const Ratios& ratios, const DesignPoint& from, std::size_t axis, double to) {
    DesignPoint p = from;
    p.fractions[axis] = to;
    p.ratios = ratios(p.fractions);
    return p;
}

/// From the feasible best place towards `end` (0 or 1): the last feasible fraction, and what ends
/// it.
std::pair<double, std::optional<std::size_t>> end_of_stretch(const Ratios& ratios,
                                                             const DesignPoint& best,
                                                             std::size_t axis, double end) {
    constexpr int n_steps = 8, n_bisections = 7;
    double inside = best.fractions[axis];
    const double step = (end - inside) / n_steps;
    for (int i = 0; i < n_steps; ++i) {
        double beyond = i + 1 == n_steps ? end : inside + step;
        DesignPoint p = moved(ratios, best, axis, beyond);
        if (p.is_feasible()) {
            inside = beyond;
            continue;
        }
        for (int k = 0; k < n_bisections; ++k) {
            const double middle = (inside + beyond) / 2;
            DesignPoint between = moved(ratios, best, axis, middle);
            if (between.is_feasible()) {
                inside = middle;
            } else {
                beyond = middle;
                p = std::move(between);
            }
        }
        const auto binding = p.binding();
        return {inside, binding.empty() ? std::nullopt : std::optional(binding.front())};
    }
    return {end, std::nullopt};
}

void look_around(DesignSolution& s, const Ratios& ratios) {
    for (std::size_t axis = 0; axis < s.best.fractions.size(); ++axis) {
        if (s.best.is_feasible()) {
            Stretch stretch;
            std::tie(stretch.low, stretch.low_requirement) =
                end_of_stretch(ratios, s.best, axis, 0);
            std::tie(stretch.high, stretch.high_requirement) =
                end_of_stretch(ratios, s.best, axis, 1);
            s.stretches.push_back(stretch);
            continue;
        }
        const double at = s.best.fractions[axis];
        const bool is_low = at<at_bound, is_high = at> 1 - at_bound;
        if (!is_low && !is_high) continue;
        const double beyond = is_high ? 1 + outside : -outside;
        if (moved(ratios, s.best, axis, beyond).worst() < s.best.worst())
            s.widenings.push_back({axis, is_high});
    }
}

}  // namespace

double DesignPoint::worst() const {
    double worst = 0;
    for (const double ratio : ratios) {
        if (std::isnan(ratio)) return contact::infinity;
        worst = std::max(worst, ratio);
    }
    return worst;
}

std::vector<std::size_t> DesignPoint::binding() const {
    std::vector<std::size_t> binding;
    const double least = worst() / same;
    if (!std::isfinite(least)) return binding;
    for (std::size_t i = 0; i < ratios.size(); ++i)
        if (ratios[i] >= least) binding.push_back(i);
    std::ranges::stable_sort(binding, std::greater(), [&](std::size_t i) { return ratios[i]; });
    return binding;
}

DesignSolution search_design(const DesignRatios& ratios, std::size_t n_axes) {
    DesignSolution s{.points_per_axis = scan_points.at(n_axes - 1)};
    for (auto& place : cube_grid(n_axes, s.points_per_axis)) {
        std::vector<double> found = ratios(place);
        s.grid.push_back({std::move(place), std::move(found)});
    }
    s.best = *std::ranges::min_element(s.grid, {}, &DesignPoint::worst);
    if (!std::isfinite(s.best.worst())) return s;
    for (const DesignPoint& start : starts(s)) {
        DesignPoint p = refined(ratios, start, 1. / (s.points_per_axis - 1));
        if (p.worst() < s.best.worst()) s.best = std::move(p);
    }
    look_around(s, ratios);
    if (n_axes == 1) return s;
    s.map_points = map_points;
    if (n_axes == 2) {
        s.map = s.grid;
        return s;
    }
    for (const auto& place : cube_grid(2, map_points)) {
        DesignPoint p = s.best;
        std::ranges::copy(place, p.fractions.begin());
        p.ratios = ratios(p.fractions);
        s.map.push_back(std::move(p));
    }
    return s;
}

std::vector<std::pair<double, double>> pareto_front(std::vector<std::pair<double, double>> points) {
    std::ranges::sort(points);
    std::vector<std::pair<double, double>> front;
    for (const auto& p : points)
        if (front.empty() || p.second < front.back().second) front.push_back(p);
    return front;
}

}  // namespace tricontact::experiments
