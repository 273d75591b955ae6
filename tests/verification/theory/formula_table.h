#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "atlas/atlas.h"
#include "atlas/shipped.h"
#include "comparisons/quantities/quantities.h"

namespace tricontact::formula_table {

using comparisons::Quantity;
using Point = std::vector<double>;

// Points of the domain, evenly spread, those of a logarithmic axis over the logarithm; the same on
// every computer.
inline std::vector<Point> points_of(const atlas::Atlas& atlas) {
    std::mt19937_64 engine(20261124);
    std::vector<Point> points(6000);
    for (Point& point : points)
        for (const atlas::Axis& axis : atlas.axes) {
            const double share = std::ldexp(static_cast<double>(engine() >> 11), -53);
            point.push_back(axis.range.scale == io::Study::Scale::log
                                ? axis.from * std::pow(axis.to / axis.from, share)
                                : axis.from + (axis.to - axis.from) * share);
        }
    return points;
}

struct Errors {
    double largest, median;  ///< per cent
};

/// One row of the table.
struct Row {
    const char* formula;
    Errors stated;  ///< rounded up to two digits
    std::function<double(const Point&)> value;
};

class Table {
  public:
    Table(
        const char* atlas, const Quantity& quantity,
        std::function<bool(const Point&)> filter = [](const Point&) { return true; })
        : atlas_(atlas::shipped(atlas)) {
        atlas::Reader reader(atlas_);
        for (Point& point : points_of(atlas_)) {
            if (!filter(point)) continue;
            reader.go_to(point);
            const double value = reader.read(*atlas_.find(quantity)).value;
            if (!std::isfinite(value)) continue;  // a place where the atlas' bar is too long
            truth_.push_back(value);
            points_.push_back(std::move(point));
        }
    }

    /// Prints the row; its errors have neither grown nor become much smaller than stated.
    void check(const Row& row) const {
        std::vector<double> errors;
        for (std::size_t i = 0; i < points_.size(); ++i)
            errors.push_back(100 * std::abs(row.value(points_[i]) / truth_[i] - 1));
        std::ranges::sort(errors);
        const Errors found{errors.back(), errors[errors.size() / 2]};
        fmt::print(
            "| {} | {} | {:.2g} | {} |\n", row.formula,
            fmt::format(fmt::runtime(found.largest < 100 ? "{:.2g}" : "{:.0f}"), found.largest),
            found.median, errors.size());
        EXPECT_LE(found.largest, row.stated.largest) << row.formula;
        EXPECT_LE(found.median, row.stated.median) << row.formula;
        EXPECT_GE(found.largest, .8 * row.stated.largest) << row.formula;
        EXPECT_GE(found.median, .7 * row.stated.median) << row.formula;
    }

  private:
    const atlas::Atlas& atlas_;
    std::vector<Point> points_;
    std::vector<double> truth_;
};

}  // namespace tricontact::formula_table
