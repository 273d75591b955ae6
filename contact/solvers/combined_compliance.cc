#include "contact/solvers/combined_compliance.h"

#include <algorithm>
#include <cmath>

namespace tricontact::contact {

CombinedCompliance::CombinedCompliance(Parts parts, bool coupled)
    : parts_(std::move(parts)),
      coupled_(coupled && std::any_of(parts_.begin(), parts_.end(),
                                      [](const auto& part) { return part->is_coupled(); })),
      weights_(parts_.size(), 0.0) {}

void CombinedCompliance::set_weights(std::vector<double> weights) {
    weights_ = std::move(weights);
    matrix_.clear();
}

const double* CombinedCompliance::dense() const {
    if (!std::all_of(parts_.begin(), parts_.end(), [](const auto& part) { return part->dense(); }))
        return nullptr;
    const std::size_t n = 3 * points().size();
    if (matrix_.empty()) {
        matrix_.resize(n * n);
        for (std::size_t j = 0; j < parts_.size(); ++j) {
            const double* const part = parts_[j]->dense();
            for (std::size_t k = 0; k < n * n; ++k) matrix_[k] += weights_[j] * part[k];
        }
    }
    return matrix_.data();
}

void CombinedCompliance::normal(std::span<const double> p, std::span<double> u_z) const {
    std::vector<double> part(u_z.size());
    std::fill(u_z.begin(), u_z.end(), 0.0);
    for (std::size_t j = 0; j < parts_.size(); ++j) {
        parts_[j]->normal(p, part);
        for (std::size_t i = 0; i < part.size(); ++i) u_z[i] += weights_[j] * part[i];
    }
}

void CombinedCompliance::tangential(const TangentialField& t, TangentialField& u) const {
    TangentialField part(t.size());
    u = TangentialField(t.size());
    for (std::size_t j = 0; j < parts_.size(); ++j) {
        parts_[j]->tangential(t, part);
        for (std::size_t i = 0; i < part.size(); ++i) {
            u.x[i] += weights_[j] * part.x[i];
            u.y[i] += weights_[j] * part.y[i];
        }
    }
}

void CombinedCompliance::tangential_from_normal(std::span<const double> p,
                                                TangentialField& u) const {
    TangentialField part(p.size());
    u = TangentialField(p.size());
    for (std::size_t j = 0; coupled_ && j < parts_.size(); ++j) {
        parts_[j]->tangential_from_normal(p, part);
        for (std::size_t i = 0; i < part.size(); ++i) {
            u.x[i] += weights_[j] * part.x[i];
            u.y[i] += weights_[j] * part.y[i];
        }
    }
}

void CombinedCompliance::normal_from_tangential(const TangentialField& t,
                                                std::span<double> u_z) const {
    std::vector<double> part(u_z.size());
    std::fill(u_z.begin(), u_z.end(), 0.0);
    for (std::size_t j = 0; coupled_ && j < parts_.size(); ++j) {
        parts_[j]->normal_from_tangential(t, part);
        for (std::size_t i = 0; i < part.size(); ++i) u_z[i] += weights_[j] * part[i];
    }
}

double CombinedCompliance::local_tangential() const {
    double sum = 0;
    for (std::size_t j = 0; j < parts_.size(); ++j)
        sum += weights_[j] * parts_[j]->local_tangential();
    return sum;
}

// Scale is free, and the parts are alike.
void CombinedCompliance::precondition_tangential(const TangentialField& r,
                                                 TangentialField& z) const {
    parts_.front()->precondition_tangential(r, z);
}

std::vector<double> CombinedCompliance::consistent_traction(std::span<const double> t,
                                                            bool odd_in_y) const {
    return parts_.front()->consistent_traction(t, odd_in_y);
}

std::optional<std::array<double, 3>> CombinedCompliance::missing_reaction(
    std::span<const double> p, const TangentialField& t) const {
    std::optional<std::array<double, 3>> worst;
    for (const auto& part : parts_) {
        const auto missing = part->missing_reaction(p, t);
        if (!missing) return std::nullopt;
        if (!worst) worst.emplace();
        for (int d = 0; d < 3; ++d)
            if (!(std::abs((*missing)[d]) <= std::abs((*worst)[d]))) (*worst)[d] = (*missing)[d];
    }
    return worst;
}

double CombinedCompliance::allowed_missing_reaction() const {
    double allowed = 0;
    for (const auto& part : parts_) allowed = std::max(allowed, part->allowed_missing_reaction());
    return allowed;
}

}  // namespace tricontact::contact
