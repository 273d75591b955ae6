#pragma once

#include <cmath>
#include <vector>

#include "tests/random/random_rig.h"

namespace tricontact {

inline constexpr int n_rows = 40;  // of a recorded loop

inline double log_between(Random& random, double low, double high) {
    return std::exp(between(random, {std::log(low), std::log(high)}));
}

struct TrueLoop {
    double energy = 0, friction = 0, ratio = 0;  // ratio: over 4 F U of the contact
    bool slides = false;
};

/// What one cycle of the drive does.
struct DrivenLoop {
    std::vector<double> shifts, forces;  // of the drive [m, N], a row each
    TrueLoop truth;
};

}  // namespace tricontact
