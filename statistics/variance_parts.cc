#include "statistics/variance_parts.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace tricontact::statistics {

namespace {

using Eigen::MatrixXd, Eigen::VectorXd, Eigen::Index;

// Of a column that is left beside the others: less is none of its own.
constexpr double least_own = 1e-10;
// Of the largest eigenvalue of the information: less is not told.
constexpr double least_told = 1e-12;

Eigen::Map<const VectorXd> mapped(const std::vector<double>& column) {
    return {column.data(), static_cast<Index>(column.size())};
}

MatrixXd inverse_of_told(const MatrixXd& information) {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(information);
    const VectorXd& values = solver.eigenvalues();
    VectorXd inverse = VectorXd::Zero(values.size());
    for (Index k = 0; k < values.size(); ++k)
        if (values[k] > least_told * values[values.size() - 1]) inverse[k] = 1 / values[k];
    return solver.eigenvectors() * inverse.asDiagonal() * solver.eigenvectors().transpose();
}

}  // namespace

VarianceParts::VarianceParts(const Columns& columns, const Columns& own, const Columns& parts) {
    for (const auto& column : own) add_own(column);
    const auto n = static_cast<Index>(parts.front().size());
    columns_.resize(n, static_cast<Index>(columns.size()));
    for (std::size_t k = 0; k < columns.size(); ++k)
        columns_.col(static_cast<Index>(k)) = without_own(mapped(columns[k]));
    covariance_ = inverse_of_told(columns_.transpose() * columns_);
    for (const auto& part : parts) parts_.emplace_back(mapped(part));
    make_traces();
}

void VarianceParts::add_own(const std::vector<double>& column) {
    const auto is_some = [](double value) { return value != 0; };
    const auto first = std::ranges::find_if(column, is_some);
    if (first == column.end()) return;
    const auto end = std::find_if(column.rbegin(), column.rend(), is_some).base();
    const VectorXd values = without_own(mapped(column));
    if (values.norm() < least_own * mapped(column).norm()) return;
    // Columns of other rows took nothing off, those of the same rows end where this one does.
    auto from = static_cast<Index>(first - column.begin());
    auto to = static_cast<Index>(end - column.begin());
    for (const Own& other : own_)
        if (other.first < to && from < other.first + other.values.size()) {
            from = std::min(from, other.first);
            to = std::max(to, other.first + other.values.size());
        }
    own_.push_back({from, values.segment(from, to - from).normalized()});
}

VectorXd VarianceParts::without_own(VectorXd column) const {
    for (const Own& o : own_) {
        auto rows = column.segment(o.first, o.values.size());
        rows -= o.values.dot(rows) * o.values;
    }
    return column;
}

void VarianceParts::make_traces() {
    const auto n_parts = static_cast<Index>(parts_.size()), n_own = static_cast<Index>(own_.size());
    traces_ = MatrixXd::Zero(n_parts, n_parts);
    expected_ = VectorXd::Zero(n_parts);
    for (const VectorXd& part : parts_) {
        const MatrixXd weighted = part.asDiagonal() * columns_;
        told_.push_back(columns_.transpose() * weighted);
        MatrixXd mixed(columns_.cols(), n_own);
        for (Index k = 0; k < n_own; ++k)
            mixed.col(k) = weighted.middleRows(own_[k].first, own_[k].values.size()).transpose() *
                           own_[k].values;
        mixed_.push_back(std::move(mixed));
    }
    VectorXd leverage = (columns_ * covariance_).cwiseProduct(columns_).rowwise().sum();
    for (const Own& o : own_)
        leverage.segment(o.first, o.values.size()) += o.values.cwiseProduct(o.values);
    for (Index c = 0; c < n_parts; ++c) {
        expected_[c] = parts_[c].sum() - parts_[c].dot(leverage);
        for (Index d = 0; d < n_parts; ++d) {
            const VectorXd both = parts_[c].cwiseProduct(parts_[d]);
            traces_(c, d) = both.sum() - 2 * both.dot(leverage) +
                            (covariance_ * told_[c] * covariance_ * told_[d]).trace() +
                            2 * (covariance_ * mixed_[c]).cwiseProduct(mixed_[d]).sum();
        }
    }
    for (std::size_t k = 0; k < own_.size(); ++k)
        for (std::size_t l = 0; l < own_.size(); ++l) {
            const Own &a = own_[k], &b = own_[l];
            const Index from = std::max(a.first, b.first),
                        rows =
                            std::min(a.first + a.values.size(), b.first + b.values.size()) - from;
            if (rows <= 0) continue;
            const VectorXd product = a.values.segment(from - a.first, rows)
                                         .cwiseProduct(b.values.segment(from - b.first, rows));
            VectorXd of_part(n_parts);
            for (Index c = 0; c < n_parts; ++c)
                of_part[c] = product.dot(parts_[c].segment(from, rows));
            traces_ += of_part * of_part.transpose();
        }
}

MatrixXd VarianceParts::left(std::size_t c, std::size_t d) const {
    return columns_.transpose() * parts_[c].cwiseProduct(parts_[d]).asDiagonal() * columns_ -
           told_[c] * covariance_ * told_[d] - mixed_[c] * mixed_[d].transpose();
}

VectorXd VarianceParts::squares(const std::vector<double>& residuals) const {
    VectorXd r = without_own(mapped(residuals));
    r -= columns_ * (covariance_ * (columns_.transpose() * r));
    VectorXd all(static_cast<Index>(parts_.size()));
    for (std::size_t c = 0; c < parts_.size(); ++c)
        all[static_cast<Index>(c)] = parts_[c].dot(r.cwiseProduct(r));
    return all;
}

}  // namespace tricontact::statistics
