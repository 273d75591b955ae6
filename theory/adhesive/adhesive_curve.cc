#include "theory/adhesive/adhesive_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "contact/base/error.h"
#include "contact/base/root.h"
#include "theory/line_load.h"

namespace tricontact::theory {

namespace {

using contact::NormalControl;
using State = AdhesiveCurve::State;
using std::numbers::pi;

constexpr double least_radius = .02;  // over that of first touch
constexpr double node_ratio = 1.015;  // of neighbouring radii
constexpr double same_place = 1e-12;  // relative
constexpr int most_halvings = 12;     // of the least place, until both controls fall there

double value_of(const State& s, NormalControl::Kind kind) {
    return kind == NormalControl::Kind::force ? s.force : s.indentation;
}

}  // namespace

/// A motion under way.
struct AdhesiveCurve::Walk {
    NormalControl control;
    Motion motion;
    bool arrived = false;

    void move(const State& to) {
        motion.work +=
            (motion.state.force + to.force) / 2 * (to.indentation - motion.state.indentation);
        motion.state = to;
    }
    void arrive(const State& at) {
        move(at);
        arrived = true;
    }
};

AdhesiveCurve::AdhesiveCurve(Family family, double modulus, double work, double guess,
                             double largest_radius)
    : family_(std::move(family)), modulus_(modulus), work_(work), largest_(largest_radius) {
    branch_ = [family = family_, modulus, work](double radius) {
        const DiscContact disc = family(radius);
        return pulled(radius, disc, std::sqrt(2 * pi * radius * work / modulus) / disc.edge, work);
    };
    start(guess);
}

AdhesiveCurve::AdhesiveCurve(Branch branch, double modulus, double work, double range, double guess,
                             double largest_place)
    : branch_(std::move(branch)),
      modulus_(modulus),
      work_(work),
      largest_(largest_place),
      range_(range) {
    start(guess);
}

/// The least place lies before the bodies attract each other, where both controls fall.
void AdhesiveCurve::start(double guess) {
    if (!(modulus_ > 0) || !(work_ > 0) || !(guess > 0) || !(largest_ > 0))
        throw std::domain_error("AdhesiveCurve: modulus, work and radii must be positive");
    double touching = std::min(guess, largest_);
    while (at(touching).indentation > 0) touching /= 2;
    while (touching < largest_ && at(touching).indentation <= 0) touching *= 2;
    double first = least_radius * std::min(touching, largest_);
    for (int k = 0; k < most_halvings && at(first).indentation >= -range_; ++k) first /= 2;
    nodes_.push_back(at(first));
    begins_stable_ = range_ > 0 && nodes_.front().indentation >= -range_;
}

AdhesiveCurve::State AdhesiveCurve::held(double radius, const NormalControl& control) const {
    const DiscContact disc = family_(radius);
    const bool by_force = control.kind == Kind::force;
    State s = pulled(
        radius, disc,
        by_force ? (disc.force - control.value) / disc.stiffness : disc.indentation - control.value,
        work_);
    (by_force ? s.force : s.indentation) = control.value;
    return s;
}

/// The body pressed to d_0 and the punch pulled back by l.
State AdhesiveCurve::pulled(double radius, const DiscContact& disc, double l, double work) {
    return {.place = radius,
            .radius = radius,
            .reach = radius,
            .indentation = disc.indentation - l,
            .force = disc.force - disc.stiffness * l,
            .energy = disc.energy - l * (disc.force - disc.stiffness * l / 2),
            .attraction = -work * pi * radius * radius,
            .detached = l};
}

void AdhesiveCurve::extend() {
    const double last = nodes_.back().place;
    if (last >= largest_)
        throw contact::InputError(fmt::format(
            "adhesion: the contact reaches the rim of the indenter's profile at {:.6g} m; reduce "
            "the load or the work of adhesion, or enlarge the indenter",
            largest_));
    nodes_.push_back(at(std::min(node_ratio * last, largest_)));
}

const AdhesiveCurve::State& AdhesiveCurve::node(int k) {
    while (k >= static_cast<int>(nodes_.size())) extend();
    return nodes_[k];
}

AdhesiveCurve::State AdhesiveCurve::crossing(const State& from, const State& to, Kind kind,
                                             double level) const {
    const auto excess = [&](double place) { return value_of(at(place), kind) - level; };
    State found = at(contact::bracketed_root(excess, std::min(from.place, to.place),
                                             std::max(from.place, to.place)));
    // What is prescribed has no rounding of its own.
    (kind == Kind::force ? found.force : found.indentation) = level;
    return found;
}

/// Where the control is stationary between two radii: the root of its central difference, which is
/// off by the square of 1e-5; the end that is farther on where there is none.
AdhesiveCurve::State AdhesiveCurve::limit_point(double first, double last, Kind kind,
                                                int direction) const {
    constexpr double step = 1e-5;
    const auto slope = [&](double place) {
        return value_of(at(place * (1 + step)), kind) - value_of(at(place * (1 - step)), kind);
    };
    const double low = std::min(first, last), high = std::max(first, last);
    const double at_low = slope(low), at_high = slope(high);
    if ((at_low < 0) != (at_high < 0))
        return at(contact::bracketed_root(slope, low, high, at_low, at_high, 40));
    const State one = at(low), other = at(high);
    return direction * (value_of(one, kind) - value_of(other, kind)) > 0 ? one : other;
}

/// Out of contact the bodies meet at d = 0, where F = 0; with a range as far apart as that. Steep
/// tips are attracted bit by bit, without a jump.
void AdhesiveCurve::touch(Walk& walk) {
    const Kind kind = walk.control.kind;
    const double level = meets_at(kind);
    walk.motion.state = {};
    if (begins_stable_ && kind == Kind::indentation) {
        const State& first = node(0);
        walk.arrived = walk.control.value <= first.indentation;
        walk.motion.state = walk.arrived ? State{.indentation = walk.control.value} : first;
        return;
    }
    int k = 1;
    while (value_of(node(k), kind) < level) ++k;
    const State to = crossing(node(k - 1), node(k), kind, level);
    walk.motion.released -= stored(to);
    ++walk.motion.jumps;
    walk.motion.state = to;
    walk.arrived = walk.control.value == level;
}

void AdhesiveCurve::lose(Walk& walk) const {
    if (walk.control.kind == Kind::force)
        throw contact::InputError(fmt::format(
            "adhesion: the normal force {:.6g} N pulls the bodies apart; the contact holds {:.6g} "
            "N at most: pull less, or prescribe the indentation, which follows the contact to its "
            "end",
            walk.control.value, -walk.motion.state.force));
    if (!begins_stable_) {
        walk.motion.released += stored(walk.motion.state);
        ++walk.motion.jumps;
    }
    walk.motion.state = {.indentation = walk.control.value};
    walk.arrived = true;
}

/// To the next radius in that direction with the same control, from a state where it turns back.
void AdhesiveCurve::jump_from(Walk& walk, const State& limit, int next, int direction) {
    const Kind kind = walk.control.kind;
    const double level = value_of(limit, kind);
    State before = limit;
    for (int k = next;; k += direction) {
        if (k < 0) return lose(walk);
        const State now = node(k);
        if (direction * (value_of(now, kind) - level) > 0 && before.place != limit.place) {
            const State to = crossing(before, now, kind, level);
            const double by_force =
                kind == Kind::force ? level * (to.indentation - limit.indentation) : 0;
            walk.motion.released += stored(limit) - stored(to) + by_force;
            walk.motion.work += by_force;
            ++walk.motion.jumps;
            walk.motion.state = to;
            return;
        }
        before = now;
    }
}

/// Along the stable branch, on which the control grows with the radius, towards the target.
void AdhesiveCurve::go(Walk& walk, int direction) {
    const Kind kind = walk.control.kind;
    const auto forward = [&](const State& s) { return direction * value_of(s, kind); };
    const double goal = direction * walk.control.value;
    State last = walk.motion.state;
    int k = 0;
    while (node(k).place <= last.place * (1 + same_place)) ++k;
    if (direction < 0)
        for (--k; k >= 0 && nodes_[k].place >= last.place * (1 - same_place);) --k;
    for (;; k += direction) {
        if (k < 0) return lose(walk);
        const State here = walk.motion.state, next = node(k);
        if (forward(next) > forward(here)) {
            if (forward(next) >= goal)
                return walk.arrive(crossing(here, next, kind, walk.control.value));
            walk.move(next);
            last = here;
            continue;
        }
        const State limit = limit_point(last.place, next.place, kind, direction);
        if (forward(limit) >= goal)
            return walk.arrive(crossing(last, limit, kind, walk.control.value));
        walk.move(limit);
        return jump_from(walk, limit, k, direction);
    }
}

AdhesiveCurve::Motion AdhesiveCurve::follow(const State& from, const NormalControl& control) {
    Walk walk{control, {.state = from}};
    if (!(from.reach > 0)) {
        const bool is_apart = control.value < meets_at(control.kind);
        if (is_apart && control.kind == Kind::indentation)
            return {.state = {.indentation = control.value}};
        if (is_apart) lose(walk);
        touch(walk);
    }
    while (!walk.arrived) {
        const double value = value_of(walk.motion.state, control.kind);
        if (value == control.value) break;
        go(walk, value < control.value ? 1 : -1);
    }
    return walk.motion;
}

bool AdhesiveCurve::reaches(const NormalControl& control) {
    double least = 0;
    for (int k = 0;; ++k) {
        if (k == static_cast<int>(nodes_.size()) && nodes_.back().radius >= largest_) return false;
        const State& here = node(k);
        least = std::min(least, here.force);
        const bool is_beyond_pull_off = here.indentation > 0 && here.force > .9 * least;
        if (is_beyond_pull_off && value_of(here, control.kind) >= control.value) return true;
    }
}

int AdhesiveCurve::stable_states(const NormalControl& control) {
    reaches(control);
    int n = control.value < meets_at(control.kind);
    for (std::size_t k = 1; k < nodes_.size(); ++k)
        n += value_of(nodes_[k - 1], control.kind) <= control.value &&
             control.value < value_of(nodes_[k], control.kind);
    return n;
}

/// The state of least control that still touches: where the branch turns back, or the touch ends.
AdhesiveCurve::State AdhesiveCurve::least_in_touch(Kind kind) {
    std::size_t first = 0;
    while (!nodes_[first].touches()) ++first;
    std::size_t lowest = first;
    for (std::size_t k = first; k < nodes_.size(); ++k)
        if (value_of(nodes_[k], kind) < value_of(nodes_[lowest], kind)) lowest = k;
    if (lowest == 0) return nodes_.front();
    const State before = nodes_[lowest - 1], after = node(static_cast<int>(lowest) + 1);
    if (before.touches()) return limit_point(before.place, after.place, kind, -1);
    double apart = before.place, touching = nodes_[lowest].place;
    for (int k = 0; k < contact::root_bits; ++k) {
        const double middle = (apart + touching) / 2;
        (at(middle).touches() ? touching : apart) = middle;
    }
    const State meeting = at(touching), limit = limit_point(touching, after.place, kind, -1);
    return value_of(limit, kind) < value_of(meeting, kind) ? limit : meeting;
}

contact::PullOff AdhesiveCurve::pull_off() {
    if (!reaches({Kind::indentation, 0})) extend();  // throws
    const State pulled = least_in_touch(Kind::force);
    return {.force = -pulled.force,
            .radius = pulled.radius,
            .indentation = pulled.indentation,
            .last_indentation = least_in_touch(Kind::indentation).indentation};
}

AdhesiveCurve::Family half_space_contacts(const contact::AxisymmetricIndenter& body,
                                          double modulus) {
    return [&body, modulus](double a) {
        const double d = body.plane_profile(a);
        // Of the springs, E* (d - g)^2 dx; split where the profile has kinks.
        const LineMesh mesh(a, body.kinks(), 24);
        double energy = 0;
        for (int i = 0; i < mesh.size(); ++i) {
            const double pressed = d - body.plane_profile(mesh.positions()[i]);
            energy += mesh.weights()[i] * pressed * pressed;
        }
        return DiscContact{.indentation = d,
                           .force = modulus * body.pressed_area(a),
                           .energy = modulus * energy,
                           .stiffness = 2 * modulus * a};
    };
}

AdhesiveCurve half_space_curve(const contact::AxisymmetricIndenter& body, double modulus,
                               double work) {
    // Of the length w/E*, from where the search doubles.
    return {half_space_contacts(body, modulus), modulus, work, work / modulus,
            body.outer_radius() * (1 - 1e-6)};
}

}  // namespace tricontact::theory
