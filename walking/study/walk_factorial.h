#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "report/document.h"
#include "walking/study/walk_sweep.h"

namespace tricontact::walking {

/// What an experiment varies, and to which values.
struct Factor {
    std::string name;
    std::vector<double> levels;  ///< at least two
};

/// A full factorial experiment: every combination of the levels once.
struct FactorialDesign {
    std::vector<Factor> factors;
    std::vector<double> response;  ///< the last factor fastest; NaN: excluded

    /// Level of a factor in a combination.
    std::size_t level(std::size_t combination, std::size_t factor) const;
    /// Combinations that were not excluded.
    std::vector<std::size_t> kept() const;
};

/// Means of the response over all combinations that share a level of a factor. Wetter (2016),
/// appendix A.2, eq. A.2.2.
struct MainEffect {
    std::vector<report::WithError>
        means;           ///< one per level; errors from the scatter within it, 95 %
    std::vector<int> n;  ///< combinations that were not excluded
};

/// How much two factors together differ from the sum of what they do alone.
struct Interaction {
    std::size_t first = 0, second = 0;  ///< factors
    std::vector<report::WithError>
        effects;       ///< one per pair of levels, those of the second fastest; 95 %
    double share = 0;  ///< of the response's variance
};

/// response = mean + sum of main parts + sum of parts of pairs + rest, by least squares; the parts
/// of a factor sum to zero over its levels. The rest, interactions of three and more factors and
/// noise, estimates the errors. Montgomery (2012), Design and Analysis of Experiments, sections 5.4
/// and 6.5.
struct VarianceAnalysis {
    std::vector<double> main_shares;  ///< of the variance, that the fit loses without this factor
    std::vector<Interaction> interactions;
    double explained_by_factors = 0;  ///< share of the variance, by the parts of factors alone
    double explained_by_pairs = 0;    ///< by both kinds of parts
};

/// One per factor; means of levels without combinations are NaN.
std::vector<MainEffect> main_effects(const FactorialDesign& design);

/// Shares add up to those explained where nothing is excluded. Throws std::invalid_argument for
/// fewer combinations than parts, contact::NotConverged if some pair of levels is
/// excluded altogether.
VarianceAnalysis variance_analysis(const FactorialDesign& design);

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
