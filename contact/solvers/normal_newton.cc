#include "contact/solvers/normal_newton.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numeric>

#include "contact/base/memory.h"
#include "contact/base/special_values.h"
#include "contact/compliances/blocks.h"
#include "contact/compliances/point_sums.h"
#include "contact/solvers/conjugate_gradients.h"
#include "contact/solvers/grid_transfer.h"

namespace tricontact::contact {

namespace {

constexpr int most_sets = 100;  // of points in contact; some 10 are usual
constexpr int most_steps = 20;  // of the conjugate gradients on one of them
/// By how much the gap on a set is closed before the set is judged: points that enter or leave
/// change it by about as much. More where none did.
constexpr double reduction = .3, settled_reduction = .03;
constexpr double below_tolerance = .3;  // nor is it closed further than this
constexpr double coarse_tolerance = 1e-2;

/// A point of the set.
struct OnPoint {
    double pressure, gap, direction, product;
};

/// One solve. `pressure_` is the only field that goes into products: of residuals and directions as
/// well, which are zero outside of the set. What is on the set alone is kept for its points only.
class NewtonIteration {
  public:
    NewtonIteration(const NormalGrid& grid, const std::vector<double>& height,
                    const NormalControl& control, double tolerance, NormalSolution& solution)
        : grid_(grid),
          height_(height),
          control_(control),
          tolerance_(tolerance),
          solution_(solution),
          pressure_(solution.pressure),
          displacement_(solution.displacement),
          blocks_(height.size(), grid.n_threads()),
          first_(blocks_.count() + 1),
          points_(std::make_unique_for_overwrite<std::uint32_t[]>(height.size())) {
        displacement_ = large_field(height.size(), grid.n_threads());
    }

    /// From the pressures in the solution, if there are any.
    bool run() {
        if (!set_start()) return false;
        for (int k = 0; k < most_sets; ++k) {
            displace();
            solution_.indentation = force_controlled() ? indentation_of_contact() : control_.value;
            judge();
            if (solution_.residual <= tolerance_) return true;
            close_gap();
            if (!update_pressure()) return false;
        }
        return false;
    }

  private:
    bool force_controlled() const { return control_.kind == NormalControl::Kind::force; }

    void displace() {
        grid_.displace(pressure_, displacement_);
        ++solution_.iterations;
    }

    /// body(points, first, n): n points of the set in a block, the first of them is number `first`.
    template <class Sum, class Body>
    Sum sum_over_set(Body body) const {
        return blocks_.sum<Sum>([&](std::size_t k, std::size_t begin, std::size_t) {
            return body(points_.get() + begin, first_[k], first_[k + 1] - first_[k]);
        });
    }

    template <class Body>
    void for_set(Body body) const {
        blocks_.for_each([&](std::size_t k, std::size_t begin, std::size_t) {
            body(points_.get() + begin, first_[k], first_[k + 1] - first_[k]);
        });
    }

    /// Without another start as if no point pressed but those below the indentation, all alike.
    bool set_start() {
        const bool is_cold = pressure_.empty();
        if (is_cold) pressure_ = large_field(height_.size(), grid_.n_threads());
        const double sum =
            blocks_.sum<Sums<1>>([&](std::size_t k, std::size_t begin, std::size_t end) {
                Sums<1> part;
                std::size_t n = 0;
                for (std::size_t i = begin; i < end; ++i) {
                    if (is_cold) pressure_[i] = force_controlled() || height_[i] < control_.value;
                    if (!std::isfinite(height_[i])) pressure_[i] = 0;
                    part[0] += pressure_[i];
                    points_[begin + n] = static_cast<std::uint32_t>(i);
                    n += pressure_[i] > 0;
                }
                first_[k + 1] = n;
                return part;
            })[0];
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        if (force_controlled()) return scale(control_.value / (grid_.cell_area() * sum));
        if (!is_cold) return true;
        displace();
        return scale(control_.value /
                     (2 * *std::max_element(displacement_.begin(), displacement_.end())));
    }

    bool scale(double factor) {
        if (!is_positive_and_finite(factor)) return false;
        blocks_.for_each([&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) pressure_[i] *= factor;
        });
        return true;
    }

    /// d at which the mean gap of the contact is zero: of the last set's points that press.
    double indentation_of_contact() const {
        const auto [sum, pressed] =
            sum_over_set<Sums<2>>([&](const std::uint32_t* points, std::size_t, std::size_t n) {
                Sums<2> part;
                for (std::size_t j = 0; j < n; ++j) {
                    const std::size_t i = points[j];
                    const double presses = pressure_[i] > 0;
                    part[0] += presses * (displacement_[i] + height_[i]);
                    part[1] += presses;
                }
                return part;
            }).values;
        return sum / pressed;
    }

    /// The residual, and the next set: points that press or penetrate.
    void judge() {
        const double d = solution_.indentation;
        const auto all =
            blocks_.sum<ContactSum>([&](std::size_t k, std::size_t begin, std::size_t end) {
                double worst = 0, work = 0, force = 0, gaps = 0;
                std::size_t n = 0, n_entered = 0;
                for (std::size_t i = begin; i < end; ++i) {
                    const double p = pressure_[i], gap = displacement_[i] + height_[i] - d;
                    const bool presses = p > 0, enters = !presses && gap < 0;
                    worst = std::max(worst, presses ? std::abs(gap) : -gap);
                    work += p * displacement_[i];  // not a number if any displacement is not
                    force += p;
                    n_entered += enters;
                    points_[begin + n] = static_cast<std::uint32_t>(i);
                    n += presses || enters;
                    gaps += presses || enters ? gap : 0;
                }
                first_[k + 1] = n;
                return ContactSum{worst, work, force, gaps, n_entered};
            });
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        gap_sum_ = all.gaps;
        is_settled_ = n_left_ == 0 && all.n_entered == 0;
        solution_.force = grid_.cell_area() * all.force;
        solution_.length = all.force > 0 ? larger(d, all.work / all.force) : d;
        solution_.residual = larger(all.worst, 0 * all.work) / solution_.length;
    }

    std::size_t set_size() const { return first_.back(); }

    /// What a force prescribed leaves of a field on the set: its mean over it is no gap.
    double mean(double sum) const {
        return force_controlled() ? sum / static_cast<double>(set_size()) : 0;
    }

    /// Conjugate gradients on the set.
    void close_gap() {
        const double enough = is_settled_ ? settled_reduction : reduction;
        GapSum gap = take_set();
        const double first_square = gap.square;
        double mean_displacement = 0;
        conjugate_gradients(
            most_steps,
            [&] {
                return gap.worst <= below_tolerance * tolerance_ * solution_.length ||
                       gap.square <= enough * enough * first_square;
            },
            [&] { return precondition(); }, [&](double beta) { turn(beta); },
            [&] {
                const auto [product, sum] = apply();
                mean_displacement = mean(sum);
                return product;
            },
            [&](double step) { gap = move(step, mean_displacement); });
    }

    /// Displaces by the direction; its product with that, and the sum of the displacements.
    std::array<double, 2> apply() {
        displace();
        return sum_over_set<Sums<2>>(
                   [&](const std::uint32_t* points, std::size_t first, std::size_t n) {
                       Sums<2> part;
                       for (std::size_t j = 0; j < n; ++j) {
                           OnPoint& at = set_[first + j];
                           const double r = at.product = displacement_[points[j]];
                           part[0] += at.direction * r;
                           part[1] += r;
                       }
                       return part;
                   })
            .values;
    }

    /// Pressures and gaps of its points, less the mean gap; the gaps into the field.
    GapSum take_set() {
        if (set_size() > room_) {
            room_ = set_size() + set_size() / 4;
            set_.reset();
            set_ = large_memory<OnPoint>(room_);
        }
        const double level = solution_.indentation + mean(gap_sum_);
        return sum_over_set<GapSum>(
            [&](const std::uint32_t* points, std::size_t first, std::size_t n) {
                GapSum part;
                for (std::size_t j = 0; j < n; ++j) {
                    const std::size_t i = points[j];
                    const double gap = displacement_[i] + height_[i] - level;
                    set_[first + j] = {.pressure = pressure_[i], .gap = gap};
                    pressure_[i] = gap;
                    part.add(gap);
                }
                return part;
            });
    }

    /// Against the direction; the gaps into the field.
    GapSum move(double step, double mean_displacement) {
        return sum_over_set<GapSum>(
            [&](const std::uint32_t* points, std::size_t first, std::size_t n) {
                GapSum part;
                for (std::size_t j = 0; j < n; ++j) {
                    OnPoint& at = set_[first + j];
                    at.pressure -= step * at.direction;
                    at.gap -= step * (at.product - mean_displacement);
                    pressure_[points[j]] = at.gap;
                    part.add(at.gap);
                }
                return part;
            });
    }

    /// The gap, preconditioned; its product with the gap.
    double precondition() {
        grid_.precondition(pressure_, displacement_);
        const auto [sum, norm] = sum_over_set<Sums<2>>([&](const std::uint32_t* points,
                                                           std::size_t first, std::size_t n) {
                                     Sums<2> part;
                                     for (std::size_t j = 0; j < n; ++j) {
                                         OnPoint& at = set_[first + j];
                                         at.product = displacement_[points[j]];
                                         part[0] += at.product;
                                         part[1] += at.product * at.gap;  // whose mean is zero
                                     }
                                     return part;
                                 }).values;
        middle_ = mean(sum);
        return norm;
    }

    /// The preconditioned gap, made conjugate to the last direction; into the field.
    void turn(double beta) {
        for_set([&](const std::uint32_t* points, std::size_t first, std::size_t n) {
            for (std::size_t j = 0; j < n; ++j) {
                OnPoint& at = set_[first + j];
                const double z = at.product - middle_;
                pressure_[points[j]] = at.direction = z + beta * at.direction;
            }
        });
    }

    /// Points that pull leave; those that are left bear the force prescribed.
    bool update_pressure() {
        const auto [sum, left] =
            sum_over_set<Sums<2>>([&](const std::uint32_t*, std::size_t first, std::size_t n) {
                Sums<2> part;
                for (std::size_t j = first; j < first + n; ++j) {
                    part[0] += std::max(set_[j].pressure, 0.);
                    part[1] += set_[j].pressure <= 0;
                }
                return part;
            }).values;
        n_left_ = static_cast<std::size_t>(left);
        const double factor = force_controlled() ? control_.value / (grid_.cell_area() * sum) : 1;
        if (!is_positive_and_finite(factor)) return false;
        for_set([&](const std::uint32_t* points, std::size_t first, std::size_t n) {
            for (std::size_t j = 0; j < n; ++j)
                pressure_[points[j]] = factor * std::max(set_[first + j].pressure, 0.);
        });
        return true;
    }

    const NormalGrid& grid_;
    const std::vector<double>& height_;
    const NormalControl control_;
    const double tolerance_;
    NormalSolution& solution_;
    std::vector<double>&pressure_, &displacement_;  // of the solution
    const Blocks blocks_;
    std::vector<std::size_t> first_;  // number of the first point of each block in the set
    const std::unique_ptr<std::uint32_t[]> points_;  // of the set, a block's from its begin on
    std::unique_ptr<OnPoint[]> set_;                 // one after the other
    std::size_t room_ = 0;                           // in it
    double gap_sum_ = 0;
    double middle_ = 0;  // mean of the preconditioned gap
    std::size_t n_left_ = 0;
    bool is_settled_ = false;
};

}  // namespace

std::vector<double> NormalNewton::start_from_coarser(const std::vector<double>& height,
                                                     const NormalControl& control) const {
    const auto coarser = grid_.coarser();
    if (!coarser) return {};
    NormalSolution solution;
    const auto coarse_height = to_coarser(height, grid_.n_x(), grid_.n_y(), grid_.n_threads());
    const bool is_found = NormalNewton(*coarser, std::max(tolerance_, coarse_tolerance))
                              .solve(coarse_height, control, {}, solution);
    if (!is_found || !(solution.force > 0)) return {};
    return to_finer(solution.pressure, grid_.n_x(), grid_.n_y(), grid_.n_threads());
}

bool NormalNewton::solve(const std::vector<double>& height, const NormalControl& control,
                         const std::vector<double>& start, NormalSolution& solution) const {
    solution = {};
    solution.pressure = start.empty() ? start_from_coarser(height, control) : start;
    return NewtonIteration(grid_, height, control, tolerance_, solution).run();
}

}  // namespace tricontact::contact
