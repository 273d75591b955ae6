#pragma once

#include <optional>
#include <vector>

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
/// In line layout the springs decide, otherwise the tractions. Empty without snapshots.
std::vector<Zone> zones(const contact::History& history, double friction_coefficient);

/// Half width c_sd [m] of what sticks throughout the period that ends with `last_upright`, of a
/// line contact (one row along x). Between the cells by what tau lacks to its least bound, which
/// vanishes like (c_sd^2 - x^2)^(1/2). Zero where nothing sticks; empty without snapshots.
std::optional<double> stick_half_width(const contact::History& history,
                                       double friction_coefficient);

/// Values along a line through the indenter's centre, upright, sorted by position.
struct CentreLine {
    std::vector<double> position;  ///< over the contact radius [-]
    std::vector<double> traction;  ///< tau_x / (mu p0) [-]
    std::vector<double> bound;     ///< p / p0 [-]
    std::vector<Zone> zone;
};
enum class Axis { x, y };

/// Centre line of the last upright state, normalised by the model's own a and p0. On an even grid
/// the two middle rows are averaged. A line layout is axisymmetric: the same for both axes.
CentreLine centre_line(const contact::History& history, double friction_coefficient, Axis axis);

/// A stretch of one zone along a centre line, ends half-way between points.
struct Stretch {
    Zone zone = Zone::open;
    double begin = 0, end = 0;  ///< over the contact radius [-]
};
std::vector<Stretch> stretches(const CentreLine& line);

}  // namespace tricontact::comparisons
