#include "contact/friction/friction_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <stdexcept>

#include "contact/base/error.h"

namespace tricontact::contact {

namespace {

void check_positions(const std::vector<double>& positions) {
    if (positions.size() < 2 ||
        std::ranges::adjacent_find(positions, std::greater_equal<>()) != positions.end())
        throw std::invalid_argument("FrictionMap: positions must increase, two or more");
}

/// Between two positions: the first of them, and the part of the way to the next.
struct Place {
    std::size_t row;
    double part;
};

Place place_in(const std::vector<double>& positions, double value, char axis) {
    if (value < positions.front() || value > positions.back())
        throw InputError(
            fmt::format("friction.map: the contact reaches {0} = {1:.4g} mm, the map has {0} from "
                        "{2:.4g} to {3:.4g} mm; enlarge the map or shorten the path",
                        axis, 1e3 * value, 1e3 * positions.front(), 1e3 * positions.back()));
    const auto next = std::upper_bound(positions.begin() + 1, positions.end() - 1, value);
    const auto row = static_cast<std::size_t>(next - positions.begin()) - 1;
    return {row, (value - positions[row]) / (positions[row + 1] - positions[row])};
}

}  // namespace

FrictionMap::FrictionMap(std::vector<double> x, std::vector<double> y, std::vector<double> factor)
    : x_(std::move(x)), y_(std::move(y)), factor_(std::move(factor)) {
    check_positions(x_);
    if (!y_.empty()) check_positions(y_);
    if (factor_.size() != x_.size() * std::max<std::size_t>(1, y_.size()))
        throw std::invalid_argument("FrictionMap: a factor for each position");
}

double FrictionMap::at(double x, double y) const {
    const auto [i, along] = place_in(x_, x, 'x');
    const auto in_row = [&, i = i, along = along](std::size_t j) {
        const double* const row = factor_.data() + j * x_.size();
        return row[i] + along * (row[i + 1] - row[i]);
    };
    if (y_.empty()) return in_row(0);
    const auto [j, across] = place_in(y_, y, 'y');
    return in_row(j) + across * (in_row(j + 1) - in_row(j));
}

}  // namespace tricontact::contact
