#pragma once

#include <optional>
#include <vector>

#include "contact/base/pull_off.h"
#include "contact/solvers/adhesive_normal.h"

namespace tricontact::contact {

/// Where a contact that is pulled slowly lets go, after it was pressed by `hardest`; null where
/// that does not hold by itself, without a force, or is fewer than six points across under the
/// largest tension: its force is that of single points. Heights as those of NormalSolver. Throws
/// NotConverged, InputError.
std::optional<PullOff> pull_off(const AdhesiveNormal& solver, const ContactPoints& points,
                                const std::vector<double>& height, const NormalControl& hardest);

/// The same of a law without a range, in the limit of many points: from zones of tension over 3
/// and 6 of them. Errors go with the zone's width over the radius to the power 0.9.
std::optional<PullOff> pull_off_without_range(const AdhesiveNormal& narrow,
                                              const AdhesiveNormal& wide,
                                              const ContactPoints& points,
                                              const std::vector<double>& height,
                                              const NormalControl& hardest);
inline constexpr double narrow_zone = 3, wide_zone = 6;  ///< [points]

}  // namespace tricontact::contact
