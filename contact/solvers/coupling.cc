#include "contact/solvers/coupling.h"

#include "contact/solvers/contact_region.h"

namespace tricontact::contact {

Coupling::Coupling(const Compliance& compliance, const Indenter& indenter,
                   const ContactOptions& options)
    : compliance_(&compliance),
      indenter_(&indenter),
      is_coupled_(options.coupling && compliance.is_coupled()),
      bare_height_(large_field(compliance.points().size(), compliance.n_threads())),
      lowering_(large_field(bare_height_.size(), compliance.n_threads())),
      displacement_(bare_height_.size(), compliance.n_threads()) {}

void Coupling::place(const Vector2& offset) {
    set_heights(compliance_->points(), *indenter_, offset, compliance_->n_threads(), bare_height_);
    for (std::size_t i = 0; i < worn_.size(); ++i) bare_height_[i] += worn_[i];
}

void Coupling::update_lowering(const TangentialField& t) {
    if (is_coupled_) compliance_->normal_from_tangential(t, lowering_);
}

void Coupling::update_displacement(std::span<const double> p) {
    if (is_coupled_) compliance_->tangential_from_normal(p, displacement_);
}

}  // namespace tricontact::contact
