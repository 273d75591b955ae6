#pragma once

#include <string>
#include <vector>

#include "contact/case.h"

namespace tricontact::comparisons::tractive {

/// What a closed form says of the resistance that a relaxing substrate puts up to rolling.
struct ResistanceTheory {
    std::string name;  ///< "Hunter"
    std::string key;   ///< in JSON
    double ratio;      ///< resistance over normal force [-]
};

/// Those that apply to the case's body: slow rolling of any substrate that relaxes as one; of a
/// cylinder on the half-space of a standard solid Hunter's; of a round body that of MDR's springs.
/// None where nothing relaxes. Friction plays no part in them.
std::vector<ResistanceTheory> resistance_theories(const contact::Case& c);

}  // namespace tricontact::comparisons::tractive
