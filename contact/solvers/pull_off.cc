#include "contact/solvers/pull_off.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/solvers/contact_region.h"

namespace tricontact::contact {

namespace {

// Steps of the depth are parts of the length at which the elastic energy of the contact equals that
// of its adhesion. JKR's sphere is 1.4 of these from where it carries nothing to its largest
// tension, and 1.8 to its last contact.
constexpr double steps_per_length = 8;
constexpr int most_pulls = 400, pull_bisections = 8;
constexpr double pull_probe = 1e-2;  // of that length, for the stiffness

NormalControl at_depth(double d) {
    return {NormalControl::Kind::indentation, d};
}

bool still_touches(const NormalSolution& s) {
    return std::ranges::any_of(s.share, [](double part) { return part > 0; });
}

/// Below this many points across, what lets go is that of a few points.
constexpr double fewest_across = 6;

/// The state of least force between three neighbours, by the parabola through them.
struct LeastForce {
    double indentation, force;
};
LeastForce least_force_of(const std::array<NormalSolution, 3>& s) {
    const double d0 = s[0].indentation, d1 = s[1].indentation, d2 = s[2].indentation;
    const double s01 = (s[1].force - s[0].force) / (d1 - d0);
    const double s12 = (s[2].force - s[1].force) / (d2 - d1);
    const double curvature = (s12 - s01) / (d2 - d0);
    if (!(curvature > 0)) return {d1, s[1].force};
    const double slope = s01 - curvature * (d0 + d1);  // F = .. + slope d + curvature d^2
    const double d = std::clamp(-slope / (2 * curvature), std::min(d0, d2), std::max(d0, d2));
    return {d, s[1].force + (d - d1) * (slope + curvature * (d + d1))};
}

}  // namespace

std::optional<LettingGo> pull_off(const AdhesiveNormal& solver, const ContactPoints& points,
                                  const std::vector<double>& height, const NormalControl& hardest) {
    const NormalSolution pressed = solver.settle(height, hardest, {});
    NormalSolution now = solver.settle(height, {NormalControl::Kind::force, 0}, pressed);
    const auto is_resolved = [&](double radius) {
        return 2 * radius >= fewest_across * points.spacing[0];
    };
    if (!still_touches(now) || !is_resolved(shared_radius(points, now.share))) return {};
    const double area = shared_area(points, now.share), work = solver.attraction().work();
    // F d of a contact as stiff as this, whose mean displacement under its tension is u.
    double pull = 0, reach = 0;
    for (std::size_t i = 0; i < now.tension.size(); ++i) pull += points.area[i] * now.tension[i];
    reach = std::max(now.length, work * area / pull);
    const NormalSolution aside =
        solver.settle(height, at_depth(now.indentation - pull_probe * reach), now);
    const double stiffness = (now.force - aside.force) / (now.indentation - aside.indentation);
    const double length = stiffness > 0 ? std::sqrt(work * area / stiffness) : reach;
    const double step = length / steps_per_length;

    LettingGo found{};
    std::array<NormalSolution, 3> lowest;
    NormalSolution before = now;
    int k = 0;
    for (; k < most_pulls; ++k) {
        NormalSolution next = solver.settle(height, at_depth(now.indentation - step), now);
        if (!still_touches(next)) break;
        const bool is_least = k > 0 && now.force <= before.force && now.force <= next.force;
        if (is_least && now.force < -found.force) {
            found.force = -now.force;
            lowest = {before, now, next};
        }
        before = std::move(now);
        now = std::move(next);
    }
    if (k == most_pulls) return {};
    // The last contact.
    double on = now.indentation, off = on - step;
    for (int i = 0; i < pull_bisections; ++i) {
        const double middle = (on + off) / 2;
        NormalSolution s = solver.settle(height, at_depth(middle), now);
        if (still_touches(s)) {
            if (s.force < now.force && s.force < -found.force && now.force <= -found.force) {
                found.force = -s.force;
                lowest = {now, s, s};
            }
            on = middle;
            now = std::move(s);
        } else {
            off = middle;
        }
    }
    found.last_indentation = on;
    const bool is_smooth =
        !lowest[1].tension.empty() && lowest[2].indentation != lowest[1].indentation;
    NormalSolution s;
    if (is_smooth) {
        s = solver.settle(height, at_depth(least_force_of(lowest).indentation), lowest[0]);
        found.force = std::max(-s.force, found.force);
    } else {  // the tension rises up to the last contact
        s = now.force <= -found.force || lowest[1].tension.empty() ? now : lowest[1];
        found.force = -s.force;
    }
    found.radius = shared_radius(points, s.share);
    found.indentation = s.indentation;
    if (!is_resolved(found.radius)) return {};
    return found;
}

}  // namespace tricontact::contact
