#include "contact/solvers/normal_newton.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>

#include "contact/memory.h"
#include "contact/solvers/blocks.h"
#include "contact/solvers/grid_transfer.h"
#include "contact/special_values.h"

namespace tricontact::contact {

namespace {

constexpr int most_sets = 100;  // of points in contact; some 10 are usual
constexpr int most_steps = 20;  // of the conjugate gradients on one of them
/// By how much the gap on a set is closed before the set is judged: points that enter or leave
/// change it by about as much. More where none did.
constexpr double reduction = .3, settled_reduction = .03;
constexpr double below_tolerance = .3;  // nor is it closed further than this
constexpr double coarse_tolerance = 1e-2;

template <std::size_t n>
struct Sums {
    std::array<double, n> values{};
    double& operator[](std::size_t k) { return values[k]; }
    Sums& operator+=(const Sums& other) {
        for (std::size_t k = 0; k < n; ++k) values[k] += other.values[k];
        return *this;
    }
};

struct Gap {
    double square = 0, worst = 0;
    Gap& operator+=(const Gap& other) {
        square += other.square;
        worst = larger(worst, other.worst);
        return *this;
    }
};

struct Judgement {
    double worst = 0, work = 0, force = 0;
    std::size_t n_entered = 0;
    Judgement& operator+=(const Judgement& other) {
        worst = larger(worst, other.worst);
        work += other.work;
        force += other.force;
        n_entered += other.n_entered;
        return *this;
    }
};

/// One solve. `pressure_` is the only field that goes into products: of residuals and directions as
/// well, which are zero outside of the set; what is on the set alone is kept for its points only,
/// those of a block from the begin of the block on.
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
          n_in_block_(blocks_.count()),
          points_(large_memory<std::uint32_t>(height.size())),
          p_(large_memory<double>(height.size())),
          gap_(large_memory<double>(height.size())),
          direction_(large_memory<double>(height.size())),
          product_(large_memory<double>(height.size())) {
        displacement_ = large_field(height.size());
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

    /// body(begin, end): the points of the set in a block, and what is kept for them.
    template <class Body>
    void for_set(Body body) const {
        blocks_.for_each([&](std::size_t k, std::size_t begin, std::size_t) {
            body(begin, begin + n_in_block_[k]);
        });
    }
    template <class Sum, class Body>
    Sum sum_over_set(Body body) const {
        return blocks_.sum<Sum>([&](std::size_t k, std::size_t begin, std::size_t) {
            return body(begin, begin + n_in_block_[k]);
        });
    }

    /// Without another start as if no point pressed but those below the indentation, all alike.
    bool set_start() {
        const bool is_cold = pressure_.empty();
        if (is_cold) pressure_ = large_field(height_.size());
        blocks_.for_each([&](std::size_t k, std::size_t begin, std::size_t end) {
            std::size_t n = 0;
            for (std::size_t i = begin; i < end; ++i) {
                if (is_cold) pressure_[i] = force_controlled() || height_[i] < control_.value;
                if (!std::isfinite(height_[i])) pressure_[i] = 0;
                if (pressure_[i] > 0) points_[begin + n++] = static_cast<std::uint32_t>(i);
            }
            n_in_block_[k] = n;
            for (std::size_t j = begin; j < begin + n; ++j) p_[j] = pressure_[points_[j]];
        });
        if (!is_cold || force_controlled()) return update_pressure();
        displace();
        const double largest = *std::max_element(displacement_.begin(), displacement_.end());
        return update_pressure(control_.value / (2 * largest));
    }

    /// d at which the mean gap of the contact is zero.
    double indentation_of_contact() const {
        const auto [sum, n] = sum_over_set<Sums<2>>([&](std::size_t begin, std::size_t end) {
                                  Sums<2> part;
                                  for (std::size_t j = begin; j < end; ++j) {
                                      const std::size_t i = points_[j];
                                      const double presses = p_[j] > 0;
                                      part[0] += presses * (displacement_[i] + height_[i]);
                                      part[1] += presses;
                                  }
                                  return part;
                              }).values;
        return sum / n;
    }

    /// The residual, and the next set: points that press or penetrate.
    void judge() {
        const double d = solution_.indentation;
        const auto all =
            blocks_.sum<Judgement>([&](std::size_t k, std::size_t begin, std::size_t end) {
                double worst = 0, work = 0, force = 0;
                std::size_t to = begin, n_entered = 0;
                for (std::size_t i = begin; i < end; ++i) {
                    const double p = pressure_[i], gap = displacement_[i] + height_[i] - d;
                    const bool presses = p > 0, enters = !presses && gap < 0;
                    worst = std::max(worst, presses ? std::abs(gap) : -gap);
                    work += p * displacement_[i];  // not a number if any displacement is not
                    force += p;
                    n_entered += enters;
                    points_[to] = static_cast<std::uint32_t>(i);
                    p_[to] = p;
                    gap_[to] = gap;
                    to += presses || enters;
                }
                n_in_block_[k] = to - begin;
                return Judgement{worst, work, force, n_entered};
            });
        n_set_ = 0;
        for (const std::size_t n : n_in_block_) n_set_ += n;
        is_settled_ = n_left_ == 0 && all.n_entered == 0;
        solution_.force = grid_.cell_area() * all.force;
        solution_.length = all.force > 0 ? larger(d, all.work / all.force) : d;
        solution_.residual = larger(all.worst, 0 * all.work) / solution_.length;
    }

    /// What a force prescribed leaves of a field on the set: its mean over it is no gap.
    double mean(double sum) const {
        return force_controlled() ? sum / static_cast<double>(n_set_) : 0;
    }

    /// Conjugate gradients on the set.
    void close_gap() {
        const double enough = is_settled_ ? settled_reduction : reduction;
        Gap gap = centre_gap();
        const double first = gap.square;
        double last = 1;
        for (int k = 0; k < most_steps; ++k) {
            if (gap.worst <= below_tolerance * tolerance_ * solution_.length ||
                (k > 0 && gap.square <= enough * enough * first))
                return;
            last = update_direction(last, k == 0);
            displace();
            const auto [numerator, product, sum] =
                sum_over_set<Sums<3>>([&](std::size_t begin, std::size_t end) {
                    Sums<3> part;
                    for (std::size_t j = begin; j < end; ++j) {
                        const double r = product_[j] = displacement_[points_[j]];
                        part[0] += direction_[j] * gap_[j];
                        part[1] += direction_[j] * r;
                        part[2] += r;
                    }
                    return part;
                }).values;
            const double step = numerator / product;
            if (!is_positive_and_finite(step)) return;  // nothing is left to be closed
            gap = move(step, mean(sum));
        }
    }

    /// Less its mean; into the field.
    Gap centre_gap() {
        const double middle = mean(sum_over_set<Sums<1>>([&](std::size_t begin, std::size_t end) {
            Sums<1> part;
            for (std::size_t j = begin; j < end; ++j) part[0] += gap_[j];
            return part;
        })[0]);
        return sum_over_set<Gap>([&](std::size_t begin, std::size_t end) {
            Gap part;
            for (std::size_t j = begin; j < end; ++j) {
                const double gap = pressure_[points_[j]] = gap_[j] -= middle;
                part.square += gap * gap;
                part.worst = std::max(part.worst, std::abs(gap));
            }
            return part;
        });
    }

    /// Against the direction; the gap into the field.
    Gap move(double step, double mean_displacement) {
        return sum_over_set<Gap>([&](std::size_t begin, std::size_t end) {
            Gap part;
            for (std::size_t j = begin; j < end; ++j) {
                p_[j] -= step * direction_[j];
                const double gap = gap_[j] -= step * (product_[j] - mean_displacement);
                pressure_[points_[j]] = gap;
                part.square += gap * gap;
                part.worst = std::max(part.worst, std::abs(gap));
            }
            return part;
        });
    }

    /// The preconditioned gap, made conjugate to the last direction; into the field. Returns its
    /// product with the gap.
    double update_direction(double last, bool is_first) {
        grid_.precondition(pressure_, displacement_);
        const auto [sum, norm] = sum_over_set<Sums<2>>([&](std::size_t begin, std::size_t end) {
                                     Sums<2> part;
                                     for (std::size_t j = begin; j < end; ++j) {
                                         const double z = product_[j] = displacement_[points_[j]];
                                         part[0] += z;
                                         part[1] += z * gap_[j];  // whose mean is zero
                                     }
                                     return part;
                                 }).values;
        const double beta = is_first ? 0 : norm / last, middle = mean(sum);
        for_set([&](std::size_t begin, std::size_t end) {
            for (std::size_t j = begin; j < end; ++j) {
                const double z = product_[j] - middle;
                const double direction = is_first ? z : z + beta * direction_[j];
                pressure_[points_[j]] = direction_[j] = direction;
            }
        });
        return norm;
    }

    /// Points that pull leave; those that are left bear the force prescribed, or `factor` times
    /// what they did.
    bool update_pressure(double factor = 1) {
        const auto [sum, left] = sum_over_set<Sums<2>>([&](std::size_t begin, std::size_t end) {
                                     Sums<2> part;
                                     for (std::size_t j = begin; j < end; ++j) {
                                         p_[j] = std::max(p_[j], 0.);
                                         part[0] += p_[j];
                                         part[1] += p_[j] == 0;
                                     }
                                     return part;
                                 }).values;
        n_left_ = static_cast<std::size_t>(left);
        if (force_controlled()) factor = control_.value / (grid_.cell_area() * sum);
        if (!is_positive_and_finite(factor)) return false;
        for_set([&](std::size_t begin, std::size_t end) {
            for (std::size_t j = begin; j < end; ++j) pressure_[points_[j]] = p_[j] *= factor;
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
    std::vector<std::size_t> n_in_block_;  // of the set
    std::size_t n_set_ = 0, n_left_ = 0;
    bool is_settled_ = false;
    const std::unique_ptr<std::uint32_t[]> points_;
    const std::unique_ptr<double[]> p_, gap_, direction_, product_;
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
