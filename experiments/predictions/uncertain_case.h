#pragma once

#include <string>
#include <vector>

#include "contact/case.h"
#include "experiments/records/experiment_evaluation.h"
#include "io/case/rig_file.h"

namespace tricontact::experiments {

/// A case as the rig sets it, F_T [N] and W [m] in place of their ratios, and its uncertain numbers
/// as they stand in it.
struct UncertainCase {
    contact::Case set;
    std::vector<CaseQuantity> quantities;  ///< in the order of the file

    std::vector<std::string> names() const;
};

/// `c` as it was read. `friction_limit` [N], `amplitude` [m]: what its ratios are of. Throws
/// contact::InputError, naming the place, for a number that the resolved case does not state, such
/// as a ratio of a layer's thickness.
UncertainCase uncertain_case(const contact::Case& c, double friction_limit, double amplitude,
                             const std::vector<io::UncertainKey>& uncertain);

/// The same by what friction carries on the half-space and the case's amplitude.
UncertainCase uncertain_case(const contact::Case& c,
                             const std::vector<io::UncertainKey>& uncertain);

/// The direction, of length one in standard errors, along which a result changes most that changes
/// by `changes` when a number grows by its error each: where a given change is most probable. Empty
/// if none of them changes it.
std::vector<double> steepest_direction(const std::vector<double>& changes,
                                       const statistics::Correlations::Matrix& correlation);

/// The case with its numbers off along a direction by as much as a normal variable is at
/// `deviations` standard deviations; beyond the largest value that a number can have they are
/// mirrored there.
contact::Case displaced(const UncertainCase& uncertain, const std::vector<double>& direction,
                        double deviations);

}  // namespace tricontact::experiments
