#include "contact/solvers/coupling.h"

#include "contact/solvers/blocks.h"

namespace tricontact::contact {

Coupling::Coupling(const Compliance& compliance, const Indenter& indenter,
                   const Case::Contact& options)
    : compliance_(&compliance),
      indenter_(&indenter),
      is_coupled_(options.coupling && compliance.is_coupled()),
      bare_height_(large_field(compliance.points().size(), compliance.n_threads())),
      lowering_(large_field(bare_height_.size(), compliance.n_threads())),
      displacement_(bare_height_.size(), compliance.n_threads()) {}

void Coupling::place(const Vector2& offset) {
    const ContactPoints& points = compliance_->points();
    Blocks(points.size(), compliance_->n_threads()).for_points([&](std::size_t i) {
        bare_height_[i] = indenter_->height(points.x[i] - offset[0], points.y[i] - offset[1]);
    });
}

void Coupling::update_lowering(const TangentialField& t) {
    if (is_coupled_) compliance_->normal_from_tangential(t, lowering_);
}

void Coupling::update_displacement(std::span<const double> p) {
    if (is_coupled_) compliance_->tangential_from_normal(p, displacement_);
}

}  // namespace tricontact::contact
