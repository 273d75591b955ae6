// The memory of a StrainedBody.

#include "fem/finite_strain/element_batch.h"
#include "fem/finite_strain/strained_body.h"

namespace tricontact::fem {

namespace {

/// Shares of each lane, which have strains of their own.
struct LaneShares {
    Lanes viscous, start, end;
};
void set_shares(double x, const Lanes& rate, LaneShares& shares) {
    for (std::size_t l = 0; l < n_lanes; ++l) {
        const ViscousShares s(x, rate[l]);
        shares.viscous[l] = s.viscous;
        shares.start[l] = s.start;
        shares.end[l] = s.end;
    }
}

/// Of the Gauss points of a batch.
struct BatchMemory {
    Symmetric3<Lanes>* strain;
    Symmetric3<Lanes>* viscous;
    const std::vector<contact::Relaxation::Branch>& constants;
};

TRICONTACT_LANES_CLONES
void begin_batch(const Symmetric3<Lanes>* strains, const Symmetric3<Lanes>* viscous_strains,
                 const std::vector<contact::Relaxation::Branch>& constants, double duration,
                 RelaxingStep::Branch* branches) {
    const std::size_t n = constants.size();
    for (int q = 0; q < n_points; ++q)
        for (std::size_t b = 0; b < n; ++b) {
            const auto &strain = strains[q], &viscous = viscous_strains[q * n + b];
            const BranchInvariants<Lanes> invariants(branch_strain(strain, viscous));
            LaneShares shares;
            set_shares(duration / constants[b].time, 1. + invariants.first() * (1. / 3), shares);
            auto& branch = branches[q * n + b];
            for (int k = 0; k < 6; ++k)
                branch.remembered[k] = shares.viscous * viscous[k] + shares.start * strain[k];
            branch.share = shares.end;
        }
}

/// A branch's X - 1 at the start, in the middle and at the end of a step, and E_bar.
struct BranchPath {
    std::array<Matrix3<Lanes>, 3> y;
    std::array<Symmetric3<Lanes>, 3> strain;
};

TRICONTACT_INLINE Symmetric3<Lanes> between(const Symmetric3<Lanes>& a, const Symmetric3<Lanes>& b,
                                            double s) {
    Symmetric3<Lanes> c;
    for (int k = 0; k < 6; ++k) c[k] = a[k] + s * (b[k] - a[k]);
    return c;
}

/// Dissipation and work of a branch of ratio 1 [J/m^3].
TRICONTACT_INLINE std::array<Lanes, 2> branch_energies(const MooneyRivlin<Lanes>& spring,
                                                       const BranchPath& path,
                                                       const StepQuadrature& quadrature) {
    Symmetric3<Lanes> change;
    for (int k = 0; k < 6; ++k) change[k] = path.strain[2][k] - path.strain[0][k];
    std::array<Lanes, 2> energies{};
    for (int k = 0; k < 3; ++k) {
        energies[0] += quadrature.dissipation[k] * branch_dissipation(spring, path.y[k]);
        energies[1] +=
            quadrature.mean[k] * trace_of_product(branch_stress(spring, path.y[k]),
                                                  product(change, cofactor(path.strain[k])));
    }
    return energies;
}

TRICONTACT_LANES_CLONES
void finish_batch(const ElementBatch& batch, const double* displacement, const BatchMemory& memory,
                  const StepQuadrature* quadratures, const RelaxingStep::Branch* branches,
                  std::array<Lanes, 2>& energies) {
    Nodal nodal;
    gather(batch, displacement, nodal);
    Own own;
    for (int a = 0; a < 3; ++a) differentiate(nodal[a], own[a]);
    const std::size_t n = memory.constants.size();
    for (int q = 0; q < n_points; ++q) {
        auto& strain = memory.strain[q];
        const auto next = isochoric_strain(Strain<Lanes>(physical_gradient(batch, own, q)));
        for (std::size_t b = 0; b < n; ++b) {
            auto& viscous = memory.viscous[q * n + b];
            const auto& branch = branches[q * n + b];
            const StepQuadrature& quadrature = quadratures[b];
            BranchPath path;
            path.strain = {strain, between(strain, next, quadrature.middle), next};
            path.y[0] = branch_strain(strain, viscous);
            LaneShares shares;
            set_shares(quadrature.middle_decay_exponent,
                       1. + BranchInvariants<Lanes>(path.y[0]).first() * (1. / 3), shares);
            Symmetric3<Lanes> halfway;
            for (int k = 0; k < 6; ++k) {
                halfway[k] = shares.viscous * viscous[k] + shares.start * strain[k] +
                             shares.end * path.strain[1][k];
                viscous[k] = branch.remembered[k] + branch.share * next[k];
            }
            viscous = unimodular(viscous);
            path.y[1] = branch_strain(path.strain[1], unimodular(halfway));
            path.y[2] = branch_strain(next, viscous);
            const auto each = branch_energies(batch.material, path, quadrature);
            const Lanes factor = batch.weight[q] * batch.relaxing * memory.constants[b].ratio;
            for (int k = 0; k < 2; ++k) energies[k] += factor * each[k];
        }
        strain = next;
    }
}

}  // namespace

StrainMemory StrainedBody::unstrained() const {
    if (relaxation_.branches.empty()) return {};
    const std::size_t n = batches_.size() * n_points;
    return {std::vector<Symmetric3<Lanes>>(n),
            std::vector<Symmetric3<Lanes>>(n * relaxation_.branches.size())};
}

RelaxingStep StrainedBody::begin(const StrainMemory& memory, double duration) const {
    RelaxingStep step{std::vector<RelaxingStep::Branch>(memory.viscous.size()), duration};
    const auto& constants = relaxation_.branches;
    if (constants.empty()) return step;
    for (std::size_t b = 0; b < batches_.size(); ++b) {
        const std::size_t first = b * n_points;
        if (batches_[b].relaxes)
            begin_batch(&memory.strain[first], &memory.viscous[first * constants.size()], constants,
                        duration, &step.branches[first * constants.size()]);
    }
    return step;
}

StrainedBody::StepEnergies StrainedBody::finish(const StrainedState& state,
                                                const RelaxingStep& step,
                                                StrainMemory& memory) const {
    const auto& constants = relaxation_.branches;
    std::vector<StepQuadrature> quadratures;
    for (const auto& branch : constants) quadratures.emplace_back(step.duration / branch.time);
    std::array<Lanes, 2> sums{};
    for (std::size_t b = 0; b < batches_.size() && !constants.empty(); ++b) {
        const std::size_t first = b * n_points;
        if (batches_[b].relaxes)
            finish_batch(
                batches_[b], state.displacement.data(),
                {&memory.strain[first], &memory.viscous[first * constants.size()], constants},
                quadratures.data(), &step.branches[first * constants.size()], sums);
    }
    StepEnergies energies;
    for (std::size_t l = 0; l < n_lanes; ++l) {
        energies.dissipated += sums[0][l];
        energies.work += sums[1][l];
    }
    return energies;
}

}  // namespace tricontact::fem
