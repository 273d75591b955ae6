// What is inside a StrainedBody.

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "fem/finite_strain/branches.h"
#include "fem/finite_strain/strained_body.h"

// Results are in the deformed body, computed from the reference configuration:
//
//   sigma = P F'/J = cof(F) (M + q 1) F'/J        Cauchy's stress, force per present area
//
// Stresses of the branches are added to M before (`beside`). To the nodes they are taken from the
// two points per direction where stresses of quadratic elements are most accurate, +-1/sqrt(3)
// (Barlow 1976); integration has three points, so a parabola through these is read there first.
//
// The energy is that of the body, the reaction the sum of nodal forces on held components: both
// come from `evaluate`, and compare with the work and the force of the contact in the audit.

namespace tricontact::fem {

namespace {

/// Of a batch at its Gauss points: Cauchy stress, XX YY ZZ XY YZ XZ [Pa], and energy [J].
struct BatchFields {
    std::array<Scalar<Lanes>, 6> stress;
    Lanes energy{};
};

template <class Beside>
BatchFields fields_of(const ElementBatch& batch, const Own& own,
                      const std::array<Lanes, 4>& mean_stress, const Beside& beside) {
    BatchFields fields;
    for (int q = 0; q < n_points; ++q) {
        const auto h = physical_gradient(batch, own, q);
        const Strain<Lanes> strain(h);
        auto stress = isochoric_stress(batch.material, strain);
        Lanes energy = energy_density(batch.material, strain);
        beside.add(batch, strain, q, stress, energy);
        fields.energy += batch.weight[q] * energy;
        for (int m = 0; m < 4; ++m)
            for (int a = 0; a < 3; ++a) stress[a][a] += mean_stress[m] * batch.pressure[q][m];
        // sigma = cof(F) M F'/J
        Matrix3<Lanes> half, gradient = h;
        for (int a = 0; a < 3; ++a) gradient[a][a] += 1.;
        for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b)
                half[a][b] = strain.cofactor[a][0] * stress[0][b] +
                             strain.cofactor[a][1] * stress[1][b] +
                             strain.cofactor[a][2] * stress[2][b];
        constexpr std::array<std::array<int, 2>, 6> places{
            {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}}};
        for (int k = 0; k < 6; ++k) {
            const auto [a, b] = places[k];
            fields.stress[k][q] = (half[a][0] * gradient[b][0] + half[a][1] * gradient[b][1] +
                                   half[a][2] * gradient[b][2]) /
                                  (strain.dilatation + 1.);
        }
    }
    return fields;
}

/// From values at the Gauss points to those at nodes, in one direction: by a parabola to the two
/// points where stresses of Q2 elements are most accurate (Barlow 1976), from there linearly.
std::array<std::array<double, 3>, 3> nodes_from_points() {
    const double barlow = std::sqrt(1. / 3), gauss = std::sqrt(3. / 5);
    std::array<std::array<double, 3>, 3> map{};
    for (int node = 0; node < 3; ++node)
        for (const double b : {-barlow, barlow}) {
            const double share = (1 + (node - 1) * b / (barlow * barlow)) / 2, x = b / gauss;
            const std::array<double, 3> parabola{x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2};
            for (int q = 0; q < 3; ++q) map[node][q] += share * parabola[q];
        }
    return map;
}

void extrapolate(Scalar<Lanes>& field) {
    static const auto map = nodes_from_points();
    Scalar<Lanes> x, y;
    contract<0, false>(map, field, x);
    contract<1, false>(map, x, y);
    contract<2, false>(map, y, field);
}

void differentiate(const ElementBatch& batch, const std::vector<double>& displacement, Own& own) {
    Nodal nodal;
    gather(batch, displacement.data(), nodal);
    for (int a = 0; a < 3; ++a) differentiate(nodal[a], own[a]);
}

}  // namespace

contact::Interior StrainedBody::interior(const Discretisation& discretisation,
                                         const StrainedState& state,
                                         const RelaxingStep& step) const {
    const Q2Space& space = discretisation.space;
    const auto order = tensor_order();
    contact::Interior inside = discretisation.undeformed();
    std::vector<int> count(inside.points.size());
    inside.stress.assign(inside.points.size(), {});
    const std::size_t n_branches = relaxation_.branches.size();
    const double both_sides = discretisation.surface.points.mirrored ? 2 : 1;
    for (std::size_t c = 0; c < n_cells_; ++c) {
        const std::size_t b = c / n_lanes, lane = c % n_lanes;
        if (lane > 0) continue;
        Own own;
        differentiate(batches_[b], state.displacement, own);
        const auto mean_stress = fem::gather(state.mean_stress, c);
        const std::size_t first = b * n_points * n_branches;
        BatchFields fields =
            step.branches.empty()
                ? fields_of(batches_[b], own, mean_stress, NoBranches{})
                : fields_of(batches_[b], own, mean_stress,
                            Branches{&step.branches[first], step.branches.size() - first,
                                     relaxation_.branches});
        for (auto& component : fields.stress) extrapolate(component);
        for (std::size_t l = 0; l < n_lanes && c + l < n_cells_; ++l) {
            Lanes volume{};
            for (const Lanes& weight : batches_[b].weight) volume += weight;
            inside.energy_density.push_back(
                (fields.energy[l] + energy_of_volume(state, step, c + l)) / volume[l]);
            for (int i = 0; i < n_points; ++i) {
                const int point = inside.hexes[c + l][order[i]];
                ++count[point];
                for (int k = 0; k < 6; ++k) inside.stress[point][k] += fields.stress[k][i][l];
                for (int a = 0; a < 3; ++a)
                    inside.displacement[point][a] =
                        state
                            .displacement[3 * static_cast<std::size_t>(batches_[b].node[i][l]) + a];
            }
        }
    }
    for (std::size_t p = 0; p < count.size(); ++p)
        for (double& s : inside.stress[p]) s /= count[p];

    Response response;
    evaluate(state, step, response);
    inside.strain_energy = both_sides * response.energy;
    inside.base_reaction = {0, 0, 0};
    for (std::size_t node = 0; node < space.nodes.size(); ++node)
        for (int a = 0; a < 3; ++a)
            if (discretisation.unknowns.of_node[node][a] < 0)
                (*inside.base_reaction)[a] += both_sides * response.force[3 * node + a];
    if (both_sides > 1) (*inside.base_reaction)[1] = 0;
    return inside;
}

StrainedBody::Extremes StrainedBody::extremes(const StrainedState& state) const {
    Extremes extremes;
    for (const ElementBatch& batch : batches_) {
        Own own;
        differentiate(batch, state.displacement, own);
        for (int q = 0; q < n_points; ++q) {
            const Strain<Lanes> strain(physical_gradient(batch, own, q));
            Lanes squares{};
            for (int a = 0; a < 3; ++a)
                for (int b = 0; b < 3; ++b) squares += strain.green[a][b] * strain.green[a][b];
            for (std::size_t l = 0; l < n_lanes; ++l) {
                // With l1 >= 1: l1^2 - 1 <= 2 |E|, l1 - l3 <= l1^2 - l3^2 <= 2 sqrt(2) |E|.
                const double most = 2 * std::sqrt(squares[l]);
                if (1 + most <= extremes.stretch * extremes.stretch &&
                    std::numbers::sqrt2 * most <= extremes.shear)
                    continue;
                Eigen::Matrix3d green;
                for (int a = 0; a < 3; ++a)
                    for (int b = 0; b < 3; ++b) green(a, b) = strain.green[a][b][l];
                Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal;
                principal.computeDirect(green, Eigen::EigenvaluesOnly);
                const auto stretch = [&](int k) {
                    return std::sqrt(1 + 2 * principal.eigenvalues()[k]);
                };
                extremes.stretch = std::max(extremes.stretch, stretch(2));
                extremes.shear = std::max(extremes.shear, stretch(2) - stretch(0));
            }
        }
    }
    return extremes;
}

}  // namespace tricontact::fem
