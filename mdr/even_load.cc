#include "mdr/even_load.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tricontact::mdr {

namespace {

// Where the load ends beyond its last point, seen from the centre: `inner` is that point's
// neighbour.
double end_of_load(const PointRow& row, std::span<const double> load, double centre, int last,
                   int inner) {
    const double x = std::abs(row.position(last) - centre);
    const double x_inner = std::abs(row.position(inner) - centre);
    if (!(load[inner] > load[last])) return x + row.spacing / 2;
    const double squared =
        x * x + (x * x - x_inner * x_inner) * load[last] / (load[inner] - load[last]);
    return std::min(std::sqrt(squared), x + row.spacing);
}

double half_width_of(const PointRow& row, std::span<const double> load, double centre) {
    auto carries = [](double q) { return q > 0; };
    const int first =
        static_cast<int>(std::find_if(load.begin(), load.end(), carries) - load.begin());
    const int last =
        static_cast<int>(load.rend() - std::find_if(load.rbegin(), load.rend(), carries)) - 1;
    if (first >= last) return row.spacing / 2;
    return (end_of_load(row, load, centre, first, first + 1) +
            end_of_load(row, load, centre, last, last - 1)) /
           2;
}

}  // namespace

double PointRow::interpolate(std::span<const double> values, double x) const {
    const double index = (x - first) / spacing;
    const double below = std::floor(index), part = index - below;
    auto at = [&](double i) {
        return i >= 0 && i < static_cast<double>(values.size())
                   ? values[static_cast<std::size_t>(i)]
                   : 0.;
    };
    return (1 - part) * at(below) + part * at(below + 1);
}

double PointRow::even(std::span<const double> values, double centre, double x) const {
    return (interpolate(values, centre + x) + interpolate(values, centre - x)) / 2;
}

EvenLoad even_load(const PointRow& row, std::span<const double> load, double centre,
                   int most_pieces) {
    const double a = half_width_of(row, load, centre);
    const int stride = static_cast<int>(std::ceil(a / row.spacing / most_pieces));
    EvenLoad even;
    // Whole spacings: what the interpolation misses is then the same everywhere and drops out of
    // differences.
    for (double x = 0; x < a - row.spacing / 10; x += stride * row.spacing) {
        even.positions.push_back(x);
        even.values.push_back(row.even(load, centre, x));
    }
    even.positions.push_back(a);
    even.values.push_back(0);
    return even;
}

double EvenLoad::centre_pressure() const {
    double sum = 0;
    for (std::size_t k = 0; k + 1 < positions.size(); ++k)
        sum += (values[k] - values[k + 1]) / (positions[k] + positions[k + 1]);
    return 2 / std::numbers::pi * sum;
}

}  // namespace tricontact::mdr
