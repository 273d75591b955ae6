#pragma once

#include <vector>

#include "walking/machine/spot.h"

namespace tricontact::walking {

/// Contact spots as rounded tips: each is a bed of independent springs by the method of
/// dimensionality reduction (Popov and Hess 2015), pressed with the plane profile s^2/R, so that
/// it slips in part. The springs belong to the body, whose spots are the elastic ones.
///
/// k_z = E* D_c and k_x = G* D_c of Wetter (2016), eq. 4.1.7, are the stiffnesses of the bed at
/// rest: D_c is the contact's diameter under an equal share of the weight, d its indentation.
struct Bed {
    double radius = 0;  ///< R of the tips, in units of b, >= 0
    int springs = 0;    ///< per spot, >= 1
    double width = 3;   ///< of the bed over D_c; a tip ends there. Enough for 9 d upright

    bool operator==(const Bed&) const = default;
};

/// Indentation d at rest under `load` > 0, the force on a spot over k_z b; in units of b. Hertz:
/// F = 4/3 E* sqrt(R) d^(3/2) = 2/3 k_z d.
double resting_indentation(double load);

/// Springs of a spot with its bed, from left to right; `load` as above, of a spot under an equal
/// share of the weight.
std::vector<Spot> bed_springs(const Bed& bed, const Spot& spot, double load);

}  // namespace tricontact::walking
