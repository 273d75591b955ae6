#pragma once

#include <string>
#include <vector>

#include "contact/model_makers.h"
#include "experiments/identification/estimation/identification.h"
#include "experiments/identification/identification_reader.h"

namespace tricontact::experiments {

/// A range of the attraction, which was found to have none, tried on the same rows.
struct TriedRange {
    double range = 0;           ///< [m]
    double tabor = 0;           ///< Tabor's parameter of it [-]
    double work = 0;            ///< w that is best then [J/m^2]
    double sum_of_squares = 0;  ///< at the best parameters, over the same errors
    bool is_excluded = false;   ///< the sum is beyond that of the parameters' intervals
    bool is_better = false;     ///< it is as much below that without a range
};

/// Ranges by Maugis' theory of a contact on the half-space whose work of adhesion was found by
/// Johnson, Kendall and Roberts', all parameters searched again: increasing, from where the range
/// is hardly felt to where the attraction hardly deforms the bodies. Empty where there is no such
/// contact.
std::vector<TriedRange> excluded_ranges(const IdentificationInput& input, const std::string& model,
                                        const Identification& found,
                                        const contact::ModelRunner& runner);

}  // namespace tricontact::experiments
