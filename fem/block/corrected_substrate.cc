#include "fem/block/corrected_substrate.h"

#include <cmath>
#include <utility>

namespace tricontact::fem {

CorrectedSubstrate::CorrectedSubstrate(BlockElasticity elasticity,
                                       std::shared_ptr<Correction> correction)
    : elasticity_(std::move(elasticity)),
      correction_(std::move(correction)),
      elastic_(elasticity_.lattice) {}

void CorrectedSubstrate::forget() {
    const std::size_t n = elasticity_.lattice->points().size();
    *correction_ = {.offset = contact::SurfaceField(n),
                    .traction = contact::SurfaceField(n),
                    .displacement = contact::SurfaceField(n)};
}

contact::Substrate::Energies CorrectedSubstrate::end(const contact::SurfaceField& t,
                                                     const contact::SurfaceField& u) {
    correction_->traction = t;
    correction_->displacement = u;
    Energies energies = elastic_.end(t, u);
    const double work = energies.stored - std::exchange(correction_->stored, energies.stored);
    correction_->mismatch =
        energies.magnitude > 0 ? std::abs(energies.work - work) / energies.magnitude : 0;
    energies.work = work;
    return energies;
}

}  // namespace tricontact::fem
