#include "contact/substrates/substrate.h"

#include <cmath>

#include "contact/compensated_sum.h"

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
    CompensatedSum all_stored, all_work, all_magnitude;
    for (int d = 0; d < 3; ++d) {
        const double *const t0 = components(traction_)[d]->data(),
                            *const u0 = components(displacement_)[d]->data(),
                            *const t1 = components(t)[d]->data(),
                            *const u1 = components(u)[d]->data();
        for_each_block(0, static_cast<int>(area.size()), [&](int begin, int end) {
            double stored = 0, work = 0, magnitude = 0;
            for (int i = begin; i < end; ++i) {
                stored += area[i] / 2 * t1[i] * u1[i];
                work += area[i] / 2 * (t0[i] + t1[i]) * (u1[i] - u0[i]);
                magnitude += area[i] / 2 * (std::abs(t0[i]) + std::abs(t1[i])) *
                             (std::abs(u0[i]) + std::abs(u1[i]));
            }
            all_stored.add(stored);
            all_work.add(work);
            all_magnitude.add(magnitude);
        });
    }
    Energies energies;
    energies.stored = all_stored.value();
    energies.work = all_work.value();
    energies.magnitude = all_magnitude.value();
    return energies;
}

std::unique_ptr<const Interior> ElasticSubstrate::interior(const SurfaceField& t) const {
    return compliance_->interior(t.down, t.in_surface);
}

}  // namespace tricontact::contact
