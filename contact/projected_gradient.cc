#include "contact/projected_gradient.h"

#include <algorithm>
#include <cmath>

#include "contact/friction_disc.h"

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
            for (const std::size_t i : active_) {
                y.x[i] = t.x[i] + beta * (t.x[i] - solution.traction.x[i]);
                y.y[i] = t.y[i] + beta * (t.y[i] - solution.traction.y[i]);
            }
            solution.traction = t;
        }
        for (int d = 0; d < 2; ++d) solution.shift_increment[d] = shift_[d] / stiffness_;
    }

  private:
    bool force_controlled(int d) const {
        return problem_.control[d].kind == TangentialControl::Kind::force;
    }

    /// Power iteration; 1.05 covers what ten steps leave open.
    double largest_eigenvalue() const {
        TangentialField v(area_.size()), u(area_.size());
        for (const std::size_t i : active_) v.x[i] = 1;
        double eigenvalue = 0;
        for (int k = 0; k < 10; ++k) {
            compliance_.tangential(v, u);
            double size = 0;
            for (const std::size_t i : active_) size = std::max(size, std::hypot(u.x[i], u.y[i]));
            eigenvalue = size;
            for (const std::size_t i : active_) {
                v.x[i] = u.x[i] / size;
                v.y[i] = u.y[i] / size;
            }
        }
        return 1.05 * eigenvalue;
    }

    TangentialField gradient_step(const TangentialField& y, const TangentialField& u) const {
        TangentialField point(y.size());
        const auto& previous = problem_.previous_displacement;
        for (const std::size_t i : active_) {
            point.x[i] = y.x[i] + stiffness_ * (previous.x[i] - u.x[i]);
            point.y[i] = y.y[i] + stiffness_ * (previous.y[i] - u.y[i]);
        }
        return point;
    }

    /// Onto discs and force balance: t = P(point + shift), shift from two monotone equations.
    void project(const TangentialField& point, TangentialField& t) {
        for (int newton = 0; newton < 60; ++newton) {
            Vector2 missing{};
            double j_xx = 0, j_xy = 0, j_yy = 0, scale = 0;
            for (const std::size_t i : active_) {
                const Vector2 v = {point.x[i] + shift_[0], point.y[i] + shift_[1]};
                const double bound = problem_.bound[i], size = norm(v);
                const Vector2 p = project_on_disc(v, bound);
                t.x[i] = p[0];
                t.y[i] = p[1];
                for (int d = 0; d < 2; ++d) missing[d] -= area_[i] * p[d];
                scale += area_[i] * bound;
                const bool slips = size > bound;
                const double a = area_[i] * (slips ? bound / size : 1);
                const Vector2 e = slips ? Vector2{v[0] / size, v[1] / size} : Vector2{};
                j_xx += a * (1 - e[0] * e[0]);
                j_xy -= a * e[0] * e[1];
                j_yy += a * (1 - e[1] * e[1]);
            }
            double worst = 0;
            for (int d = 0; d < 2; ++d) {
                missing[d] = force_controlled(d) ? missing[d] + problem_.control[d].value : 0;
                worst = std::max(worst, std::abs(missing[d]));
            }
            if (worst <= 1e-13 * scale) return;
            if (!force_controlled(0)) j_xx = 1, j_xy = 0;
            if (!force_controlled(1)) j_yy = 1, j_xy = 0;
            // A trace of the identity keeps the step finite when every point slips.
            const double floor = 1e-9 * (j_xx + j_yy);
            const double det = (j_xx + floor) * (j_yy + floor) - j_xy * j_xy;
            const Vector2 step = {((j_yy + floor) * missing[0] - j_xy * missing[1]) / det,
                                  ((j_xx + floor) * missing[1] - j_xy * missing[0]) / det};
            for (int d = 0; d < 2; ++d) shift_[d] += step[d];
        }
    }

    /// The last move goes against the momentum: start the acceleration anew.
    bool uphill(const TangentialField& y, const TangentialField& t,
                const TangentialField& last) const {
        double product = 0;
        for (const std::size_t i : active_)
            product += area_[i] * ((y.x[i] - t.x[i]) * (t.x[i] - last.x[i]) +
                                   (y.y[i] - t.y[i]) * (t.y[i] - last.y[i]));
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
