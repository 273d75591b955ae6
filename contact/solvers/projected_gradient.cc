#include "contact/solvers/projected_gradient.h"

#include <algorithm>
#include <cmath>

namespace tricontact::contact {

namespace {

class ProjectedGradient {
  public:
    ProjectedGradient(const Compliance& compliance, const std::vector<std::size_t>& active,
                      const TangentialProblem& problem)
        : compliance_(compliance),
          area_(compliance.points().area),
          active_(active),
          problem_(problem),
          stiffness_(1 / largest_eigenvalue()) {}

    void improve(int iterations, TangentialSolution& solution) {
        const std::size_t n = solution.traction.size();
        TangentialField y = solution.traction, u(n), t(n);
        for (int d = 0; d < 2; ++d)
            shift_[d] = stiffness_ * (force_controlled(d) ? solution.shift_increment[d]
                                                          : problem_.control[d].value);
        double momentum = 1;
        for (int k = 0; k < iterations; ++k) {
            compliance_.tangential(y, u);
            ++solution.iterations;
            const TangentialField point = gradient_step(y, u);
            project(point, t);
            const double next = (1 + std::sqrt(1 + 4 * momentum * momentum)) / 2;
            const double beta = uphill(y, t, solution.traction) ? 0 : (momentum - 1) / next;
            momentum = beta == 0 ? 1 : next;
            for (const std::size_t i : active_)
                y.set(i, t.at(i) + beta * (t.at(i) - solution.traction.at(i)));
            solution.traction = t;
        }
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
        TangentialField v(area_.size()), u(area_.size());
        for (const std::size_t i : active_)
            v.set(i, {1 + std::sin(static_cast<double>(i)), std::cos(static_cast<double>(i))});
        double eigenvalue = 0;
        for (int k = 0; k < 10; ++k) {
            compliance_.tangential(v, u);
            double size = 0;
            for (const std::size_t i : active_) size = std::max(size, std::hypot(u.x[i], u.y[i]));
            eigenvalue = size;
            for (const std::size_t i : active_) v.set(i, u.at(i) / size);
        }
        return 1.05 * eigenvalue;
    }

    TangentialField gradient_step(const TangentialField& y, const TangentialField& u) const {
        TangentialField point(y.size());
        const auto& previous = problem_.previous_displacement;
        for (const std::size_t i : active_)
            point.set(i, y.at(i) + stiffness_ * (previous.at(i) - u.at(i)));
        return point;
    }

    /// Balance of forces at one shift: what is missing, how it changes, and the convex potential of
    /// which it is the negative gradient.
    struct Balance {
        Vector2 missing{};
        double j_xx = 0, j_xy = 0, j_yy = 0;
        double potential = 0, scale = 0, area = 0;
    };

    Balance balance_at(const TangentialField& point, const Vector2& shift) const {
        Balance b;
        for (const std::size_t i : active_) {
            const Vector2 v = point.at(i) + problem_.tilt.apply(i, shift);
            const double bound = problem_.bound[i], size = norm(v);
            const bool slips = size > bound;
            const Vector2 p = project_on_disc(v, bound);
            b.missing = b.missing - area_[i] * problem_.tilt.apply(i, p);
            b.scale += area_[i] * bound;
            b.area += area_[i];
            b.potential += area_[i] * (slips ? bound * (size - bound / 2) : size * size / 2);
            const double a = area_[i] * (slips ? bound / size : 1);
            const Vector2 e = slips ? v / size : Vector2{};
            const Vector2 x = problem_.tilt.apply(i, {1, 0}), y = problem_.tilt.apply(i, {0, 1});
            b.j_xx += a * (dot(x, x) - dot(e, x) * dot(e, x));
            b.j_xy += a * (dot(x, y) - dot(e, x) * dot(e, y));
            b.j_yy += a * (dot(y, y) - dot(e, y) * dot(e, y));
        }
        for (int d = 0; d < 2; ++d) {
            if (force_controlled(d)) {
                b.missing[d] += problem_.control[d].value;
                b.potential -= problem_.control[d].value * shift[d];
            } else {
                b.missing[d] = 0;
            }
        }
        return b;
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
        for (const std::size_t i : active_)
            t.set(i,
                  project_on_disc(point.at(i) + problem_.tilt.apply(i, shift_), problem_.bound[i]));
    }

    /// The last move goes against the momentum: start the acceleration again.
    bool uphill(const TangentialField& y, const TangentialField& t,
                const TangentialField& last) const {
        double product = 0;
        for (const std::size_t i : active_)
            product += area_[i] * dot(y.at(i) - t.at(i), t.at(i) - last.at(i));
        return product > 0;
    }

    const Compliance& compliance_;
    const std::vector<double>& area_;
    const std::vector<std::size_t>& active_;
    const TangentialProblem& problem_;
    const double stiffness_;  // step length of the gradient [Pa/m]
    Vector2 shift_{};         // multiplier of the force balance, dU times stiffness [Pa]
};

}  // namespace

void projected_gradient(const Compliance& compliance, const std::vector<std::size_t>& active,
                        const TangentialProblem& problem, int iterations,
                        TangentialSolution& solution) {
    ProjectedGradient(compliance, active, problem).improve(iterations, solution);
}

}  // namespace tricontact::contact
