#include "contact/solvers/coupling.h"

#include <algorithm>
#include <cmath>

namespace tricontact::contact {

Coupling::Coupling(const Compliance& compliance, const Indenter& indenter,
                   const Case::Contact& options)
    : compliance_(&compliance),
      indenter_(&indenter),
      elastic_(options.coupling && compliance.is_coupled()),
      deformed_(options.kinematics == Case::Kinematics::deformed),
      bare_height_(compliance.points().size()),
      lowering_(bare_height_.size()),
      height_(bare_height_.size()),
      slope_(bare_height_.size()),
      displacement_(bare_height_.size()) {}

void Coupling::place(const IndenterPose& at) {
    const ContactPoints& points = compliance_->points();
    for (std::size_t i = 0; i < points.size(); ++i) {
        double x = points.x[i] - at.offset[0], y = points.y[i] - at.offset[1];
        if (deformed_) {
            x += at.displacement.x[i] - at.shift[0];
            y += at.displacement.y[i] - at.shift[1];
        }
        bare_height_[i] = indenter_->height(x, y);
        if (!deformed_) continue;
        slope_.set(i, std::isfinite(bare_height_[i]) ? indenter_->slope(x, y) : Vector2{0, 0});
    }
}

void Coupling::update_height(std::span<const double> p, const TangentialField& t) {
    std::fill(lowering_.begin(), lowering_.end(), 0);
    if (elastic_) compliance_->normal_from_tangential(surface_traction(p, t), lowering_);
    if (deformed_) {
        std::vector<double> by_friction = downward_traction(p, t);
        for (std::size_t i = 0; i < p.size(); ++i) by_friction[i] -= p[i];
        std::vector<double> u_z(p.size());
        compliance_->normal(by_friction, u_z);
        for (std::size_t i = 0; i < p.size(); ++i) lowering_[i] += u_z[i];
    }
    for (std::size_t i = 0; i < p.size(); ++i) height_[i] = bare_height_[i] + lowering_[i];
}

void Coupling::update_displacement(std::span<const double> p, const TangentialField& t) {
    if (elastic_) compliance_->tangential_from_normal(downward_traction(p, t), displacement_);
    if (!deformed_) return;
    TangentialField by_pressure = surface_traction(p, t), u(p.size());
    for (std::size_t i = 0; i < p.size(); ++i) by_pressure.set(i, by_pressure.at(i) - t.at(i));
    compliance_->tangential(by_pressure, u);
    for (std::size_t i = 0; i < p.size(); ++i)
        displacement_.set(i, (elastic_ ? displacement_.at(i) : Vector2{}) + u.at(i));
}

double Coupling::normal_force(const TangentialField& t) const {
    if (!deformed_) return 0;
    const auto& area = compliance_->points().area;
    double sum = 0;
    for (std::size_t i = 0; i < area.size(); ++i) sum -= area[i] * dot(t.at(i), slope_.at(i));
    return sum;
}

Vector2 Coupling::tangential_force(std::span<const double> p) const {
    if (!deformed_) return {0, 0};
    const ContactPoints& points = compliance_->points();
    Vector2 sum{};
    for (std::size_t i = 0; i < p.size(); ++i) {
        sum[0] += points.area[i] * p[i] * slope_.x[i];
        if (!points.mirrored) sum[1] += points.area[i] * p[i] * slope_.y[i];
    }
    return sum;
}

double Coupling::inclined_force(std::span<const double> p) const {
    if (!deformed_) return 0;
    const auto& area = compliance_->points().area;
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) sum += area[i] * p[i] * norm(slope_.at(i));
    return sum;
}

TangentialField Coupling::surface_traction(std::span<const double> p,
                                           const TangentialField& t) const {
    TangentialField all = t;
    for (std::size_t i = 0; deformed_ && i < p.size(); ++i)
        all.set(i, all.at(i) + p[i] * slope_.at(i));
    return all;
}

std::vector<double> Coupling::downward_traction(std::span<const double> p,
                                                const TangentialField& t) const {
    std::vector<double> all(p.begin(), p.end());
    for (std::size_t i = 0; deformed_ && i < p.size(); ++i) all[i] -= dot(t.at(i), slope_.at(i));
    return all;
}

}  // namespace tricontact::contact
