#include "contact/solvers/normal_active_set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "contact/base/special_values.h"
#include "contact/compliances/cholesky.h"

// Of a set S of points in contact, in forces f, since the matrix A (displacement over force) is
// symmetric:
//
//   A_SS f_S = d - h_S,  f = 0 elsewhere;   next S: f > 0 within S, gap < 0 outside of it
//
// Force prescribed: f_S = f_0 + d f_1 with A_SS f_0 = -h_S and A_SS f_1 = 1 (`unit`), d from the
// sum of forces. Settled sets are solutions: every sign of Signorini's conditions has been looked
// at.
//
// Hintermüller, Ito and Kunisch (2003) prove that it settles for M-matrices. A compliance is none,
// therefore `max_changes` and the way back to the conjugate gradients.
//
// Points that enter extend the Cholesky factor, points that leave begin it anew. The last factor is
// taken in the order of the points, so that no bit of the solution depends on the way to it.

namespace tricontact::contact {

namespace {
// In which points leave the contact; one that only grows is complete at the latest when all touch.
constexpr int max_changes = 60;
// Cholesky's errors leave some ten roundings of a gap, closing what they left hardly more than one.
constexpr int closings = 2;
}  // namespace

/// The normal compliance among the points in contact, displacement over force, by Cholesky.
struct NormalActiveSet::Factor {
    std::vector<std::size_t> points;  // in the order in which they entered
    Cholesky<double> cholesky;
    std::vector<double> unit;  // forces that displace all points by 1, if known

    /// False if the matrix is not positive definite. `block`: of the normal components, by columns
    /// of length `stride`.
    bool add(const std::vector<std::size_t>& entered, const double* block, std::size_t stride) {
        points.insert(points.end(), entered.begin(), entered.end());
        unit.clear();
        return cholesky.extend(points.size(), [&](std::size_t i, std::size_t j) {
            return block[stride * points[j] + points[i]];
        });
    }
};

struct NormalActiveSet::Increment {
    std::vector<double> force;
    double indentation;
};

NormalActiveSet::NormalActiveSet(const Compliance& compliance)
    : compliance_(compliance), factor_(std::make_shared<Factor>()) {}

bool NormalActiveSet::solve(const std::vector<double>& height, const NormalControl& control,
                            const std::vector<double>& start, NormalSolution& solution) {
    const auto& area = compliance_.points().area;
    const std::size_t n = area.size();
    std::vector<std::uint8_t> contact = first_contact(height, control, start);
    if (contact != contact_) forget();  // no trace of earlier solutions
    solution.iterations = 0;
    for (int changes = 0; changes < max_changes;) {
        ++solution.iterations;
        if (!update_contact(contact)) return false;
        solution.pressure.assign(n, 0);
        solution.displacement.assign(n, 0);
        solution.force = solution.indentation = 0;
        std::vector<double> gap = height;
        for (int k = 0; k < closings; ++k) {
            const Increment more = close_gap(gap, control, solution);
            solution.force += std::reduce(more.force.begin(), more.force.end());
            solution.indentation += more.indentation;
            for (std::size_t l = 0; l < factor_->points.size(); ++l)
                solution.pressure[factor_->points[l]] += more.force[l] / area[factor_->points[l]];
            compliance_.normal(solution.pressure, solution.displacement);
            for (std::size_t i = 0; i < n; ++i)
                gap[i] = solution.displacement[i] + height[i] - solution.indentation;
        }
        bool settled = true, left = false;
        double worst = 0, work = 0;
        for (std::size_t i = 0; i < n; ++i) {
            contact[i] = contact_[i] ? solution.pressure[i] > 0 : gap[i] < 0;
            settled = settled && contact[i] == contact_[i];
            left = left || contact[i] < contact_[i];
            worst = larger(worst, contact_[i] ? std::abs(gap[i]) : -gap[i]);
            work += area[i] * solution.pressure[i] * solution.displacement[i];
        }
        solution.length = larger(solution.indentation, work / solution.force);
        solution.residual = worst / solution.length;
        if (settled && !std::ranges::is_sorted(factor_->points)) {
            forget();  // nor of the way to this one
        } else if (settled) {
            return true;
        }
        changes += left;
    }
    return false;
}

/// A displacement is a sum of n products, which rounding changes by sqrt(n) half epsilons of their
/// magnitudes (Higham and Mary 2019, SIAM J. Sci. Comput. 41, A2815). Thin incompressible layers
/// give way by what is left of terms that are (a/b)^2 times as large.
double NormalActiveSet::rounding_of(const NormalSolution& solution) const {
    constexpr double half_epsilon = std::numeric_limits<double>::epsilon() / 2;
    constexpr std::size_t side_by_side = 4;  // sums that need not wait for each other
    const auto& area = compliance_.points().area;
    const double* const block = normal_block();
    const auto& points = factor_->points;
    std::vector<double> force(points.size());
    for (std::size_t k = 0; k < force.size(); ++k)
        force[k] = solution.pressure[points[k]] * area[points[k]];
    double largest = 0;
    for (const std::size_t i : points) {
        std::array<double, side_by_side> sum{};
        for (std::size_t k = 0; k < force.size(); ++k)
            sum[k % side_by_side] += std::abs(block[3 * area.size() * i + points[k]]) * force[k];
        largest = std::max(largest, (sum[0] + sum[1]) + (sum[2] + sum[3]));
    }
    return std::sqrt(static_cast<double>(points.size())) * half_epsilon * largest / solution.length;
}

/// What has to be added for u + height = depth on the contact.
NormalActiveSet::Increment NormalActiveSet::close_gap(const std::vector<double>& gap,
                                                      const NormalControl& control,
                                                      const NormalSolution& solution) const {
    const std::size_t m = factor_->points.size();
    std::vector<double> force(m);  // what resists the open gap, with the opposite sign
    for (std::size_t k = 0; k < m; ++k) force[k] = -gap[factor_->points[k]];
    factor_->cholesky.solve(force);
    if (control.kind == NormalControl::Kind::indentation && solution.indentation != 0)
        return {std::move(force), 0};
    auto& unit = factor_->unit;
    if (unit.empty()) {
        unit.assign(m, 1.0);
        factor_->cholesky.solve(unit);
    }
    const auto sum = [](const std::vector<double>& v) { return std::reduce(v.begin(), v.end()); };
    const double indentation = control.kind == NormalControl::Kind::force
                                   ? (control.value - solution.force - sum(force)) / sum(unit)
                                   : control.value;
    for (std::size_t k = 0; k < m; ++k) force[k] += indentation * unit[k];
    return {std::move(force), indentation};
}

/// False if the matrix is not positive definite or nothing touches.
bool NormalActiveSet::update_contact(std::vector<std::uint8_t> contact) {
    const auto& points = factor_->points;
    if (!std::ranges::all_of(points, [&](std::size_t i) { return contact[i]; })) forget();
    contact_.resize(contact.size());
    std::vector<std::size_t> entered;
    for (std::size_t i = 0; i < contact.size(); ++i)
        if (contact[i] && !contact_[i]) entered.push_back(i);
    contact_ = std::move(contact);
    return (entered.empty() || factor_->add(entered, normal_block(), 3 * contact_.size())) &&
           !factor_->points.empty();
}

void NormalActiveSet::forget() {
    factor_->points.clear();
    factor_->cholesky.clear();
    factor_->unit.clear();
    std::ranges::fill(contact_, 0);
}

/// Of the matrix, by columns three times as long.
const double* NormalActiveSet::normal_block() const {
    const std::size_t n = contact_.size();
    return compliance_.dense() + 3 * n * (2 * n) + 2 * n;
}

/// The points that carried pressure before, or those under the indenter at a depth that must be
/// enough; too many do no harm.
std::vector<std::uint8_t> NormalActiveSet::first_contact(const std::vector<double>& height,
                                                         const NormalControl& control,
                                                         const std::vector<double>& start) const {
    const std::size_t n = height.size();
    std::vector<std::uint8_t> contact(n, 0);
    if (!start.empty()) {
        for (std::size_t i = 0; i < n; ++i) contact[i] = start[i] > 0 && std::isfinite(height[i]);
        return contact;
    }
    double depth = control.value;
    if (control.kind == NormalControl::Kind::force) {
        // The depth is not known: start with the lower half of the points.
        std::vector<double> finite;
        for (const double h : height)
            if (std::isfinite(h)) finite.push_back(h);
        const auto middle = finite.begin() + static_cast<std::ptrdiff_t>(finite.size() / 2);
        std::nth_element(finite.begin(), middle, finite.end());
        depth = *middle;
    }
    for (std::size_t i = 0; i < n; ++i) contact[i] = height[i] < depth;
    return contact;
}

}  // namespace tricontact::contact
