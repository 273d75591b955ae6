#pragma once

#include <algorithm>
#include <vector>

#include "contact/base/vector2.h"

namespace tricontact::contact {

/// Point of the edge of the disc of radius `bound` (Coulomb's friction disc) in the direction of
/// `t`, which is not zero.
inline Vector2 onto_edge(const Vector2& t, double bound) {
    const double factor = bound / norm(t);
    return {t[0] * factor, t[1] * factor};
}

/// Nearest point to `t` in that disc.
inline Vector2 project_on_disc(const Vector2& t, double bound) {
    return norm(t) <= bound ? t : onto_edge(t, bound);
}

/// Bounds that rise with the way s that a point slips in the step: min(bound, at_start + slope s).
struct Hardening {
    const std::vector<double>& at_start;  ///< per point [Pa], at most its bound
    double slope;                         ///< [Pa/m], > 0
};

/// The friction disc of a point whose radius grows with its slip s in the step,
///   |t| = at_start + slope |s|  until |t| = bound:
/// the traction is a function of t + s/alpha as under Coulomb's law, see TangentialSolver.
struct FrictionDisc {
    double at_start, bound;  ///< [Pa]
    double slope;            ///< [Pa/m]; 0: at_start = bound

    enum class Zone { stick, flow, slip };

    /// |t| of a point with |t + s/alpha| = `size` [Pa], alpha [m/Pa].
    double radius(double size, double alpha) const {
        if (size <= at_start) return size;
        const double gain = slope * alpha;
        return std::min(bound, (gain * size + at_start) / (gain + 1));
    }
    Zone zone(double size, double alpha) const {
        if (size <= at_start) return Zone::stick;
        return radius(size, alpha) < bound ? Zone::flow : Zone::slip;
    }
    /// What a point carries that moves, by the size of t + s/alpha [Pa].
    double least(double size, double alpha) const {
        return zone(size, alpha) == Zone::flow ? at_start : bound;
    }
    /// Where a traction of this size stands; the edge is not rounded away.
    Zone zone_of(double size) const {
        size *= 1 + 1e-12;
        return size >= bound ? Zone::slip : size >= at_start ? Zone::flow : Zone::stick;
    }
    /// t at the start of a Newton step that finds a point in the zone `now`, `before` the last one
    /// in `before`: what slips is on the edge, what begins to flow where y = t + s/alpha tells.
    Vector2 started(Zone now, Zone before, const Vector2& t, const Vector2& y, double alpha) const {
        if (now == Zone::slip) return onto_edge(y, bound);
        if (now == Zone::stick) return project_on_disc(t, at_start);
        const bool goes_on = before == Zone::flow && norm(t) >= at_start;
        return goes_on ? project_on_disc(t, bound) : project(y, alpha);
    }
    /// t of `y` = t + s/alpha.
    Vector2 project(const Vector2& y, double alpha) const {
        const double size = norm(y);
        return size <= at_start ? y : (radius(size, alpha) / size) * y;
    }
    /// d|t|/d|y| [-] of a point that flows, 0 where it slips.
    double rise(double size, double alpha) const {
        return zone(size, alpha) == Zone::flow ? slope * alpha / (slope * alpha + 1) : 0;
    }
    /// The integral of radius() over the size from 0 on [Pa^2].
    double potential(double size, double alpha) const {
        if (size <= at_start) return size * size / 2;
        double sum = at_start * at_start / 2;
        const double full =
            slope > 0 ? std::min(size, bound + (bound - at_start) / (slope * alpha)) : at_start;
        sum += (full - at_start) * (at_start + radius(full, alpha)) / 2;
        return sum + (size - full) * bound;
    }
};

}  // namespace tricontact::contact
