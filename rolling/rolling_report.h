#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "contact/case.h"
#include "rolling/rolling_contact.h"
#include "rolling/steady_error.h"

namespace tricontact::rolling {

/// Friction and its bound on the line through the contact's centre along the rolling. Of a bed of
/// springs line loads [N/m], else tractions [Pa].
struct CentreLine {
    double distance = 0;    ///< rolled since the contact was at rest [m]; infinite: steady
    std::vector<double> x;  ///< from the contact's centre [m]
    std::vector<double> traction, bound;  ///< along x, on the substrate; what friction carries
};
/// Of the surface of a state, on a grid or a line.
CentreLine centre_line(const contact::Surface& surface, const contact::Friction& friction,
                       const RollingState& state);

/// What one model has to say about one case that rolls on.
struct RollingRun {
    std::string model;
    RollingHistory history;
    std::vector<CentreLine> lines;          ///< from rest on; the last one is steady
    std::vector<RollingState> creep_curve;  ///< steady, by growing longitudinal creepage
    std::optional<SteadyError> error = {};  ///< of the steady state; empty: not asked for
    /// Of finite bodies: how much what a cell displaces varies within the contact by where the cell
    /// is, over what it displaces itself [-]; empty: not known, or not at all.
    std::optional<double> variation = {};
};

/// A run of all models and where it came from.
struct RollingReport {
    contact::Case c;
    std::vector<RollingRun> runs;
    std::vector<std::pair<std::string, std::string>> files = {};  ///< text, path from the report
    std::string version = {};                                     ///< of the program
};

/// Ways in units of the contact's half length at which the transient is looked at.
inline constexpr double line_distances[] = {0, .25, .5, 1, 2, 4};

/// Friction follows from the steady state: by the speed of slip or by the temperature.
bool friction_changes(const contact::Case& c);

/// What friction carries of a state in all, F_lim [N]: mu F_N of Coulomb's law.
double friction_limit(const RollingState& state, const contact::Friction& friction);
/// F_x/F_lim of a state.
double force_ratio(const RollingState& state, const contact::Friction& friction);

/// |What friction and material dissipate - creepage . force - spin . moment - resistance| over what
/// mu F_N works on the sliding that creepage and spin prescribe, and the resistance: zero in a
/// steady state. Empty where nothing creeps or resists.
std::optional<double> energy_error(const RollingState& steady);

/// Longitudinal creepage of one state of the run's curve at a force ratio, by linear interpolation
/// of xi over (1 - |f|)^(1/3), in which creep curves are nearly straight; empty beyond the curve.
std::optional<double> creepage_at(const RollingRun& run, const contact::Friction& friction,
                                  double ratio);

/// Ways over the half length until the transient has come to within 1 % of the steady state, in
/// what is not prescribed along x: creepage under a force, else force; empty if it has not, or
/// where that is 0.
std::optional<double> steady_after(const RollingReport& report, const RollingRun& run);

/// The creepage along x is prescribed, the force follows.
inline bool by_creepage(const contact::Case& c) {
    return c.tractive_rolling->longitudinal_creepage.has_value();
}

/// The sign of F_x and xi along the creep curve: -1 where the roller is driven, not braked.
double drive_sign(const contact::Case& c);

/// Nothing but the longitudinal creepage or force drives the contact: what closed forms assume.
inline bool straight(const contact::Case& c) {
    return c.tractive_rolling->spin == 0 && c.tractive_rolling->lateral_creepage.value_or(0) == 0;
}

/// By springs, and by boundary elements on the half-space; null if the case has no such model.
const RollingRun* run_of_springs(const RollingReport& report);
const RollingRun* run_of_half_space(const RollingReport& report);

}  // namespace tricontact::rolling
