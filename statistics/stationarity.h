#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tricontact::statistics {

/// First, second and last third of a series, the last two counted from its end. The course of a
/// series is judged by its thirds: what lies between the first and the last would blur a change in
/// the middle.
template <class Value>
struct Thirds {
    explicit Thirds(std::span<const Value> values)
        : first(values.first(values.size() / 3)),
          second(values.last(2 * first.size()).first(first.size())),
          last(values.last(first.size())) {}

    std::span<const Value> first, second, last;
};

/// How many values to leave out at the beginning so that the mean of the rest has the least error:
/// marginal standard error rule (MSER), White (1997), Simulation 69. At most half of them; a rule
/// that would leave out half has not found the end of the transient.
std::size_t transient_values(std::span<const double> values);

/// Whether the first and the last third of the values have the same mean within their intervals,
/// after Geweke (1992): they differ by less than 1.5 times the 95 % interval of their difference,
/// which chance exceeds 3 times in 1000. Errors are of what a straight line leaves of a third.
/// False for fewer than nine values.
bool stationary(std::span<const double> values);

/// Euclidean distance of two points of one dimension.
double distance(std::span<const double> a, std::span<const double> b);

/// Whether a series of points is on its way and will not be there soon: the centres of its first
/// and last third are farther apart than both thirds scatter about them, and from the second third
/// to the last it goes farther than `error` and than 0.48 of the way from the first to the second.
/// A series that comes nearer to its end by a factor r in each third has halves whose means differ
/// by more than the mean of the whole is off that end if r < 3^(-2/3) = 0.48: then the halves tell
/// its error. False for fewer than six points.
bool creeps(std::span<const std::vector<double>> points, double error);

}  // namespace tricontact::statistics
