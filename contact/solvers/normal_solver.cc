#include "contact/solvers/normal_solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "contact/solvers/normal_active_set.h"
#include "contact/solvers/normal_newton.h"
#include "contact/solvers/pressure_correction.h"

// Signorini's conditions, g = u + h - d >= 0, p >= 0, p g = 0 with u = A p, are those of
//
//   min 1/2 <p, A p> + <p, h - d>  over p >= 0,
//
// whose gradient is the gap. If the force is prescribed, d is the multiplier of sum p a = F_N: the
// mean gap of the points in contact vanishes (`indentation_of_contact`). Equations in
// docs/explanation/models/common.md, "What is solved in a step".
//
// Polonsky and Keer's iteration, one product with A per step:
// 1. gap g, and direction q = g + beta q_last on the contact, zero elsewhere;
// 2. step <q, g>/<q, A q>, A q less its mean where F_N is prescribed; p <- p - step q;
// 3. points that would pull leave: p = 0. Points that penetrate enter with p = -step g. Those make
//    q useless: beta = 0 in the next step. Those that leave do not;
// 4. all p scaled to the force.
//
// u is carried along by increments and therefore drifts: a residual below the tolerance counts only
// after u = A p was computed again.
//
// Which method runs (`solve`): with a matrix NormalActiveSet, which closes gaps exactly; on large
// grids NormalNewton; from a start close by PressureCorrection, whose products are among the points
// in contact only; this iteration for what is left, and where one of those gives up.

namespace tricontact::contact {

namespace {

constexpr int max_iterations = 5000;
constexpr double rounding = 1e-13;  // of gaps, beside the largest of them

/// One solve: the fields of the conjugate gradient iteration, and its verbs.
class Iteration {
  public:
    Iteration(const Compliance& compliance, const std::vector<double>& height,
              const NormalControl& control, const std::vector<double>& start)
        : compliance_(compliance),
          area_(compliance.points().area),
          areas_are_equal_(std::ranges::all_of(area_, [&](double a) { return a == area_[0]; })),
          height_(height),
          control_(control),
          gap_(height.size()),
          direction_(height.size()),
          direction_displacement_(height.size()) {
        solution_.displacement.resize(height.size());
        set_start(start);
    }

    /// From a surface whose displacements are known.
    Iteration(const Compliance& compliance, const std::vector<double>& height,
              const NormalControl& control, PressedSurface start)
        : Iteration(compliance, height, control, start.pressure) {
        solution_.displacement = std::move(start.displacement);
        displacement_is_exact_ = true;
        iterations_before_ = start.iterations;
    }

    NormalSolution run(double tolerance) {
        if (!displacement_is_exact_) update_displacement();
        for (int k = 1; k <= max_iterations; ++k) {
            update_gap();
            solution_.iterations = iterations_before_ + k;
            if (solution_.residual <= tolerance) {
                // The displacement is carried along by increments: judge the true one.
                if (displacement_is_exact_) return finish();
                update_displacement();
                continue;
            }
            update_direction();
            take_step();
        }
        throw NotConverged(fmt::format(
            "normal contact: residual {:.2e} after {} iterations ({} points in contact)",
            solution_.residual, max_iterations, n_contact_));
    }

  private:
    bool force_controlled() const { return control_.kind == NormalControl::Kind::force; }
    bool in_contact(std::size_t i) const { return solution_.pressure[i] > 0; }
    double area(std::size_t i) const { return area_[areas_are_equal_ ? 0 : i]; }

    void set_start(const std::vector<double>& start) {
        auto& p = solution_.pressure;
        if (!start.empty()) {
            p = start;
        } else {
            p.resize(height_.size());
            for (std::size_t i = 0; i < p.size(); ++i)
                p[i] = force_controlled() ? std::isfinite(height_[i]) : height_[i] < control_.value;
        }
        for (std::size_t i = 0; i < p.size(); ++i)
            if (!std::isfinite(height_[i])) p[i] = 0;
        if (force_controlled()) {
            const double factor = control_.value / pressure_sum();
            for (double& value : p) value *= factor;
        } else if (start.empty()) {
            // A pressure of the right magnitude: it displaces by at most half of what is
            // prescribed.
            update_displacement();
            const auto& u = solution_.displacement;
            const double factor = control_.value / (2 * *std::max_element(u.begin(), u.end()));
            for (double& value : p) value *= factor;
            displacement_is_exact_ = false;
        }
    }

    double pressure_sum() const {
        double sum = 0;
        for (std::size_t i = 0; i < area_.size(); ++i) sum += area(i) * solution_.pressure[i];
        return sum;
    }

    void update_displacement() {
        compliance_.normal(solution_.pressure, solution_.displacement);
        displacement_is_exact_ = true;
    }

    /// d at which the mean gap of the contact is zero.
    double indentation_of_contact() const {
        const auto& u = solution_.displacement;
        double sum = 0, total = 0;
        for (std::size_t i = 0; i < area_.size(); ++i)
            if (in_contact(i)) {
                sum += area(i) * (u[i] + height_[i]);
                total += area(i);
            }
        return sum / total;
    }

    // On large grids each pass over the fields costs as much as a part of the convolution: what one
    // pass can do is not left to two.
    void update_gap() {
        const auto& u = solution_.displacement;
        solution_.indentation = force_controlled() ? indentation_of_contact() : control_.value;
        double worst = 0, inside = 0, square = 0, work = 0, force = 0;
        n_contact_ = 0;
        for (std::size_t i = 0; i < gap_.size(); ++i) {
            const double gap = gap_[i] = u[i] + height_[i] - solution_.indentation;
            if (in_contact(i)) {
                inside = larger(inside, std::abs(gap));
                square += area(i) * gap * gap;
                work += area(i) * solution_.pressure[i] * u[i];
                force += area(i) * solution_.pressure[i];
                ++n_contact_;
            } else {
                worst = larger(worst, -gap);
            }
        }
        norm_ = square;
        worst = larger(worst, inside);
        is_balanced_ = inside <= rounding * worst;
        solution_.length = larger(solution_.indentation, work / force);
        solution_.residual = worst / solution_.length;
    }

    /// Points in balance, such as a single one that bears the whole force, tell no direction: those
    /// that penetrate do.
    bool gives_direction(std::size_t i) const {
        return is_balanced_ ? !in_contact(i) && gap_[i] < 0 : in_contact(i);
    }

    void update_direction() {
        const double beta = restart_ || is_balanced_ ? 0 : norm_ / last_norm_;
        last_norm_ = norm_;
        for (std::size_t i = 0; i < gap_.size(); ++i)
            direction_[i] = gives_direction(i) ? gap_[i] + beta * direction_[i] : 0;
    }

    void take_step() {
        compliance_.normal(direction_, direction_displacement_);
        const double step = step_length();
        if (!(std::isfinite(step)))
            throw NotConverged("normal contact: the conjugate gradients broke down");
        const bool contact_changed = move(step);
        const double factor = force_controlled() ? control_.value / moved_sum_ : 1;
        for (double& value : solution_.pressure) value *= factor;
        if (contact_changed) {
            update_displacement();
            return;
        }
        displacement_is_exact_ = false;
        for (std::size_t i = 0; i < gap_.size(); ++i)
            solution_.displacement[i] =
                factor * (solution_.displacement[i] - step * direction_displacement_[i]);
    }

    /// Of the conjugate gradients; a force prescribed, the mean over the contact is no gap.
    double step_length() const {
        const auto& r = direction_displacement_;
        double numerator = 0, product = 0, direction = 0, displacement = 0, total = 0;
        for (std::size_t i = 0; i < gap_.size(); ++i) {
            if (!gives_direction(i)) continue;
            const double weighted = area(i) * direction_[i];
            numerator += weighted * gap_[i];
            product += weighted * r[i];
            direction += weighted;
            displacement += area(i) * r[i];
            total += area(i);
        }
        const double mean = force_controlled() && !is_balanced_ ? displacement / total : 0;
        return numerator / (product - mean * direction);
    }

    /// Moves along the direction; true when points left or entered the contact. Those that enter
    /// make the old direction useless; those that leave do not.
    bool move(double step) {
        auto& p = solution_.pressure;
        bool clipped = false, entered = false;
        double sum = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (in_contact(i)) {
                p[i] -= step * direction_[i];
                if (p[i] <= 0) {
                    p[i] = 0;
                    clipped = true;
                }
            } else if (gap_[i] < 0) {
                p[i] = -step * gap_[i];
                entered = true;
            }
            sum += area(i) * p[i];
        }
        moved_sum_ = sum;
        restart_ = entered;
        return clipped || entered;
    }

    NormalSolution finish() {
        solution_.force = pressure_sum();
        return std::move(solution_);
    }

    const Compliance& compliance_;
    const std::vector<double>& area_;
    const bool areas_are_equal_;  // one less field to be read in each pass
    const std::vector<double>& height_;
    const NormalControl control_;
    NormalSolution solution_;
    std::vector<double> gap_, direction_, direction_displacement_;
    double norm_ = 0, last_norm_ = 1;  // of the gap in contact
    double moved_sum_ = 0;             // of the pressures after a move [N]
    bool restart_ = true;
    bool is_balanced_ = false;  // what is in contact, beside what penetrates elsewhere
    bool displacement_is_exact_ = false;
    int iterations_before_ = 0;
    std::size_t n_contact_ = 0;
};

NormalSolution out_of_contact(std::size_t n, double indentation) {
    return {.pressure = std::vector<double>(n),
            .displacement = std::vector<double>(n),
            .indentation = indentation,
            .length = indentation};
}

}  // namespace

NormalSolver::NormalSolver(const Compliance& compliance, double tolerance)
    : compliance_(compliance), tolerance_(tolerance) {
    if (compliance.dense()) active_set_ = std::make_shared<NormalActiveSet>(compliance);
}

NormalSolution NormalSolver::solve(const std::vector<double>& height, const NormalControl& control,
                                   const std::vector<double>& start, bool is_last) const {
    if (!(control.value > 0))
        throw InputError("normal contact: the prescribed force or indentation must be positive");
    NormalSolution solution;
    if (control.kind == NormalControl::Kind::indentation &&
        std::ranges::none_of(height, [&](double h) { return h < control.value; }))
        return out_of_contact(height.size(), control.value);
    if (active_set_ && active_set_->solve(height, control, start, solution)) {
        if (is_last || solution.residual > tolerance_)
            solution.rounding = active_set_->rounding_of(solution);
        if (solution.residual <= std::max(tolerance_, solution.rounding)) return solution;
    }
    if (const NormalGrid* const grid = compliance_.normal_grid())
        if (NormalNewton(*grid, tolerance_).solve(height, control, start, solution))
            return solution;
    PressedSurface near;
    if (!active_set_ && !start.empty() && control.kind == NormalControl::Kind::force &&
        PressureCorrection(compliance_, tolerance_).correct(height, control.value, start, near))
        return Iteration(compliance_, height, control, std::move(near)).run(tolerance_);
    return Iteration(compliance_, height, control, start).run(tolerance_);
}

}  // namespace tricontact::contact
