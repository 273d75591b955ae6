// The memory of a StrainedBody.

#include "fem/finite_strain/element_batch.h"
#include "fem/finite_strain/strained_body.h"

// See relaxing_branch.h for the law and its closed step. What a step remembers (`begin`) does not
// depend on the strain at its end but for `share`: iterations within a step evaluate a hyperelastic
// body with one more symmetric tensor per branch and point. `finish` learns the end of the step
// once.

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
            const Lanes factor = batch.weight[q] * memory.constants[b].ratio;
            for (int k = 0; k < 2; ++k) energies[k] += factor * each[k];
        }
        strain = next;
    }
}

}  // namespace

StrainMemory StrainedBody::unstrained() const {
    if (relaxation_.branches.empty()) return {};
    const std::size_t n = batches_.size() * n_points, n_branches = relaxation_.branches.size();
    return {std::vector<Symmetric3<Lanes>>(n), std::vector<Symmetric3<Lanes>>(n * n_branches),
            Amplitudes(n_cells_), Amplitudes(n_cells_ * n_branches)};
}

RelaxingStep StrainedBody::begin(const StrainMemory& memory, double duration) const {
    const auto& constants = relaxation_.branches;
    const std::size_t n = constants.size();
    if (n == 0) return {};
    const contact::RelaxationStep linear(relaxation_, duration);
    RelaxingStep step{std::vector<RelaxingStep::Branch>(memory.viscous.size()),
                      Amplitudes(n_cells_ * n),
                      Amplitudes(n_cells_),
                      linear.gain,
                      duration,
                      linear.stiffness};
    for (std::size_t b = 0; b < batches_.size(); ++b) {
        const std::size_t first = b * n_points;
        begin_batch(&memory.strain[first], &memory.viscous[first * n], constants, duration,
                    &step.branches[first * n]);
    }
    for (std::size_t c = 0; c < n_cells_; ++c)
        for (std::size_t b = 0; b < n; ++b)
            for (int m = 0; m < 4; ++m) {
                double& h = step.dilatation[c * n + b][m];
                h = linear.decay[b] * memory.viscous_dilatation[c * n + b][m] -
                    linear.gain[b] * memory.dilatation[c][m];
                step.remembered[c][m] += h;
            }
    return step;
}

double StrainedBody::dilatation(const StrainedState& state, const RelaxingStep& step,
                                std::size_t cell, int m) const {
    const double remembered = step.remembered.empty() ? 0 : step.remembered[cell][m];
    return (state.mean_stress[cell][m] / bulk(cell) - remembered) / step.stiffness;
}

/// K/2 e^2 + sum K h^2/(2g), of springs and branches.
double StrainedBody::energy_of_volume(const StrainedState& state, const RelaxingStep& step,
                                      std::size_t cell) const {
    double squares = 0;
    for (int m = 0; m < 4; ++m) {
        const double e = dilatation(state, step, cell, m);
        squares += e * e;
        for (std::size_t b = 0; b < step.gain.size(); ++b) {
            const double h = step.dilatation[cell * step.gain.size() + b][m] + step.gain[b] * e;
            squares += h * h / relaxation_.branches[b].ratio;
        }
    }
    return bulk(cell) / 2 * squares;
}

StrainedBody::StepEnergies StrainedBody::finish(const StrainedState& state,
                                                const RelaxingStep& step,
                                                StrainMemory& memory) const {
    const auto& constants = relaxation_.branches;
    StepEnergies energies;
    if (constants.empty()) return energies;
    std::vector<StepQuadrature> quadratures;
    for (const auto& branch : constants) quadratures.emplace_back(step.duration / branch.time);
    std::array<Lanes, 2> sums{};
    for (std::size_t b = 0; b < batches_.size(); ++b) {
        const std::size_t first = b * n_points;
        finish_batch(batches_[b], state.displacement.data(),
                     {&memory.strain[first], &memory.viscous[first * constants.size()], constants},
                     quadratures.data(), &step.branches[first * constants.size()], sums);
    }
    for (std::size_t l = 0; l < n_lanes; ++l) {
        energies.dissipated += sums[0][l];
        energies.work += sums[1][l];
    }
    remember_volume(state, step, memory, energies);
    return energies;
}

StrainedState StrainedBody::springs(StrainedState state, const StrainMemory& memory) const {
    for (std::size_t c = 0; c < memory.dilatation.size(); ++c)
        for (int m = 0; m < 4; ++m) state.mean_stress[c][m] = bulk(c) * memory.dilatation[c][m];
    return state;
}

/// As RelaxingSubstrate.
void StrainedBody::remember_volume(const StrainedState& state, const RelaxingStep& step,
                                   StrainMemory& memory, StepEnergies& energies) const {
    const auto& constants = relaxation_.branches;
    std::vector<contact::StepIntegrals> integrals;
    for (const auto& branch : constants) integrals.emplace_back(step.duration / branch.time);
    for (std::size_t c = 0; c < n_cells_; ++c)
        for (int m = 0; m < 4; ++m) {
            double& old = memory.dilatation[c][m];
            const double now = dilatation(state, step, c, m);
            const double change = now - old;
            for (std::size_t b = 0; b < constants.size(); ++b) {
                double& h = memory.viscous_dilatation[c * constants.size() + b][m];
                const double ratio = constants[b].ratio;
                const contact::StepIntegrals& s = integrals[b];
                energies.dissipated += bulk(c) * (h * h / ratio * s.ee + 2 * h * change * s.ew +
                                                  ratio * change * change * s.ww);
                energies.work += bulk(c) * (h * s.mean + ratio * change * s.drift) * change;
                h = step.dilatation[c * constants.size() + b][m] + step.gain[b] * now;
            }
            old = now;
        }
}

}  // namespace tricontact::fem
