#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "contact/case.h"
#include "rolling/rolling_contact.h"

namespace tricontact::rolling {

/// What cells, or springs, leave in the numbers of a steady state: those beside the same on cells
/// of twice and four times the size, with Roache's factor (comparisons::NumericalError; the steps
/// from rest are cells, too). Keys as in summary.json, SI units.
struct SteadyError {
    std::map<std::string, double> half_widths = {};
    std::vector<std::string> exact = {};  ///< what the case prescribes
    std::string why_none = {};            ///< coarser cells do not come to a steady state: why

    std::optional<double> of(const std::string& key) const;
};

/// A run on each of three sizes of cells; without the coarsest, differences count three times.
/// `tolerance` [-] of the solver: ten times of that is the least. `cell`: their size [m], half of
/// which no edge of a zone is known better.
SteadyError steady_error(const contact::Case& c, const std::string& model,
                         const RollingState& steady, const RollingState& coarser,
                         const std::optional<RollingState>& coarsest, double tolerance,
                         double cell);

}  // namespace tricontact::rolling
