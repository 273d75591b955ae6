#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/assumptions/check_rig.h"
#include "experiments/design/design_input.h"

namespace tricontact::experiments {

/// A number of a rig and the limit that a design keeps it within.
struct Requirement {
    std::string name;    ///< of a criterion: "unit_shift_difference"; or "resolution"
    std::string symbol;  ///< "|U_max layer/U_max Hertz - 1|"
    std::string unit;    ///< SI, "1" of pure numbers
    std::string claim;   ///< the assumption; empty: the comparison
    Criterion::Relation relation = Criterion::Relation::at_most;
    double limit = 0;
    /// Of design.laws, the place of the law that this one is about.
    std::optional<std::size_t> law = {};

    /// Of a finding over its limit, or of the limit over what it is at least: met up to 1.
    double ratio(double finding) const;
    /// The inverse.
    double finding(double ratio) const;
    bool is_resolution() const { return claim.empty(); }
};

/// Those of the assumptions and criteria that the input names, in its order, then the resolution
/// and the laws of friction.
/// `report`: of the rig as the file has it. Throws contact::InputError at a name that the check of
/// this rig does not have, at one that has no number, and at a limit of zero.
std::vector<Requirement> requirements_of(const DesignInput& input, const RigReport& report);

/// The requirement's ratio in the report of another rig; NaN where its criterion is not told.
double ratio_in(const RigReport& report, const Requirement& requirement);

}  // namespace tricontact::experiments
