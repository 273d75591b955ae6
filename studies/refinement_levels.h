#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/models/model_kind.h"
#include "runs/options.h"

namespace tricontact::studies {

using contact::Case;
using contact::Say;

struct RefineOptions : runs::CommandOptions {
    std::string model = contact::models::fem;  ///< or bem-layer, bem
    int levels = 3;                            ///< 3 to 8
};

/// One level of a refinement: a case of its own.
struct Level {
    std::string name;  ///< of its folder
    std::string what;  ///< for people: "fem.size = 0.5 mm"
    Case c;
    std::string resolved;  ///< text of the case
    double size = 0;       ///< [m]
};

/// What a refinement computes.
struct RefinementPlan {
    std::string key;  ///< "fem.size", "bem.spacing"
    std::vector<Level> levels;
    std::optional<Level> wide;  ///< the finest level but one on a larger block
    double wide_factor = 1.5;   ///< of its width and depth
};

/// From the case's own resolution, h 2^(-k/2) on level k, elements growing outwards by
/// growth^(2^(-k/2)) so that the whole mesh is refined. A finite element case that gives an
/// accuracy starts at twice the size that follows from it. All levels pass the checks of case
/// files. Throws InputError.
RefinementPlan plan_refinement(const RefineOptions& options, const Say& say);

}  // namespace tricontact::studies
