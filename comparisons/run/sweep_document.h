#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "comparisons/quantities/results.h"
#include "report/document.h"

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

}  // namespace tricontact::comparisons
