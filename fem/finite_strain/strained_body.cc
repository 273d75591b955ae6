#include "fem/finite_strain/strained_body.h"

#include <algorithm>
#include <cmath>

#include "fem/finite_strain/branches.h"

// Stationary point in u and q of  int W(E) + q (J - 1) - q^2/(2K)  (finite-strain.md, "Elements"):
//
//   forces   int P : grad v,  P = cof F (M + q 1)           M: isochoric stress, see hyperelastic.h
//   volumes  int psi (J - 1) - q/K = 0 per element          "excess" until it is
//
// q is eliminated per element by Newton's method with the linear B (B u = int psi div u): q_new = q
// + K (B du + excess). That turns the balance into the one of the linear stiffness, which contains
// K B' B: K_linear du = c - (f + K B' excess). The brackets are `effective_force`.
//
// Elements are taken n_lanes at a time, one per lane of a vector, and derivatives as tensor
// products of one-dimensional ones: 27 nodes to 27 points in three contractions of 3 x 3, instead
// of 27 x 27.

namespace tricontact::fem {

namespace {

TRICONTACT_INLINE void scatter(const ElementBatch& batch, const Nodal& nodal, double* field) {
    for (int i = 0; i < n_points; ++i)
        for (std::size_t l = 0; l < n_lanes; ++l)
            for (int a = 0; a < 3; ++a) field[3 * batch.node[i][l] + a] += nodal[a][i][l];
}

/// Sums of one batch beside the forces.
struct Totals {
    Lanes energy{};
    Lanes least_volume = 1;
};

/// What is known of a batch's volumes.
struct Volumes {
    std::array<Lanes, 4> mean_stress;  // q
    std::array<Lanes, 4> remembered;   // see RelaxingStep
    double stiffness;                  // of the step
};

// The effective force needs B' times the excess volume: linear gradients (`to_physical`) instead of
// those of the deformed element, since it is the linear stiffness that has to take the excess away.
template <class Beside>
TRICONTACT_INLINE void evaluate_lanes(const ElementBatch& batch, const double* displacement,
                                      const Volumes& volumes, const Beside& beside, double* force,
                                      double* effective, std::array<Lanes, 4>& excess,
                                      Totals& totals) {
    const auto& mean_stress = volumes.mean_stress;
    Nodal nodal;
    gather(batch, displacement, nodal);
    Own own, linear;
    for (int a = 0; a < 3; ++a) differentiate(nodal[a], own[a]);
    Scalar<Lanes> mean;
    for (int m = 0; m < 4; ++m)
        excess[m] = (volumes.remembered[m] - mean_stress[m] / batch.bulk) / volumes.stiffness;
    for (int q = 0; q < n_points; ++q) {
        const Strain<Lanes> strain(physical_gradient(batch, own, q));
        const auto& psi = batch.pressure[q];
        mean[q] = Lanes{};
        for (int m = 0; m < 4; ++m) {
            mean[q] += mean_stress[m] * psi[m];
            excess[m] += batch.weight[q] * psi[m] * strain.dilatation;
        }
        auto stress = isochoric_stress(batch.material, strain);
        Lanes energy = energy_density(batch.material, strain);
        beside.add(batch, strain, q, stress, energy);
        for (int a = 0; a < 3; ++a) stress[a][a] += mean[q];
        Matrix3<Lanes> piola;
        for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b)
                piola[a][b] = strain.cofactor[a][0] * stress[0][b] +
                              strain.cofactor[a][1] * stress[1][b] +
                              strain.cofactor[a][2] * stress[2][b];
        set_flux(batch, piola, q, own);
        totals.energy += batch.weight[q] * energy;
        totals.least_volume = smaller(totals.least_volume, strain.dilatation + 1.);
    }
    for (int a = 0; a < 3; ++a) integrate(own[a], nodal[a]);
    scatter(batch, nodal, force);
    for (int q = 0; q < n_points; ++q) {
        Lanes sum{};
        for (int m = 0; m < 4; ++m) sum += excess[m] * batch.pressure[q][m];
        sum *= volumes.stiffness * batch.bulk * batch.weight[q];
        for (int a = 0; a < 3; ++a)
            for (int r = 0; r < 3; ++r) linear[a][r][q] = sum * batch.to_physical[q][r][a];
    }
    for (int a = 0; a < 3; ++a) integrate(linear[a], nodal[a]);
    scatter(batch, nodal, effective);
}

TRICONTACT_LANES_CLONES
void evaluate_batch(const ElementBatch& batch, const double* displacement, const Volumes& volumes,
                    double* force, double* effective, std::array<Lanes, 4>& excess,
                    Totals& totals) {
    evaluate_lanes(batch, displacement, volumes, NoBranches{}, force, effective, excess, totals);
}

TRICONTACT_LANES_CLONES
void evaluate_relaxing_batch(const ElementBatch& batch, const double* displacement,
                             const Volumes& volumes, const Branches& branches, double* force,
                             double* effective, std::array<Lanes, 4>& excess, Totals& totals) {
    evaluate_lanes(batch, displacement, volumes, branches, force, effective, excess, totals);
}

/// B du.
TRICONTACT_LANES_CLONES
void dilate_batch(const ElementBatch& batch, const double* displacement,
                  std::array<Lanes, 4>& dilatation) {
    Nodal nodal;
    gather(batch, displacement, nodal);
    Own own;
    for (int a = 0; a < 3; ++a) differentiate(nodal[a], own[a]);
    for (auto& d : dilatation) d = Lanes{};
    for (int q = 0; q < n_points; ++q) {
        const auto h = physical_gradient(batch, own, q);
        for (int m = 0; m < 4; ++m)
            dilatation[m] += batch.weight[q] * batch.pressure[q][m] * (h[0][0] + h[1][1] + h[2][2]);
    }
}

/// Gauss points of one element: their weights and inverse Jacobians, by the nodes' positions, of
/// which the element's map is the interpolation.
void set_geometry(const std::array<std::array<double, 3>, n_points>& nodes, std::size_t lane,
                  ElementBatch& batch) {
    std::array<Gradient<double>, 3> own;
    for (int a = 0; a < 3; ++a) {
        Scalar<double> coordinate;
        for (int i = 0; i < n_points; ++i) coordinate[i] = nodes[i][a];
        differentiate(coordinate, own[a]);
    }
    const auto& w = line_functions.weight;
    for (int q = 0; q < n_points; ++q) {
        std::array<std::array<double, 3>, 3> j{}, cofactor{};
        for (int a = 0; a < 3; ++a)
            for (int r = 0; r < 3; ++r) j[a][r] = own[a][r][q];
        for (int a = 0; a < 3; ++a)
            for (int r = 0; r < 3; ++r)
                cofactor[a][r] = j[(a + 1) % 3][(r + 1) % 3] * j[(a + 2) % 3][(r + 2) % 3] -
                                 j[(a + 1) % 3][(r + 2) % 3] * j[(a + 2) % 3][(r + 1) % 3];
        const double determinant =
            j[0][0] * cofactor[0][0] + j[0][1] * cofactor[0][1] + j[0][2] * cofactor[0][2];
        batch.weight[q][lane] = determinant * w[q % 3] * w[q / 3 % 3] * w[q / 9];
        for (int r = 0; r < 3; ++r)
            for (int a = 0; a < 3; ++a)
                batch.to_physical[q][r][a][lane] = cofactor[a][r] / determinant;
    }
}

/// 1 and the coordinates, orthonormal by Gram and Schmidt.
void set_pressures(const std::array<std::array<double, 3>, n_points>& nodes, std::size_t lane,
                   ElementBatch& batch) {
    std::array<std::array<double, n_points>, 4> f;
    f[0].fill(1);
    for (int a = 0; a < 3; ++a) {
        Scalar<double> coordinate, in_x, in_y;
        for (int i = 0; i < n_points; ++i) coordinate[i] = nodes[i][a] - nodes[n_points / 2][a];
        contract<0, false>(line_functions.value, coordinate, in_x);
        contract<1, false>(line_functions.value, in_x, in_y);
        contract<2, false>(line_functions.value, in_y, f[a + 1]);
    }
    const auto inner = [&](const auto& a, const auto& b) {
        double sum = 0;
        for (int q = 0; q < n_points; ++q) sum += batch.weight[q][lane] * a[q] * b[q];
        return sum;
    };
    for (int m = 0; m < 4; ++m) {
        for (int n = 0; n < m; ++n) {
            const double part = inner(f[m], f[n]);
            for (int q = 0; q < n_points; ++q) f[m][q] -= part * f[n][q];
        }
        const double size = std::sqrt(inner(f[m], f[m]));
        for (int q = 0; q < n_points; ++q) {
            f[m][q] /= size;
            batch.pressure[q][m][lane] = f[m][q];
        }
    }
}

}  // namespace

StrainedBody::StrainedBody(const Discretisation& discretisation,
                           const std::array<double, meshes::n_regions>& c01_ratio,
                           const contact::Relaxation& relaxation)
    : n_nodes_(discretisation.space.nodes.size()),
      n_cells_(discretisation.space.cells.size()),
      relaxation_(relaxation) {
    check(relaxation_);
    const Q2Space& space = discretisation.space;
    const auto order = tensor_order();
    batches_.resize((n_cells_ + n_lanes - 1) / n_lanes);
    for (std::size_t place = 0; place < batches_.size() * n_lanes; ++place) {
        const std::size_t cell = std::min(place, n_cells_ - 1), lane = place % n_lanes;
        ElementBatch& batch = batches_[place / n_lanes];
        std::array<std::array<double, 3>, n_points> nodes;
        for (int i = 0; i < n_points; ++i) {
            batch.node[i][lane] = space.cells[cell][order[i]];
            nodes[i] = space.nodes[batch.node[i][lane]];
        }
        set_geometry(nodes, lane, batch);
        set_pressures(nodes, lane, batch);
        if (place >= n_cells_)
            for (auto& weight : batch.weight) weight[lane] = 0;
        const auto region = static_cast<std::size_t>(space.regions[cell]);
        const Moduli& moduli = discretisation.moduli[region];
        batch.material.c10[lane] = moduli.shear / 2 * (1 - c01_ratio[region]);
        batch.material.c01[lane] = moduli.shear / 2 * c01_ratio[region];
        batch.bulk[lane] = moduli.bulk;
    }
}
StrainedBody::~StrainedBody() = default;

StrainedState StrainedBody::at_rest() const {
    return {std::vector<double>(3 * n_nodes_), Amplitudes(n_cells_)};
}

void StrainedBody::evaluate(const StrainedState& state, Response& r) const {
    evaluate(state, {}, r);
}

void StrainedBody::evaluate(const StrainedState& state, const RelaxingStep& step,
                            Response& r) const {
    r.force.assign(3 * n_nodes_, 0);
    r.effective_force.assign(3 * n_nodes_, 0);
    r.excess_volume.resize(n_cells_);
    Totals totals;
    for (std::size_t b = 0; b < batches_.size(); ++b) {
        const std::size_t first = b * n_lanes;
        const Volumes volumes{gather(state.mean_stress, first), gather(step.remembered, first),
                              step.stiffness};
        std::array<Lanes, 4> excess;
        const std::size_t first_branch = b * n_points * relaxation_.branches.size();
        if (step.branches.empty())
            evaluate_batch(batches_[b], state.displacement.data(), volumes, r.force.data(),
                           r.effective_force.data(), excess, totals);
        else
            evaluate_relaxing_batch(batches_[b], state.displacement.data(), volumes,
                                    {&step.branches[first_branch],
                                     step.branches.size() - first_branch, relaxation_.branches},
                                    r.force.data(), r.effective_force.data(), excess, totals);
        for (std::size_t l = 0; l < n_lanes && first + l < n_cells_; ++l)
            for (int m = 0; m < 4; ++m) r.excess_volume[first + l][m] = excess[m][l];
    }
    for (std::size_t i = 0; i < r.force.size(); ++i) r.effective_force[i] += r.force[i];
    r.energy = 0;
    for (std::size_t c = 0; c < n_cells_; ++c) r.energy += energy_of_volume(state, step, c);
    r.least_volume = 1;
    for (std::size_t l = 0; l < n_lanes; ++l) {
        r.energy += totals.energy[l];
        r.least_volume = std::min(r.least_volume, totals.least_volume[l]);
    }
}

double StrainedBody::root_of_cell() const {
    double volume = 0;
    for (const ElementBatch& batch : batches_)
        for (const Lanes& weight : batch.weight)
            for (std::size_t l = 0; l < n_lanes; ++l) volume += weight[l];
    return std::sqrt(volume / static_cast<double>(n_cells_));
}

double StrainedBody::bulk(std::size_t cell) const {
    return batches_[cell / n_lanes].bulk[cell % n_lanes];
}

void StrainedBody::add(std::span<const double> displacement, const Response& before,
                       const RelaxingStep& step, StrainedState& state) const {
    for (std::size_t b = 0; b < batches_.size(); ++b) {
        const std::size_t first = b * n_lanes;
        std::array<Lanes, 4> dilatation;
        dilate_batch(batches_[b], displacement.data(), dilatation);
        for (std::size_t l = 0; l < n_lanes && first + l < n_cells_; ++l)
            for (int m = 0; m < 4; ++m)
                state.mean_stress[first + l][m] +=
                    step.stiffness * bulk(first + l) *
                    (dilatation[m][l] + before.excess_volume[first + l][m]);
    }
    for (std::size_t i = 0; i < displacement.size(); ++i) state.displacement[i] += displacement[i];
}

}  // namespace tricontact::fem
