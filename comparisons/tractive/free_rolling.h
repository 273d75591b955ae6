#pragma once

#include <string>
#include <vector>

#include "contact/case.h"

namespace tricontact::comparisons::tractive {

/// What dissimilar bodies creep without any tangential force.
struct FreeCreepage {
    std::string name;  ///< "Bentall and Johnson, all sticks"
    std::string key;   ///< in JSON
    double creepage;   ///< xi [-]
};

/// Of dissimilar elastic cylinders that roll freely the bounds of much and of little friction; none
/// for other cases.
std::vector<FreeCreepage> free_creepages(const contact::Case& c);

}  // namespace tricontact::comparisons::tractive
