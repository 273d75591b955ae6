#pragma once

#include <optional>
#include <vector>

#include "contact/case.h"
#include "contact/history.h"

namespace tricontact::comparisons {

/// What a surface point does over the last rolling period (thesis figure 3.11).
enum class Zone {
    open,   ///< never in contact while the indenter is upright
    stick,  ///< always in contact, never at the friction bound
    slip,   ///< always in contact, at the friction bound at some instant
    zero    ///< in contact upright, but released at some instant: no traction can stay
};

/// The last snapshot with the indenter upright; null without snapshots.
const contact::Snapshot* last_upright(const contact::History& history);

/// The last snapshot taken at a phase [periods]; null if there is none.
const contact::Snapshot* snapshot_at(const contact::History& history, double phase);

/// Zone of each contact point, from all snapshots of the period that ends with `last_upright`.
/// In line layout the springs decide, under another law than Coulomb's by their own word, otherwise
/// the tractions. Empty without snapshots.
std::vector<Zone> zones(const contact::History& history, const contact::FrictionLaw& friction);

/// Half width c_sd [m] of what sticks throughout the period that ends with `last_upright`, of a
/// line contact (one row along x). Between the cells by what tau lacks to its least bound, which
/// vanishes like (c_sd^2 - x^2)^(1/2). Zero where nothing sticks; empty without snapshots.
std::optional<double> stick_half_width(const contact::History& history,
                                       const contact::FrictionLaw& friction);

/// Values along a line through the indenter's centre, upright, sorted by position.
struct CentreLine {
    std::vector<double> position;  ///< over the contact radius [-]
    std::vector<double> traction;  ///< tau_x over mu times a pressure [-]
    std::vector<Zone> zone;
};
enum class Axis { x, y };

/// What tractions are drawn over [Pa]: the model's own p0; under a conical tip, where that is
/// infinite or that of a cell, the mean pressure F_N/(pi a^2).
double drawn_pressure(const contact::Case& c, const contact::Scales& scales);
/// What friction carries there: "μ p_0" or "μ p_m", "τ(p_0)" of another law than Coulomb's.
std::string drawn_bound_symbol(const contact::Case& c);

/// Centre line of the last upright state, normalised by the model's own a and this `pressure`, p0
/// if it is left out. On an even grid the two middle rows are averaged. A line layout is
/// axisymmetric: the same for both axes.
CentreLine centre_line(const contact::History& history, const contact::FrictionLaw& friction,
                       Axis axis, std::optional<double> pressure = {});

/// A stretch of one zone along a centre line, ends half-way between points.
struct Stretch {
    Zone zone = Zone::open;
    double begin = 0, end = 0;  ///< over the contact radius [-]
};
std::vector<Stretch> stretches(const CentreLine& line);

/// What friction carries across the load at each point of a line, whose bounds are those of a
/// contact of revolution of this radius [m], under another law than Coulomb's [N/m].
std::vector<double> line_bounds(const contact::Surface& line, double radius);

/// w_lim = W/a at which the least of a model's pressures, moved back and forth by W along the
/// rolling direction, carry f_T: (1/F_N) ∫ min p(x - s) dA = f_T, the minimum over |s| <= W. The
/// pressures are those of the last upright state, of coupled contact those that friction left.
/// Empty unless 0 < f_T < 1, without rolling, under oscillating loads, on periodic surfaces and
/// without snapshots. O(h^2) in the size of the cells.
std::optional<double> own_amplitude_limit(const contact::Case& c, const contact::History& history);

}  // namespace tricontact::comparisons
