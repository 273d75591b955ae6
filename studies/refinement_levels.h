#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/models/model_kind.h"
#include "runs/options.h"
#include "studies/study_kind.h"

namespace tricontact::studies {

using contact::Case;
using contact::Say;

struct RefineOptions : runs::CommandOptions {
    std::string model = contact::models::fem;  ///< any that has a resolution
    int levels = 3;                            ///< 3 to 8
    int jobs = 1;                              ///< levels side by side, but for the finest
};

/// One level of a refinement: a case of its own, a point like one of a sweep.
struct Level {
    std::string name;  ///< of its folder
    std::string what;  ///< for people: "fem.size = 0.5 mm", "mdr.springs = 14141"
    StudyPoint point;
    double size = 0;  ///< of cells, elements, between springs [m]

    const Case& c() const { return point.contact(); }
};

/// What a refinement computes.
struct RefinementPlan {
    std::string key;  ///< "fem.size", "bem.spacing", "mdr.springs"
    std::vector<Level> levels;
    std::optional<Level> wide;  ///< the finest level but one on a larger block
    double wide_factor = 1.5;   ///< of its width and depth
};

/// From the case's own resolution, h 2^(-k/2) on level k, of springs so many more of them
/// (comparisons::level_keys). A finite
/// element case that gives an accuracy starts at twice the size that follows from it. All levels
/// pass the checks of case files. Throws InputError.
RefinementPlan plan_refinement(const RefineOptions& options, const Say& say);

}  // namespace tricontact::studies
