#pragma once

#include <set>
#include <string>
#include <vector>

#include "comparisons/run/sweep_document.h"
#include "report/format.h"

namespace tricontact::comparisons {

/// The values of an axis in a unit for people; words have none.
struct SweepScale {
    std::string heading;  ///< "substrate.thickness [mm]"
    bool is_number = true;
    report::Unit unit = {};
    std::set<double> values = {};  ///< in that unit
};

/// One per axis.
std::vector<SweepScale> scales_of(const Sweep& sweep);

/// Model, and level where the sweep has several.
std::string name_of(const Sweep::Point& point, const Sweep& sweep);

/// Most points of a figure: each is an element of the page.
inline constexpr std::size_t most_drawn = 2000;

/// Sections of figures over each axis of numbers: settled shifts, shifts per period, static shifts,
/// as far as the sweep has them; none beyond most_drawn points.
std::vector<report::DocumentSection> shift_sections(const Sweep& sweep,
                                                    const std::vector<SweepScale>& scales);

}  // namespace tricontact::comparisons
