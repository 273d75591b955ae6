#pragma once

#include <algorithm>

#include "fem/finite_strain/element_batch.h"
#include "fem/finite_strain/strained_body.h"

// What StrainedBody's loops over batches of elements have in common.

// A batch is evaluated with or without Maxwell branches by one code (`Beside`): without branches
// the compiler removes the call. Branches are read in the order of memory, points before branches;
// they are the largest part of what an evaluation reads, which is why they are prefetched.

namespace tricontact::fem {

TRICONTACT_INLINE std::array<Lanes, 4> gather(const Amplitudes& amplitudes, std::size_t first) {
    std::array<Lanes, 4> lanes{};
    for (std::size_t l = 0; l < n_lanes && first + l < amplitudes.size(); ++l)
        for (int m = 0; m < 4; ++m) lanes[m][l] = amplitudes[first + l][m];
    return lanes;
}

TRICONTACT_INLINE void prefetch(const RelaxingStep::Branch* branch) {
    constexpr std::size_t cache_line = 64;
    for (std::size_t k = 0; k < sizeof(*branch); k += cache_line)
        __builtin_prefetch(reinterpret_cast<const char*>(branch) + k);
}

/// What lies beside the material: nothing.
struct NoBranches {
    TRICONTACT_INLINE void add(const ElementBatch&, const Strain<Lanes>&, int, Matrix3<Lanes>&,
                               Lanes&) const {}
};

/// Branches of a batch, by points, in a step.
struct Branches {
    const RelaxingStep::Branch* first;
    std::size_t n_ahead;  // from there to the end of all batches'
    const std::vector<contact::Relaxation::Branch>& constants;

    /// Adds their stress M and their energy per volume at Gauss point q.
    TRICONTACT_INLINE void add(const ElementBatch& batch, const Strain<Lanes>& strain, int q,
                               Matrix3<Lanes>& stress, Lanes& energy) const {
        const auto isochoric = isochoric_strain(strain);
        const Lanes of_stress = 1. / (strain.dilatation + 1.);
        const std::size_t n = constants.size();
        for (std::size_t b = 0; b < n; ++b) {
            const auto& branch = first[q * n + b];
            // They are read once and in order, but come too late otherwise: a fifth of the time.
            prefetch(first + std::min((q + 3) * n + b, n_ahead - 1));
            Symmetric3<Lanes> mixed;
            for (int k = 0; k < 6; ++k)
                mixed[k] = branch.remembered[k] + branch.share * isochoric[k];
            const auto y = branch_strain(isochoric, unimodular(mixed));
            const auto t = branch_stress(batch.material, y);
            const Lanes ratio = constants[b].ratio;
            for (int a = 0; a < 3; ++a)
                for (int c = 0; c < 3; ++c) stress[a][c] += ratio * of_stress * t[a][c];
            energy += ratio * branch_energy(batch.material, y);
        }
    }
};

}  // namespace tricontact::fem
