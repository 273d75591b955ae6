#pragma once

#include <string>
#include <vector>

#include "experiments/assumptions/assumption.h"
#include "experiments/assumptions/rig.h"

namespace tricontact::experiments {

/// "static shift".
const char* name_of(Measured measured);

/// What taking an assumption for granted does to the computed value of what a rig measures.
struct MeasuredEffect {
    std::string assumption;  ///< its name: "half_space"
    Measured measured{};
    /// Computed with the assumption over computed without it, minus 1. Standard error 0: unknown.
    Estimate relative;
    /// It is no more than this, to either side: `relative` is the largest magnitude, infinite where
    /// the contact might slide.
    bool is_bound = false;
};

/// Those that follow from the numbers of `assumptions`, in their order, of all that the rig
/// measures. Static shifts are those at coupling_tangential_ratio; of settled ones, what rolling
/// adds is an assumption of its own. An error of F_T or mu changes static shifts as in the contact
/// of Cattaneo and Mindlin under a constant F_N.
std::vector<MeasuredEffect> effects_on_measured(const Rig& rig,
                                                const std::vector<Assumption>& assumptions);

/// d ln U/d ln F_T of static_shift_ratio() at f = F_T/(mu F_N) in (0, 1); d ln U/d ln mu is 1 less
/// that.
double shift_sensitivity_to_force(double f);

}  // namespace tricontact::experiments
