#pragma once

#include <optional>
#include <string>
#include <vector>

#include "walking/study/factorial_effects.h"
#include "walking/study/walk_sweep.h"

namespace tricontact::walking {

/// Which runs count in the effects: those of machines that do not rotate far. Wetter (2016),
/// section 4.2.1, excludes "solutions with high rotational amplitudes" without saying which.
struct ExclusionRule {
    std::string name;
    double largest_ratio = 0;  ///< of max |phi| to kappa4
    double largest_phi = 0;    ///< of max |phi|

    bool excludes(const WalkGroup& group) const;
};

/// The first one keeps as many runs as reproduce the numbers of the thesis; the others are looser
/// or stricter.
const std::vector<ExclusionRule>& exclusion_rules();

/// Groups of machines as a factorial experiment without its responses, and the place of each group
/// in it. Empty unless every axis of the machine is a list of two to four numbers, at least two
/// axes.
struct WalkFactorial {
    std::vector<Factor> factors;
    std::vector<std::size_t> places;  ///< one per group

    FactorialDesign design(const std::vector<WalkGroup>& groups, const ExclusionRule& rule,
                           double (*response)(const WalkOutcome& outcome)) const;
};
std::optional<WalkFactorial> factorial_of(const WalkSweep& sweep,
                                          const std::vector<WalkGroup>& groups,
                                          const std::vector<std::size_t>& axes);

/// Main effects side by side, a curve per factor: its levels rise from left to right.
report::Figure main_effects_figure(const std::string& id, const std::string& title,
                                   const std::string& response, const FactorialDesign& design);

}  // namespace tricontact::walking
