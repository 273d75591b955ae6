#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace tricontact::experiments {

/// A place in the box of a design, and what was found there.
struct DesignPoint {
    std::vector<double> fractions;  ///< of each range, 0 to 1
    std::vector<double> ratios;     ///< of each requirement, met up to 1; NaN: not known

    /// The largest ratio; infinite where one is not known.
    double worst() const;
    bool is_feasible() const { return worst() <= 1; }
    /// The requirements within 1 % of the worst; none where one is not known.
    std::vector<std::size_t> binding() const;
};

/// How far one key may move where the others stay at the best place.
struct Stretch {
    double low = 0, high = 1;  ///< fractions of its range
    /// The requirement that ends it; empty: the bound of the range, or that something is not known.
    std::optional<std::size_t> low_requirement, high_requirement;
};

/// A bound that is in the way.
struct Widening {
    std::size_t axis = 0;
    bool upwards = false;
};

/// The place where the worst ratio is least, and what lies around it.
struct DesignSolution {
    int points_per_axis = 0;        ///< of `grid`
    std::vector<DesignPoint> grid;  ///< over the whole box, first axis fastest
    DesignPoint best;
    std::vector<Stretch> stretches;  ///< one per axis; none if nothing is feasible
    /// Where nothing is feasible: bounds at which the best place lies and a little beyond which the
    /// worst ratio is smaller.
    std::vector<Widening> widenings;
    int map_points = 0;            ///< along either axis of `map`
    std::vector<DesignPoint> map;  ///< over the first two axes, the others as at the best place
};

/// Ratios at fractions of the ranges. Must be defined, if only by NaN, a little outside the box.
using DesignRatios = std::function<std::vector<double>(const std::vector<double>& fractions)>;

/// Scans the box and refines the best minima of the scan by simplices (Nelder and Mead, Computer
/// J. 7 (1965) 308), which need no derivative: the largest of several ratios has a crease where it
/// is least. Deterministic. `n_axes` from 1 to 4.
DesignSolution search_design(const DesignRatios& ratios, std::size_t n_axes);

/// Those of the points that no other one beats in one coordinate without losing in the other, by
/// increasing first coordinate.
std::vector<std::pair<double, double>> pareto_front(std::vector<std::pair<double, double>> points);

}  // namespace tricontact::experiments
