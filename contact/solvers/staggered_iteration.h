#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "contact/friction/friction_law.h"
#include "contact/solvers/control.h"

namespace tricontact::contact {

/// What normal and then tangential contact made of a height of the indenter.
struct StaggeredIterate {
    std::vector<double> height;  ///< over what friction moves down now [m]
    double residual;             ///< what that changed under the indenter, over the indentation [-]
    bool touches = true;
};

struct Staggering {
    std::string who, where;  ///< for the message: "bem", " at phase 1"
    double tolerance;        ///< on the residual
    /// Tangential contact is solved to this part of the gap that the last iteration left, so that
    /// its error does not show in the next one. 0: always to its own tolerance.
    double of_gap = .1;
};

/// Normal and tangential contact one after the other (Panagiotopoulos 1975), Anderson-accelerated
/// (see FixedPoint), until what the friction does to the gap no longer changes. `contact` solves
/// both, the tangential one to `looseness` >= 1 times its tolerance, in the end 1. Throws
/// NotConverged.
void stagger(const Staggering& settings, std::vector<double> height,
             const std::function<StaggeredIterate(const std::vector<double>& height,
                                                  double looseness)>& contact);

/// What is prescribed, ratios as the forces that they are of what friction carries in all.
std::array<TangentialControl, 2> without_ratios(std::array<TangentialControl, 2> control,
                                                const FrictionLaw& friction,
                                                const FrictionLaw::Total& total);

}  // namespace tricontact::contact
