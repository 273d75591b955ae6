#include "contact/substrate.h"

namespace tricontact::contact {

void write(const SurfaceField& field, StateWriter& out) {
    for (const auto* component : components(field)) out.add(*component);
}

void read(SurfaceField& field, StateReader& in) {
    for (auto* component : components(field)) in.get(*component);
}

ElasticSubstrate::ElasticSubstrate(std::shared_ptr<const Compliance> compliance)
    : compliance_(std::move(compliance)),
      none_(compliance_->points().size()),
      traction_(none_),
      displacement_(none_) {}

std::unique_ptr<Substrate> ElasticSubstrate::fresh(bool) const {
    return std::make_unique<ElasticSubstrate>(compliance_);
}

bool ElasticSubstrate::begin(double, const SurfaceField& t, const SurfaceField& u) {
    traction_ = t;
    displacement_ = u;
    return false;
}

Substrate::Energies ElasticSubstrate::end(const SurfaceField& t, const SurfaceField& u) {
    const auto& area = compliance_->points().area;
    Energies energies;
    for (int d = 0; d < 3; ++d) {
        const auto &t0 = *components(traction_)[d], &u0 = *components(displacement_)[d];
        const auto &t1 = *components(t)[d], &u1 = *components(u)[d];
        for (std::size_t i = 0; i < area.size(); ++i) {
            energies.stored += area[i] / 2 * t1[i] * u1[i];
            energies.work += area[i] / 2 * (t0[i] + t1[i]) * (u1[i] - u0[i]);
        }
    }
    return energies;
}

std::unique_ptr<const Interior> ElasticSubstrate::interior(const SurfaceField& t) const {
    return compliance_->interior(t.down, t.in_surface);
}

}  // namespace tricontact::contact
