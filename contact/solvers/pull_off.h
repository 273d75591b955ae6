#pragma once

#include <optional>
#include <vector>

#include "contact/solvers/adhesive_normal.h"

namespace tricontact::contact {

/// A contact that lets go.
struct LettingGo {
    double force;             ///< the largest tension [N]
    double radius;            ///< under it [m]
    double indentation;       ///< under it [m]
    double last_indentation;  ///< of the last contact [m]
};

/// Where a contact that is pulled slowly lets go, after it was pressed by `hardest`; null where
/// that does not hold by itself, without a force, or is fewer than six points across under the
/// largest tension: its force is that of single points. Heights as those of NormalSolver. Throws
/// NotConverged, InputError.
std::optional<LettingGo> pull_off(const AdhesiveNormal& solver, const ContactPoints& points,
                                  const std::vector<double>& height, const NormalControl& hardest);

}  // namespace tricontact::contact
