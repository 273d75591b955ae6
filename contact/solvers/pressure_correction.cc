#include "contact/solvers/pressure_correction.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "contact/base/special_values.h"
#include "contact/compliances/active_operator.h"
#include "contact/solvers/conjugate_gradients.h"

// Between neighbouring steps and staggered iterations gaps change by less than a hundredth of d and
// the contact by a rim of points. A Newton step on the points in contact needs products among these
// alone (Compliance::among). The other points are looked at once the pressures on the set are
// right: those that penetrate join it.

namespace tricontact::contact {

namespace {

/// Largest gap of a start over the length that gaps are compared with: beyond it the contact is
/// another one, and its set would be found one ring of points after the other.
constexpr double near_enough = 1e-2;
constexpr int most_corrections = 8;
constexpr int most_iterations = 60;
/// Of the tolerance: what the conjugate gradients leave.
constexpr double exactness = 0.3;

/// The points in contact in one Newton step.
class PointsInContact {
  public:
    PointsInContact(const Compliance& compliance, const std::vector<std::size_t>& points)
        : points_(points), products_(compliance.among(points)) {
        for (const std::size_t i : points) area_.push_back(compliance.points().area[i]);
        all_area_ = total(std::vector<double>(points.size(), 1));
    }

    double all_area() const { return all_area_; }
    bool is_known() const { return products_ && products_->has_normal(); }

    /// Gaps under pressures p, less their mean, which is what it returns [m].
    double gaps(const std::vector<double>& p, const std::vector<double>& height,
                std::vector<double>& gap) const {
        gap.resize(points_.size());
        products_->normal(p, gap);
        for (std::size_t k = 0; k < gap.size(); ++k) gap[k] += height[points_[k]];
        return balance(gap);
    }

    /// Moves p so that the gaps, `residual` as handed over, are at most `target` [m], their mean
    /// apart and the force as it is. The number of iterations.
    int solve(std::vector<double>& residual, double target, std::vector<double>& p) const {
        const std::size_t n = points_.size();
        std::vector<double> z(n), direction(n), displaced(n);
        return conjugate_gradients(
            most_iterations, [&] { return largest(residual) <= target; },
            [&] {
                products_->precondition_normal(residual, z);
                balance(z);
                return inner(residual, z);
            },
            [&](double beta) {
                for (std::size_t k = 0; k < n; ++k) direction[k] = z[k] + beta * direction[k];
            },
            [&] {
                products_->normal(direction, displaced);
                balance(displaced);
                return inner(direction, displaced);
            },
            [&](double step) {
                for (std::size_t k = 0; k < n; ++k) {
                    p[k] -= step * direction[k];
                    residual[k] -= step * displaced[k];
                }
            });
    }

    double inner(const std::vector<double>& a, const std::vector<double>& b) const {
        double sum = 0;
        for (std::size_t k = 0; k < a.size(); ++k) sum += area_[k] * a[k] * b[k];
        return sum;
    }
    double total(const std::vector<double>& f) const {
        double sum = 0;
        for (std::size_t k = 0; k < f.size(); ++k) sum += area_[k] * f[k];
        return sum;
    }
    static double largest(const std::vector<double>& f) {
        double largest = 0;
        for (const double value : f) largest = larger(largest, std::abs(value));
        return largest;
    }

  private:
    /// Takes the mean away, which is what it returns.
    double balance(std::vector<double>& f) const {
        const double mean = total(f) / all_area_;
        for (double& value : f) value -= mean;
        return mean;
    }

    const std::vector<std::size_t>& points_;
    std::unique_ptr<const ActiveOperator> products_;
    std::vector<double> area_;  // [m^2]
    double all_area_ = 0;
};

}  // namespace

bool PressureCorrection::correct(const std::vector<double>& height, double force,
                                 const std::vector<double>& start, PressedSurface& surface) const {
    auto& [pressure, displacement, iterations] = surface;
    pressure = start;
    displacement.resize(start.size());
    iterations = 0;
    std::vector<std::uint8_t> is_in_contact(start.size());
    for (std::size_t i = 0; i < start.size(); ++i) is_in_contact[i] = start[i] > 0;
    std::vector<double> p, gap;
    double length = 0;
    for (int step = 0; step < most_corrections; ++step) {
        std::vector<std::size_t> points;
        p.clear();
        for (std::size_t i = 0; i < start.size(); ++i)
            if (is_in_contact[i]) points.push_back(i), p.push_back(pressure[i]);
        const PointsInContact contact(compliance_, points);
        if (points.empty() || !contact.is_known()) return false;
        const double factor = force / contact.total(p);
        for (double& value : p) value *= factor;
        const double mean = contact.gaps(p, height, gap);
        ++iterations;
        if (step == 0) {
            if (!(mean > 0) || !(contact.largest(gap) <= near_enough * mean)) return false;
            length = mean;
        }
        if (contact.largest(gap) > tolerance_ * length)
            iterations += contact.solve(gap, exactness * tolerance_ * length, p);
        bool changed = false;
        for (std::size_t k = 0; k < p.size(); ++k) {
            is_in_contact[points[k]] = p[k] > 0;
            changed = changed || !(p[k] > 0);
            pressure[points[k]] = std::max(0., p[k]);
        }
        if (changed) continue;
        compliance_.normal(pressure, displacement);
        ++iterations;
        double indentation = 0;
        for (const std::size_t i : points)
            indentation += compliance_.points().area[i] * (displacement[i] + height[i]);
        indentation /= contact.all_area();
        for (std::size_t i = 0; i < start.size(); ++i)
            if (!is_in_contact[i] &&
                displacement[i] + height[i] - indentation < -tolerance_ * length)
                is_in_contact[i] = changed = true;
        if (!changed) return true;
    }
    return false;
}

}  // namespace tricontact::contact
