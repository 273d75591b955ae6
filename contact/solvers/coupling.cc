#include "contact/solvers/coupling.h"

namespace tricontact::contact {

Coupling::Coupling(const Compliance& compliance, const Indenter& indenter,
                   const Case::Contact& options)
    : compliance_(&compliance),
      indenter_(&indenter),
      is_coupled_(options.coupling && compliance.is_coupled()),
      bare_height_(compliance.points().size()),
      lowering_(bare_height_.size()),
      height_(bare_height_.size()),
      displacement_(bare_height_.size()) {}

void Coupling::place(const Vector2& offset) {
    const ContactPoints& points = compliance_->points();
    for (std::size_t i = 0; i < points.size(); ++i)
        bare_height_[i] = indenter_->height(points.x[i] - offset[0], points.y[i] - offset[1]);
}

void Coupling::update_height(const TangentialField& t) {
    if (is_coupled_) compliance_->normal_from_tangential(t, lowering_);
    for (std::size_t i = 0; i < height_.size(); ++i) height_[i] = bare_height_[i] + lowering_[i];
}

void Coupling::update_displacement(std::span<const double> p) {
    if (is_coupled_) compliance_->tangential_from_normal(p, displacement_);
}

}  // namespace tricontact::contact
