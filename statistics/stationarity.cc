#include "statistics/stationarity.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "statistics/initial_sequence.h"

namespace tricontact::statistics {
namespace {

/// Mean with the error of what a straight line leaves of the values: a trend, which is what is
/// looked for, would pass for scatter.
Mean mean_beside_trend(std::span<const double> values) {
    const double n = static_cast<double>(values.size()), middle = (n - 1) / 2;
    double sum = 0, moment = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        sum += values[i];
        moment += (static_cast<double>(i) - middle) * values[i];
    }
    const double slope = 12 * moment / (n * (n * n - 1));
    std::vector<double> rest(values.begin(), values.end());
    for (std::size_t i = 0; i < rest.size(); ++i)
        rest[i] -= slope * (static_cast<double>(i) - middle);
    return {sum / n, initial_sequence_mean(rest).error};
}

using Point = std::vector<double>;

Point centre_of(std::span<const Point> points) {
    Point centre(points.front().size());
    for (const Point& point : points)
        for (std::size_t i = 0; i < centre.size(); ++i)
            centre[i] += point[i] / static_cast<double>(points.size());
    return centre;
}

/// Greatest distance of the points from their centre.
double scatter(std::span<const Point> points, const Point& centre) {
    double greatest = 0;
    for (const Point& point : points) greatest = std::max(greatest, distance(point, centre));
    return greatest;
}

}  // namespace

std::size_t transient_values(std::span<const double> values) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity(), sum = 0, squares = 0;
    for (std::size_t left = values.size(); left-- > 0;) {
        sum += values[left];
        squares += values[left] * values[left];
        const double n = static_cast<double>(values.size() - left);
        const double error = (squares - sum * sum / n) / (n * n);
        if (2 * left > values.size() || error > least) continue;
        least = error;
        best = left;
    }
    return best;
}

bool stationary(std::span<const double> values) {
    const Thirds<double> thirds(values);
    if (thirds.first.size() < 3) return false;
    const Mean before = mean_beside_trend(thirds.first), after = mean_beside_trend(thirds.last);
    return std::abs(after.value - before.value) <= 1.5 * std::hypot(before.error, after.error);
}

double distance(std::span<const double> a, std::span<const double> b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum);
}

bool creeps(std::span<const Point> points, double error) {
    const Thirds<Point> thirds(points);
    if (thirds.first.size() < 2) return false;
    const Point first = centre_of(thirds.first), second = centre_of(thirds.second),
                last = centre_of(thirds.last);
    const double slower = std::pow(3, -2. / 3);
    return distance(first, last) > scatter(thirds.first, first) + scatter(thirds.last, last) &&
           distance(second, last) > std::max(error, slower * distance(first, second));
}

}  // namespace tricontact::statistics
