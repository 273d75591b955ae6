#pragma once

#include <string>
#include <utility>
#include <vector>

#include "contact/case.h"
#include "rolling/rolling_contact.h"

namespace tricontact::rolling {

/// Friction and its bound on the line through the contact's centre along the rolling. Of a bed of
/// springs line loads [N/m], else tractions [Pa].
struct CentreLine {
    double distance = 0;    ///< rolled since the contact was at rest [m]; infinite: steady
    std::vector<double> x;  ///< from the contact's centre [m]
    std::vector<double> traction, bound;  ///< along x, on the substrate; mu times the normal one
};
/// Of a surface on a grid or a line.
CentreLine centre_line(const contact::Surface& surface, double friction_coefficient,
                       double distance);

/// What one model has to say about one case that rolls on.
struct RollingRun {
    std::string model;
    rolling::RollingHistory history;
    std::vector<CentreLine> lines;                   ///< from rest on; the last one is steady
    std::vector<rolling::RollingState> creep_curve;  ///< steady, by growing longitudinal creepage
};

/// A run of all models and where it came from.
struct RollingReport {
    contact::Case c;
    std::vector<RollingRun> runs;
    std::vector<std::pair<std::string, std::string>> files = {};  ///< text, path from the report
    std::string command = {};                                     ///< that makes it again
    std::string version = {};                                     ///< of the program
};

/// Ways in units of the contact's half length at which the transient is looked at.
inline constexpr double line_distances[] = {0, .25, .5, 1, 2, 4};

}  // namespace tricontact::rolling
