#include "contact/normal_active_set.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "contact/largest.h"

namespace tricontact::contact {

namespace {
constexpr int max_iterations = 60;
}  // namespace

/// The normal compliance among the points in contact, displacement over force.
struct NormalActiveSet::Factor {
    std::vector<std::size_t> points;
    Eigen::LLT<Eigen::MatrixXd> llt;
    Eigen::VectorXd unit;  // forces that displace all of them by 1
};

struct NormalActiveSet::Closed {
    Eigen::VectorXd force;
    double indentation;
};

NormalActiveSet::NormalActiveSet(const Compliance& compliance) : compliance_(compliance) {}

bool NormalActiveSet::solve(const std::vector<double>& height, const NormalControl& control,
                            const std::vector<double>& start, NormalSolution& solution) {
    const auto& area = compliance_.points().area;
    const std::size_t n = area.size();
    solution.pressure.assign(n, 0);
    solution.displacement.resize(n);
    std::vector<std::uint8_t> contact = first_contact(height, control, start);
    for (solution.iterations = 1; solution.iterations <= max_iterations; ++solution.iterations) {
        update_contact(std::move(contact));
        if (factor_->points.empty() || factor_->llt.info() != Eigen::Success) return false;
        const Closed closed = close_gap(height, control);
        std::fill(solution.pressure.begin(), solution.pressure.end(), 0);
        for (std::size_t k = 0; k < factor_->points.size(); ++k)
            solution.pressure[factor_->points[k]] = closed.force[k] / area[factor_->points[k]];
        compliance_.normal(solution.pressure, solution.displacement);

        bool settled = true;
        double worst = 0;
        contact.assign(n, 0);
        for (std::size_t i = 0; i < n; ++i) {
            const double gap = solution.displacement[i] + height[i] - closed.indentation;
            contact[i] = contact_[i] ? solution.pressure[i] > 0 : gap < 0;
            settled = settled && contact[i] == contact_[i];
            worst = larger(worst, contact_[i] ? std::abs(gap) : -gap);
        }
        if (!settled) continue;
        solution.indentation = closed.indentation;
        solution.force = closed.force.sum();
        solution.residual = worst / closed.indentation;
        return true;
    }
    return false;
}

/// Pressures and depth with u + height = depth on the contact.
NormalActiveSet::Closed NormalActiveSet::close_gap(const std::vector<double>& height,
                                                   const NormalControl& control) {
    Eigen::VectorXd h(factor_->points.size());
    for (std::size_t k = 0; k < factor_->points.size(); ++k) h[k] = height[factor_->points[k]];
    const Eigen::VectorXd resisting = factor_->llt.solve(h);
    Closed closed;
    closed.indentation = control.kind == NormalControl::Kind::force
                             ? (control.value + resisting.sum()) / factor_->unit.sum()
                             : control.value;
    closed.force = closed.indentation * factor_->unit - resisting;
    return closed;
}

void NormalActiveSet::update_contact(std::vector<std::uint8_t> contact) {
    if (factor_ && contact == contact_) return;
    contact_ = std::move(contact);
    auto factor = std::make_shared<Factor>();
    for (std::size_t i = 0; i < contact_.size(); ++i)
        if (contact_[i]) factor->points.push_back(i);
    const std::size_t n = contact_.size(), m = factor->points.size();
    const double* const normal_block = compliance_.dense() + 3 * n * (2 * n) + 2 * n;
    Eigen::MatrixXd matrix(m, m);
    for (std::size_t l = 0; l < m; ++l)
        for (std::size_t k = 0; k < m; ++k)
            matrix(k, l) = normal_block[3 * n * factor->points[l] + factor->points[k]];
    factor->llt.compute(matrix);
    factor->unit = factor->llt.solve(Eigen::VectorXd::Ones(m));
    factor_ = std::move(factor);
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
