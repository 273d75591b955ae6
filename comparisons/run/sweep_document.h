#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "comparisons/quantities/results.h"
#include "report/document.h"
#include "report/format.h"

namespace tricontact::comparisons {

/// What a sweep varied and found.
struct Sweep {
    struct Axis {
        std::string key;   ///< of the case: "substrate.thickness"
        std::string unit;  ///< SI unit of its values; empty: none, or words
        bool logarithmic = false;
    };
    struct Point {
        std::vector<report::Cell> values;  ///< one per axis, SI unit
        std::string model;
        int level = 0;                          ///< of refinement
        std::optional<std::string> error = {};  ///< of a point that failed
        Results results = {};
        std::string surface = {};  ///< its file for ParaView, from the report; empty: none
    };
    std::string title;
    std::vector<std::pair<std::string, std::string>> settings;  ///< name, value with unit
    int levels = 1;                                             ///< of refinement
    std::vector<Axis> axes;
    std::vector<Point> points;  ///< in the order of the study
};

/// A sweep as it is, without theory: how many points failed, shook down, ratcheted; shifts over
/// each axis of numbers; all points as a table while they are few. Files, command and version are
/// the caller's.
report::Document sweep_document(const Sweep& sweep);

// Parts of it.

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

/// Fretting maps of closed cycles of paths: the regime over the first two axes of numbers that the
/// sweep varies, one map per model and values of the others, with the boundaries between them.
std::vector<report::Figure> regime_maps(const Sweep& sweep, const std::vector<SweepScale>& scales);

/// The figure with which the report opens: of the first shift that a key moves, over the key that
/// moves it most. Empty: nothing moves.
std::optional<report::Figure> opening_figure(const std::vector<report::DocumentSection>& sections);

}  // namespace tricontact::comparisons
