#include "contact/solvers/pull_off.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "contact/solvers/contact_region.h"

namespace tricontact::contact {

namespace {

// Steps of the depth are parts of the length at which the elastic energy of the contact equals that
// of its adhesion. JKR's sphere is 1.4 of these from where it carries nothing to its largest
// tension, and 1.8 to its last contact. Steps that lose the contact are halved.
constexpr double steps_per_length = 4, least_steps_per_length = 64;
constexpr int most_pulls = 400;
constexpr double order_of_zone = .9;  // of errors, in the width of a zone without a range
constexpr double pull_probe = 1e-2;   // of that length, for the stiffness

NormalControl at_depth(double d) {
    return {NormalControl::Kind::indentation, d};
}

bool still_touches(const NormalSolution& s) {
    return std::ranges::any_of(s.share, [](double part) { return part > 0; });
}

/// Below this many points across, what lets go is that of a few points.
constexpr double fewest_across = 6;

struct PulledState {
    double indentation, force, radius;
};

/// Where the parabola y(x) through three points has its least value; the middle one's place where
/// that is none.
double least_of(const std::array<double, 3>& x, const std::array<double, 3>& y) {
    const double s01 = (y[1] - y[0]) / (x[1] - x[0]), s12 = (y[2] - y[1]) / (x[2] - x[1]);
    const double curvature = (s12 - s01) / (x[2] - x[0]);
    if (!(curvature > 0)) return x[1];
    const auto [low, high] = std::ranges::minmax(x);
    return std::clamp((x[0] + x[1]) / 2 - s01 / (2 * curvature), low, high);
}

/// A contact on its way off: all states that hold, and those before and at the largest tension.
class Pulling {
  public:
    Pulling(const AdhesiveNormal& solver, const ContactPoints& points,
            const std::vector<double>& height)
        : solver_(solver), points_(points), height_(height) {}

    /// Pulls from this state, whose depth has that length, until nothing holds. False if it holds
    /// on.
    bool go(NormalSolution now, double length) {
        double step = length / steps_per_length;
        add(now);
        for (int k = 0; k < most_pulls; ++k) {
            if (step < length / least_steps_per_length) return true;
            std::optional<NormalSolution> next = at(now.indentation - step, now);
            if (next) {
                if (next->force < least_force_) {
                    least_force_ = next->force;
                    before_least_ = std::move(now);
                }
                now = std::move(*next);
                add(now);
                continue;
            }
            lost_ = now.indentation - step;
            step /= 2;
        }
        return false;
    }

    /// The state of least force: between those that were found, or the last one.
    PullOff found() const {
        const auto least = std::ranges::min_element(states_, {}, &PulledState::force);
        PulledState there = *least;
        if (least != states_.begin() && least + 1 != states_.end()) {
            const double d =
                least_of({least[-1].indentation, least->indentation, least[1].indentation},
                         {least[-1].force, least->force, least[1].force});
            if (const auto s = at(d, before_least_); s && s->force < there.force)
                there = state_of(*s);
        }
        return {-there.force, there.radius, there.indentation, last()};
    }

  private:
    PulledState state_of(const NormalSolution& s) const {
        return {s.indentation, s.force, shared_radius(points_, s.share)};
    }
    void add(const NormalSolution& s) { states_.push_back(state_of(s)); }

    /// Null where nothing holds any more. Where a branch ends iterates converge slowly: there
    /// it is not to be told from its end.
    std::optional<NormalSolution> at(double d, const NormalSolution& before) const {
        try {
            NormalSolution s = solver_.settle(height_, at_depth(d), before);
            if (still_touches(s)) return s;
        } catch (const NotConverged&) {
        }
        return {};
    }

    /// d has its least value over the radius where the branch ends: by the last three states.
    double last() const {
        const std::size_t n = states_.size();
        const double held = states_.back().indentation;
        if (n < 3) return held;
        const auto* const s = &states_[n - 3];
        const std::array a{s[0].radius, s[1].radius, s[2].radius},
            d{s[0].indentation, s[1].indentation, s[2].indentation};
        if (!(a[0] > a[1] && a[1] > a[2])) return held;
        const double s01 = (d[1] - d[0]) / (a[1] - a[0]), s12 = (d[2] - d[1]) / (a[2] - a[1]);
        const double curvature = (s12 - s01) / (a[2] - a[0]);
        if (!(curvature > 0)) return held;
        const double end = (a[0] + a[1]) / 2 - s01 / (2 * curvature);
        const double least = d[2] + (end - a[2]) * (s12 + curvature * (end - a[1]));
        return std::clamp(least, lost_, held);
    }

    const AdhesiveNormal& solver_;
    const ContactPoints& points_;
    const std::vector<double>& height_;
    std::vector<PulledState> states_;
    NormalSolution before_least_;
    double least_force_ = infinity, lost_ = -infinity;
};

}  // namespace

std::optional<PullOff> pull_off(const AdhesiveNormal& solver, const ContactPoints& points,
                                const std::vector<double>& height, const NormalControl& hardest) {
    const NormalSolution pressed = solver.settle(height, hardest, {});
    NormalSolution now = solver.settle(height, {NormalControl::Kind::force, 0}, pressed);
    const auto is_resolved = [&](double radius) {
        return 2 * radius >= fewest_across * points.spacing[0];
    };
    if (!still_touches(now) || !is_resolved(shared_radius(points, now.share))) return {};
    if (const CellAdhesion* const cells = solver.by_cell()) {
        const PullOff found = cells->pull(height, now);
        if (!is_resolved(found.radius)) return {};
        return found;
    }
    const double area = shared_area(points, now.share), work = solver.attraction().work();
    // F d of a contact as stiff as this, whose mean displacement under its tension is u.
    double pull = 0, reach = 0;
    for (std::size_t i = 0; i < now.tension.size(); ++i) pull += points.area[i] * now.tension[i];
    reach = std::max(now.length, work * area / pull);
    const NormalSolution aside =
        solver.settle(height, at_depth(now.indentation - pull_probe * reach), now);
    const double stiffness = (now.force - aside.force) / (now.indentation - aside.indentation);
    const double length = stiffness > 0 ? std::sqrt(work * area / stiffness) : reach;
    Pulling pulling(solver, points, height);
    if (!pulling.go(std::move(now), length)) return {};
    const PullOff found = pulling.found();
    if (!is_resolved(found.radius)) return {};
    return found;
}

// A zone of the width rho at the edge of a disc is longer outside than inside: its energy is that
// of a line, and adds to w what goes with rho/a. Measured on 10 to 40 points in (pi w R^2/K)^(1/3):
// forces of JKR's sphere too large by 1.45, 2.8, 4.8 % at rho/a = 0.13, 0.26, 0.52, about the power
// 0.9. Zones of three points follow that to 0.1 %; of two, they are held by single ones.
std::optional<PullOff> pull_off_without_range(const AdhesiveNormal& narrow,
                                              const AdhesiveNormal& wide,
                                              const ContactPoints& points,
                                              const std::vector<double>& height,
                                              const NormalControl& hardest) {
    static const double share = 1 / (std::pow(wide_zone / narrow_zone, order_of_zone) - 1);
    const auto fine = pull_off(narrow, points, height, hardest),
               coarse = pull_off(wide, points, height, hardest);
    if (!fine || !coarse) return {};
    const auto limit = [&](double PullOff::*value) {
        return (*fine).*value + share * ((*fine).*value - (*coarse).*value);
    };
    return PullOff{limit(&PullOff::force), limit(&PullOff::radius), limit(&PullOff::indentation),
                   limit(&PullOff::last_indentation)};
}

}  // namespace tricontact::contact
