#include "contact/compliances/compliance.h"

#include <cmath>

#include "contact/compliances/active_operator.h"

namespace tricontact::contact {

namespace {

void add(std::span<double> to, double factor, std::span<const double> from) {
    for (std::size_t i = 0; i < from.size(); ++i) to[i] += factor * from[i];
}

}  // namespace

ContactPoints ContactPoints::grid(int n_x, int n_y, Vector2 first, Vector2 spacing) {
    ContactPoints points;
    const std::size_t n = static_cast<std::size_t>(n_x) * n_y;
    points.n_x = n_x;
    points.n_y = n_y;
    points.first = first;
    points.spacing = spacing;
    points.x = large_field(n);
    points.y = large_field(n);
    points.area = large_field(n);
    for (std::size_t k = 0; k < n; ++k) {
        points.x[k] = first[0] + static_cast<double>(k % n_x) * spacing[0];
        points.y[k] = first[1] + static_cast<double>(k / n_x) * spacing[1];
        points.area[k] = spacing[0] * spacing[1];
    }
    return points;
}

ContactPoints ContactPoints::mirrored_grid(int n_x, int n_y, double first_x, Vector2 spacing) {
    ContactPoints points = grid(n_x, n_y, {first_x, 0}, spacing);
    points.mirrored = true;
    for (std::size_t i = n_x; i < points.size(); ++i) points.area[i] *= 2;
    return points;
}

std::unique_ptr<const ActiveOperator> Compliance::among(const std::vector<std::size_t>&) const {
    return nullptr;
}

CombinedCompliance::CombinedCompliance(Parts parts, bool coupled)
    : parts_(std::move(parts)),
      coupled_(coupled && std::any_of(parts_.begin(), parts_.end(),
                                      [](const auto& part) { return part->is_coupled(); })),
      weights_(parts_.size(), 0.0) {}

std::unique_ptr<const ActiveOperator> CombinedCompliance::among(
    const std::vector<std::size_t>& active) const {
    return weights_ == std::vector<double>{1} ? parts_.front()->among(active) : nullptr;
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

/// The weighted sum of what `displace` makes of each part; none of no parts.
template <class Displace>
void CombinedCompliance::sum_down(std::span<double> u_z, bool any, Displace displace) const {
    std::vector<double> part(u_z.size());
    std::fill(u_z.begin(), u_z.end(), 0.0);
    for (std::size_t j = 0; any && j < parts_.size(); ++j) {
        displace(*parts_[j], part);
        add(u_z, weights_[j], part);
    }
}

template <class Displace>
void CombinedCompliance::sum_in_surface(TangentialField& u, bool any, Displace displace) const {
    TangentialField part(points().size());
    u = TangentialField(part.size());
    for (std::size_t j = 0; any && j < parts_.size(); ++j) {
        displace(*parts_[j], part);
        add(u.x, weights_[j], part.x);
        add(u.y, weights_[j], part.y);
    }
}

void CombinedCompliance::normal(std::span<const double> p, std::span<double> u_z) const {
    sum_down(u_z, true, [&](const Compliance& c, std::span<double> u) { c.normal(p, u); });
}

void CombinedCompliance::tangential(const TangentialField& t, TangentialField& u) const {
    sum_in_surface(u, true, [&](const Compliance& c, TangentialField& v) { c.tangential(t, v); });
}

void CombinedCompliance::tangential_from_normal(std::span<const double> p,
                                                TangentialField& u) const {
    sum_in_surface(u, coupled_, [&](const Compliance& c, TangentialField& v) {
        c.tangential_from_normal(p, v);
    });
}

void CombinedCompliance::normal_from_tangential(const TangentialField& t,
                                                std::span<double> u_z) const {
    sum_down(u_z, coupled_,
             [&](const Compliance& c, std::span<double> u) { c.normal_from_tangential(t, u); });
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
