#pragma once

#include <functional>
#include <string>
#include <vector>

#include "contact/case.h"

namespace tricontact::rolling {

/// What creepages are shown in [-]: mu a/R, for bodies of revolution of any profile mu d/a. The
/// same for paraboloids. Under another law than Coulomb's mu is F_lim/F_N on the half-space.
double creepage_unit(const contact::Case& c);

/// A closed form of the creep under a force along the rolling, no force or creepage across, no
/// spin.
struct CreepTheory {
    std::string name;                                    ///< "Vermeulen and Johnson"
    std::string key;                                     ///< in JSON and CSV
    std::function<double(double creepage)> force_ratio;  ///< F_x/F_lim of xi
    std::function<double(double force_ratio)> creepage;  ///< its inverse, force ratio in (-1, 1)
};

/// Those that apply to the case's body on a half-space. Under Coulomb's law: Carter's of a
/// cylinder; of a body that touches in a circle those of one stiffness (theory/creep_law.h) and,
/// with nu in [0, 1/2], Kalker's linear one; of an ellipsoid along the axes the latter and its
/// cubic law, up to axes of 10. Under a shear strength alone Carter's problem of a cylinder, MDR's
/// springs under a round body; of all laws Kalker's linear theory. None for other bodies, where the
/// substrate relaxes, and of dissimilar cylinders that roll freely.
std::vector<CreepTheory> creep_theories(const contact::Case& c);

/// MDR's creepage over that of three dimensions by the thesis, 4 (2 - nu)/(4 - 3 nu) (2.2.31).
double thesis_creep_ratio(const contact::Case& c);
/// Whether that ratio is about the case: a round body on uncoupled, elastic half-spaces, driven
/// along the rolling without spin.
bool has_thesis_creep_ratio(const contact::Case& c);

/// A number that a closed form has for the case.
struct ClosedForm {
    std::string name;  ///< "Bentall and Johnson, all sticks"
    std::string key;   ///< in JSON
    double value;      ///< [-]
};

/// What dissimilar elastic cylinders creep without any tangential force, xi: the bounds of much and
/// of little friction; none for other cases.
std::vector<ClosedForm> free_creepages(const contact::Case& c);

/// The resistance that a relaxing substrate puts up to rolling, over the normal force, by the forms
/// that apply to the case's body: slow rolling of any substrate that relaxes as one; of a cylinder
/// on the half-space of a standard solid Hunter's; of a round body that of MDR's springs. None
/// where nothing relaxes. Friction plays no part in them.
std::vector<ClosedForm> resistance_theories(const contact::Case& c);

}  // namespace tricontact::rolling
