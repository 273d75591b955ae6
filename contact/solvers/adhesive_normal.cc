#include "contact/solvers/adhesive_normal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "contact/compliances/radial_points.h"
#include "contact/solvers/fixed_point.h"

// p = q - s: q >= 0 where the surfaces touch, s = sigma(g) >= 0 all over. For a given s the contact
// is that of surfaces which do not attract each other,
//
//   g = A q + (h - A s) - d >= 0,   q >= 0,   q g = 0,   sum q a = F_N + sum s a,
//
// with heights that the tension lowers; NormalSolver solves it. The gap then gives the next s. More
// tension means smaller gaps and those more tension: from a state of the last step the iterates
// fall (as the indenter is withdrawn) or rise (as it is pressed) to the state next to it, which is
// the one that a slow change reaches. Where that state ends (a fold), they go on to the next one,
// far away: the contact jumps. Near a fold they converge slowly and are combined (FixedPoint).

namespace tricontact::contact {

namespace {

constexpr int max_tensions = 3000;
// Iterates that are taken as they are, and then combined as long as that helps: where there is no
// state nearby combinations lead nowhere, and the iterates themselves have to find the way.
constexpr int least_simple = 6, most_simple = 100, most_combined = 12;
constexpr double combining_helps = .3, lost = 2;
constexpr int most_varied = 300;  // iterates with widths of their own
// Residuals from which on widths stay, and from which on they change so little that iterates may be
// combined. Widths of a front that has moved on by a cell since pin it there, by a percent of w.
constexpr double widths_settled = 1e-5, widths_follow = 1e-3;
constexpr double roughest_press = 1e-3, of_residual = .05;

/// A crack whose faces attract each other by s at the distances t from the contact has, further
/// off, the stresses of one that ends at 2 int s t^(1/2) dt/int s t^(-1/2) dt. Of s = s_0 (1 -
/// (t/rho)^3)^2 that is this part of int s dt/s_0 (Barenblatt 1962, Adv. Appl. Mech. 7, 55).
constexpr double to_the_tip = .7;

}  // namespace

struct AdhesiveNormal::Iterate {
    std::vector<double> tension, width, lowered;  // s, of the gap, A s
    std::vector<double> gap, next;                // by q, and the tension that it gives
    NormalSolution touch;                         // q; its indentation is d
    double residual = infinity;                   // of the tension, by what it displaces
};

/// From an iterate to the next one: some as they are, then combined ones while those help. What
/// they left in vain is gone back to, and followed for twice as long.
class AdhesiveNormal::Way {
  public:
    std::vector<double> next(const Iterate& now, bool may_combine) {
        if (!combines_) {
            const bool falls = now.residual < last_;
            last_ = now.residual;
            if (++n_ >= n_simple_ && falls && may_combine) begin(now);
            return now.next;
        }
        least_ = std::min(least_, now.residual);
        if (now.residual > lost * first_ ||
            (++n_ >= most_combined && least_ > combining_helps * first_))
            return give_up();
        if (n_ >= most_combined) {
            first_ = least_;
            n_ = 0;
        }
        return accelerated_.next(now.tension, now.next, now.residual);
    }

  private:
    void begin(const Iterate& now) {
        combines_ = true;
        n_ = 0;
        first_ = least_ = now.residual;
        before_ = now.next;
        accelerated_ = {};
    }
    std::vector<double> give_up() {
        combines_ = false;
        n_ = 0;
        last_ = infinity;
        n_simple_ = std::min(2 * n_simple_, most_simple);
        return before_;
    }

    FixedPoint accelerated_;
    std::vector<double> before_;  // the tension where combining began
    bool combines_ = false;
    int n_ = 0, n_simple_ = least_simple;
    double first_ = infinity, least_ = infinity, last_ = infinity;
};

AdhesiveNormal::AdhesiveNormal(std::string name, const Compliance& compliance,
                               const Attraction& attraction, double tolerance)
    : name_(std::move(name)),
      compliance_(compliance),
      attraction_(attraction),
      tolerance_(tolerance),
      widths_(compliance.points()),
      exact_(compliance, .1 * tolerance) {
    if (ContactShare::is_known(compliance.points())) share_.emplace(compliance.points());
    if (attraction.is_by_cell) cells_.emplace(name_, compliance, attraction, tolerance);
    if (are_radii(compliance.points())) rings_.emplace(compliance.points());
}

/// Presses under the present tension.
void AdhesiveNormal::press(const std::vector<double>& height, const NormalControl& control,
                           double precision, Iterate& now) const {
    const auto& area = compliance_.points().area;
    const std::size_t n = height.size();
    std::vector<double> lower(n);
    double reach = 0, pull = 0;
    for (std::size_t i = 0; i < n; ++i) {
        lower[i] = height[i] - now.lowered[i];
        reach = std::max(reach, now.lowered[i]);
        pull += area[i] * now.tension[i];
    }
    NormalControl by_touch = control;
    double raised = 0;
    if (control.kind == NormalControl::Kind::force) {
        by_touch.value += pull;
        if (!(by_touch.value > 1e-12 * std::max(pull, std::abs(control.value))))
            throw InputError(fmt::format(
                "{}: a force of {:.6g} N pulls the surfaces off, they do not hold so much; pull "
                "less, or prescribe the depth",
                name_, control.value));
    } else {
        // A depth above the undeformed surface: all is raised to a positive one.
        const double positive = std::max({control.value, reach, attraction_.distance});
        raised = positive - control.value;
        for (double& h : lower) h += raised;
        by_touch.value = positive;
    }
    const bool is_last = precision <= .1 * tolerance_;
    const auto pressed = [&](const NormalSolver& solver) {
        return solver.solve(lower, by_touch,
                            now.touch.force > 0 ? now.touch.pressure : std::vector<double>{},
                            is_last);
    };
    now.touch = is_last || compliance_.dense() ? pressed(exact_)
                                               : pressed(NormalSolver(compliance_, precision));
    now.gap.resize(n);
    for (std::size_t i = 0; i < n; ++i)
        now.gap[i] = now.touch.displacement[i] + lower[i] - now.touch.indentation;
    now.touch.indentation -= raised;
}

/// From the gap; its residual is what the change displaces.
void AdhesiveNormal::update_tension(Iterate& now) const {
    const std::size_t n = now.gap.size();
    now.next.resize(n);
    std::vector<double> change(n), displaced(n);
    if (rings_)
        rings_->tensions(attraction_, now.gap, now.next);
    else
        for (std::size_t i = 0; i < n; ++i)
            now.next[i] = attraction_.tension(now.gap[i], now.width[i]);
    for (std::size_t i = 0; i < n; ++i) change[i] = now.next[i] - now.tension[i];
    compliance_.normal(change, displaced);
    double worst = 0;
    for (const double u : displaced) worst = larger(worst, std::abs(u));
    now.residual = worst / std::max(now.touch.length, attraction_.distance);
}

NormalSolution AdhesiveNormal::settle(const std::vector<double>& height,
                                      const NormalControl& control,
                                      const NormalSolution& before) const {
    if (cells_) return cells_->follow(height, control, before);
    const std::size_t n = height.size();
    Iterate now;
    now.width.assign(n, 0);
    now.lowered.resize(n);
    now.tension = before.attracts() ? before.tension : std::vector<double>(n);
    if (before.attracts()) {
        now.touch = before;
        now.touch.force = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const double q = now.touch.pressure[i] + now.tension[i];
            now.touch.pressure[i] = before.share[i] > 0 ? std::max(q, 0.) : 0;
            now.touch.force += now.touch.pressure[i];
        }
    } else if (control.kind == NormalControl::Kind::force && !(control.value > 0)) {
        now.touch.force = 0;
    }
    Way way;
    const bool needs_widths = !(rings_ || attraction_.decays || attraction_.is_short_ranged);
    bool widths_stay = !needs_widths;
    int iterations = 0;
    for (int k = 0; k < max_tensions; ++k) {
        compliance_.normal(now.tension, now.lowered);
        const double precision =
            std::clamp(of_residual * now.residual, .1 * tolerance_, roughest_press);
        press(height, control, precision, now);
        iterations += now.touch.iterations;
        if (!widths_stay) widths_.of(now.gap, now.width);
        update_tension(now);
        if (now.residual <= tolerance_ && precision <= .1 * tolerance_ && (k > 0 || widths_stay)) {
            now.touch.iterations = iterations;
            return finish(std::move(now));
        }
        if (needs_widths) {
            if (now.residual < widths_settled || k > most_varied) widths_stay = true;
            if (now.residual > 10 * widths_settled && k <= most_varied) widths_stay = false;
        }
        now.tension = way.next(now, widths_stay || now.residual < widths_follow);
        for (double& s : now.tension) s = std::clamp(s, 0., attraction_.strength);
    }
    throw NotConverged(fmt::format(
        "{}: after {} iterations the tension of the surfaces still changes, by {:.2e} of the "
        "indentation; take another load, near which nothing jumps, or finer points",
        name_, max_tensions, now.residual));
}

/// The state of tension and touch together.
NormalSolution AdhesiveNormal::finish(Iterate now) const {
    const auto& area = compliance_.points().area;
    const std::size_t n = now.gap.size();
    NormalSolution s = std::move(now.touch);
    s.share = share_ ? share_->of(s.pressure, now.gap) : std::vector<double>(n);
    s.residual = std::max(s.residual, now.residual);
    s.length = std::max(s.length, attraction_.distance);
    s.force = s.pull = 0;
    s.energy = rings_ ? rings_->energy(attraction_, now.gap) : 0;
    for (std::size_t i = 0; i < n; ++i) {
        if (!share_) s.share[i] = s.pressure[i] > 0;
        if (attraction_.is_short_ranged)
            s.share[i] += to_the_tip * (1 - s.share[i]) * now.tension[i] / attraction_.strength;
        s.pressure[i] -= now.tension[i];
        s.displacement[i] -= now.lowered[i];
        s.force += area[i] * s.pressure[i];
        s.pull += area[i] * now.tension[i];
        s.energy += area[i] * s.pressure[i] * s.displacement[i] / 2;
        if (!rings_) s.energy += area[i] * attraction_.energy(now.gap[i], now.width[i]);
    }
    s.tension = std::move(now.tension);
    return s;
}

std::vector<double> AdhesiveNormal::separation_work(const std::vector<double>& gap) const {
    std::vector<double> work(gap.size());
    widths_.of(gap, work);
    for (std::size_t i = 0; i < gap.size(); ++i)
        work[i] = attraction_.work() + attraction_.energy(gap[i], work[i]);
    return work;
}

bool AdhesiveNormal::has_other_state(const std::vector<double>& height,
                                     const NormalControl& control,
                                     const NormalSolution& now) const {
    if (!(control.value < 0)) return false;
    if (control.kind == NormalControl::Kind::force) return true;  // nothing brought them together
    const auto are_together = [](const NormalSolution& s) {
        return std::ranges::any_of(s.share, [](double part) { return part > 0; });
    };
    if (cells_) return true;  // how wide the contact has been decides
    try {
        if (are_together(now)) return !are_together(settle(height, control, {}));
        const NormalSolution met = settle(height, {control.kind, 0}, {});
        return are_together(settle(height, control, met));
    } catch (const NotConverged&) {
        return true;  // none is known not to be
    }
}

}  // namespace tricontact::contact
