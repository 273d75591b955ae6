#include "contact/solvers/projected_gradient.h"

#include <algorithm>
#include <cmath>

#include "contact/compliances/blocks.h"
#include "contact/compliances/point_sums.h"

// min 1/2 <t, A t> - <t, u_previous + D dU> over |t| <= bound, dU the multiplier of the prescribed
// forces: the frictional contact of TangentialSolver at given pressures is convex.
//
// A step: y - (A y - u_previous)/L, L the largest eigenvalue of A, then the nearest admissible
// point. Of a prescribed shift that is one projection per point, of a force the shift is found
// first for which the projected tractions carry it: a balance of two equations, monotone in two
// unknowns. Nesterov's momentum makes the error fall as 1/k^2; it is dropped where a step goes
// uphill (O'Donoghue and Candes 2015).
//
// Where bounds rise with the slip the work of flow (|t| - at_start)^2/(2 slope) joins the minimum,
// and its proximal point takes the place of the nearest admissible one (FrictionDisc::project).

namespace tricontact::contact {

namespace {

/// A balance of forces at one shift: what is missing, how it changes, and the convex potential of
/// which it is the negative gradient.
struct Balance {
    Vector2 missing{};
    double j_xx = 0, j_xy = 0, j_yy = 0;
    double potential = 0, scale = 0, area = 0;
    Balance& operator+=(const Balance& other) {
        missing = missing + other.missing;
        j_xx += other.j_xx;
        j_xy += other.j_xy;
        j_yy += other.j_yy;
        potential += other.potential;
        scale += other.scale;
        area += other.area;
        return *this;
    }
};

/// Fields are those of the active points.
class ProjectedGradient {
  public:
    ProjectedGradient(const Compliance& compliance, const std::vector<std::size_t>& active,
                      const ActiveOperator& products, const TangentialProblem& problem)
        : active_(active),
          products_(products),
          problem_(problem),
          tilt_(problem.tilt.among(active)),
          points_(active.size(), compliance.n_threads()),
          area_(active.size()),
          disc_(active.size()),
          previous_(active.size()) {
        points_.for_points([&](std::size_t k) {
            area_[k] = compliance.points().area[active[k]];
            disc_[k] = problem.disc(active[k]);
            previous_.set(k, problem.previous_displacement.at(active[k]));
        });
        stiffness_ = 1 / largest_eigenvalue();
    }

    void improve(int iterations, TangentialSolution& solution) {
        const std::size_t n = active_.size();
        TangentialField last(n), y(n), u(n), t(n);
        points_.for_points([&](std::size_t k) { last.set(k, solution.traction.at(active_[k])); });
        y = last;
        for (int d = 0; d < 2; ++d)
            shift_[d] = stiffness_ * (force_controlled(d) ? solution.shift_increment[d]
                                                          : problem_.control[d].value);
        double momentum = 1;
        for (int k = 0; k < iterations; ++k) {
            products_.apply(y, u);
            ++solution.iterations;
            gradient_step(y, u);
            project(u, t);
            const double next = (1 + std::sqrt(1 + 4 * momentum * momentum)) / 2;
            const double beta = uphill(y, t, last) ? 0 : (momentum - 1) / next;
            momentum = beta == 0 ? 1 : next;
            points_.for_points(
                [&](std::size_t i) { y.set(i, t.at(i) + beta * (t.at(i) - last.at(i))); });
            std::swap(last, t);
        }
        solution.traction = TangentialField(solution.traction.size());
        points_.for_points([&](std::size_t k) { solution.traction.set(active_[k], last.at(k)); });
        solution.shift_increment = shift_ / stiffness_;
    }

  private:
    bool force_controlled(int d) const {
        return problem_.control[d].kind == TangentialControl::Kind::force;
    }

    /// Power iteration; 1.05 covers what ten steps leave open. The start has no symmetry that could
    /// hide the largest: on long quadratic elements a traction that changes its sign along each
    /// displaces 2.5 times as far as a uniform one, which would never find it.
    double largest_eigenvalue() const {
        TangentialField v(active_.size()), u(active_.size());
        points_.for_points([&](std::size_t k) {
            const auto i = static_cast<double>(active_[k]);
            v.set(k, {1 + std::sin(i), std::cos(i)});
        });
        double eigenvalue = 0;
        for (int k = 0; k < 10; ++k) {
            products_.apply(v, u);
            eigenvalue = points_
                             .sum_points<Largest>([&](Largest& largest, std::size_t i) {
                                 largest.add(norm(u.at(i)));
                             })
                             .value;
            points_.for_points([&](std::size_t i) { v.set(i, u.at(i) / eigenvalue); });
        }
        return 1.05 * eigenvalue;
    }

    /// `u`: the displacements at y, then the point that the gradient there leads to.
    void gradient_step(const TangentialField& y, TangentialField& u) const {
        points_.for_points(
            [&](std::size_t k) { u.set(k, y.at(k) + stiffness_ * (previous_.at(k) - u.at(k))); });
    }

    Balance balance_at(const TangentialField& point, const Vector2& shift) const {
        Balance all = points_.sum_points<Balance>([&](Balance& b, std::size_t k) {
            const Vector2 v = point.at(k) + tilt_.apply(k, shift);
            const FrictionDisc& disc = disc_[k];
            const double size = norm(v), radius = disc.radius(size, 1 / stiffness_);
            const bool slips = size > disc.at_start;
            const Vector2 p = slips ? (radius / size) * v : v;
            b.missing = b.missing - area_[k] * tilt_.apply(k, p);
            b.scale += area_[k] * disc.bound;
            b.area += area_[k];
            b.potential += area_[k] * disc.potential(size, 1 / stiffness_);
            const double a = area_[k] * (slips ? radius / size : 1);
            // What the radius turns with and does not grow.
            const double c = slips ? a - area_[k] * disc.rise(size, 1 / stiffness_) : 0;
            const Vector2 e = slips ? v / size : Vector2{};
            const Vector2 x = tilt_.apply(k, {1, 0}), y = tilt_.apply(k, {0, 1});
            b.j_xx += a * dot(x, x) - c * dot(e, x) * dot(e, x);
            b.j_xy += a * dot(x, y) - c * dot(e, x) * dot(e, y);
            b.j_yy += a * dot(y, y) - c * dot(e, y) * dot(e, y);
        });
        for (int d = 0; d < 2; ++d) {
            if (force_controlled(d)) {
                all.missing[d] += problem_.control[d].value;
                all.potential -= problem_.control[d].value * shift[d];
            } else {
                all.missing[d] = 0;
            }
        }
        return all;
    }

    Vector2 newton_step(Balance b) const {
        if (!force_controlled(0)) b.j_xx = b.area, b.j_xy = 0;
        if (!force_controlled(1)) b.j_yy = b.area, b.j_xy = 0;
        // A trace of the identity keeps the step finite when every point slips.
        const double floor = 1e-9 * b.area;
        const double det = (b.j_xx + floor) * (b.j_yy + floor) - b.j_xy * b.j_xy;
        return {((b.j_yy + floor) * b.missing[0] - b.j_xy * b.missing[1]) / det,
                ((b.j_xx + floor) * b.missing[1] - b.j_xy * b.missing[0]) / det};
    }

    /// Onto discs and force balance: t = P(point + shift), the shift by damped Newton steps.
    void project(const TangentialField& point, TangentialField& t) {
        Balance balance = balance_at(point, shift_);
        for (int newton = 0; newton < 60; ++newton) {
            if (norm(balance.missing) <= 1e-13 * balance.scale) break;
            Vector2 step = newton_step(balance);
            for (int halving = 0; halving < 40; ++halving) {
                const Vector2 next = shift_ + step;
                const Balance there = balance_at(point, next);
                const double expected = 1e-4 * dot(step, balance.missing);
                const double noise = 1e-14 * balance.scale * norm(next);
                if (there.potential <= balance.potential - expected + noise) {
                    shift_ = next;
                    balance = there;
                    break;
                }
                step = step / 4;
            }
        }
        points_.for_points([&](std::size_t k) {
            t.set(k, disc_[k].project(point.at(k) + tilt_.apply(k, shift_), 1 / stiffness_));
        });
    }

    /// The last move goes against the momentum: start the acceleration again.
    bool uphill(const TangentialField& y, const TangentialField& t,
                const TangentialField& last) const {
        return points_.sum_terms([&](std::size_t k) {
            return area_[k] * dot(y.at(k) - t.at(k), t.at(k) - last.at(k));
        }) > 0;
    }

    const std::vector<std::size_t>& active_;
    const ActiveOperator& products_;
    const TangentialProblem& problem_;
    const Tilt tilt_;
    const Blocks points_;
    std::vector<double> area_;
    std::vector<FrictionDisc> disc_;
    TangentialField previous_;
    double stiffness_ = 0;  // step length of the gradient [Pa/m]
    Vector2 shift_{};       // multiplier of the force balance, dU times stiffness [Pa]
};

}  // namespace

void projected_gradient(const Compliance& compliance, const std::vector<std::size_t>& active,
                        const ActiveOperator& products, const TangentialProblem& problem,
                        int iterations, TangentialSolution& solution) {
    ProjectedGradient(compliance, active, products, problem).improve(iterations, solution);
}

}  // namespace tricontact::contact
