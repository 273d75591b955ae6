#include "contact/substrate.h"

namespace tricontact::contact {

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
    auto add = [&](const std::vector<double>& t0, const std::vector<double>& u0,
                   const std::vector<double>& t1, const std::vector<double>& u1) {
        for (std::size_t i = 0; i < area.size(); ++i) {
            energies.stored += area[i] / 2 * t1[i] * u1[i];
            energies.work += area[i] / 2 * (t0[i] + t1[i]) * (u1[i] - u0[i]);
        }
    };
    add(traction_.in_surface.x, displacement_.in_surface.x, t.in_surface.x, u.in_surface.x);
    add(traction_.in_surface.y, displacement_.in_surface.y, t.in_surface.y, u.in_surface.y);
    add(traction_.down, displacement_.down, t.down, u.down);
    return energies;
}

std::unique_ptr<const Interior> ElasticSubstrate::interior(const SurfaceField& t) const {
    return compliance_->interior(t.down, t.in_surface);
}

}  // namespace tricontact::contact
