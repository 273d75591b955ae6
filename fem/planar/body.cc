#include "fem/planar/body.h"

#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "fem/condensation.h"
#include "fem/planar/section_unknowns.h"
#include "fem/planar/whole_section.h"

// The condensation itself is that of three dimensions.

namespace tricontact::fem::planar {

namespace {

/// `held_row`: the sum of K u over all components along z that are held is its product with u.
struct Stiffness {
    SparseMatrix matrix;
    std::vector<double> held_row;
};

Stiffness assemble(const BodyProblem& problem, const SectionUnknowns& unknowns) {
    const Moduli moduli = moduli_of(problem.material, problem.largest_bulk_ratio);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(problem.mesh.cells.size() * 171);
    std::vector<double> held_row(unknowns.node_of_unknown.size(), 0);
    ElementStiffness k;
    for (const auto& cell : problem.mesh.cells) {
        ElementNodes nodes;
        std::array<int, n_element_unknowns> unknown{};
        for (int i = 0; i < 9; ++i) {
            nodes[i] = problem.mesh.nodes[cell[i]];
            for (int a = 0; a < 2; ++a) unknown[a * 9 + i] = unknowns.of_node[cell[i]][a];
        }
        element_stiffness(nodes, problem.solid, moduli, k);
        for (int r = 0; r < n_element_unknowns; ++r)
            for (int c = 0; c < n_element_unknowns; ++c) {
                if (unknown[c] < 0) continue;
                if (unknown[r] >= unknown[c]) entries.emplace_back(unknown[r], unknown[c], k[r][c]);
                if (unknown[r] < 0 && r >= n_element_unknowns / 2) held_row[unknown[c]] += k[r][c];
            }
    }
    const auto n = static_cast<int>(unknowns.node_of_unknown.size());
    Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t> lower(n, n);
    lower.setFromTriplets(entries.begin(), entries.end());
    const auto n_entries = lower.nonZeros();
    return {{n,
             {lower.outerIndexPtr(), lower.outerIndexPtr() + n + 1},
             {lower.innerIndexPtr(), lower.innerIndexPtr() + n_entries},
             {lower.valuePtr(), lower.valuePtr() + n_entries}},
            std::move(held_row)};
}

/// From x, z of the free unknowns to the frames of all nodes.
std::vector<double> in_frames(const BodyProblem& problem, const SectionUnknowns& unknowns,
                              const SectionSurface& surface,
                              const std::vector<double>& compliance) {
    const std::size_t n = surface.nodes.size();
    const std::size_t n_free = unknowns.node_of_unknown.size() - unknowns.n_interior;
    std::vector<double> turned(4 * n * n, 0);
    const auto entry = [&](std::size_t i, int a, std::size_t k, int b) {
        const int r = unknowns.of_node[surface.nodes[i]][a] - unknowns.n_interior;
        const int c = unknowns.of_node[surface.nodes[k]][b] - unknowns.n_interior;
        return r < 0 || c < 0 ? 0 : compliance[c * n_free + r];
    };
    for (std::size_t k = 0; k < n; ++k) {
        const auto of_k = frame_at(problem, surface.along[k]);
        for (std::size_t i = 0; i < n; ++i) {
            const auto of_i = frame_at(problem, surface.along[i]);
            for (int a = 0; a < 2; ++a)
                for (int b = 0; b < 2; ++b) {
                    const double value = entry(i, a, k, b);
                    for (int d = 0; d < 2; ++d)
                        for (int e = 0; e < 2; ++e)
                            turned[(e * n + k) * 2 * n + d * n + i] +=
                                of_i[d][a] * value * of_k[e][b];
                }
        }
    }
    return turned;
}

// The reaction to a unit force on a component is minus the displacement there when all that is held
// along z moves by one (reciprocity), and a body that is held moves with it as a whole.
std::vector<double> missing_reaction(const BodyProblem& problem, const SectionUnknowns& unknowns,
                                     const SectionSurface& surface,
                                     const Condensation& condensation,
                                     std::vector<double> held_row) {
    for (double& k : held_row) k = -k;
    const std::vector<double> moved = condensation.solve(held_row);
    const std::size_t n = surface.nodes.size();
    std::vector<double> missing(2 * n, 0);
    for (std::size_t i = 0; i < n; ++i) {
        const auto frame = frame_at(problem, surface.along[i]);
        for (int a = 0; a < 2; ++a) {
            const int unknown = unknowns.of_node[surface.nodes[i]][a];
            if (unknown < 0) continue;
            const double along_z = (a == 1 ? 1 : 0) - moved[unknown];
            for (int d = 0; d < 2; ++d) missing[d * n + i] += frame[d][a] * along_z;
        }
    }
    return missing;
}

/// Forces along z of a pressure all over the support, one in all, on the free unknowns.
std::vector<double> even_load(const BodyProblem& problem, const SectionUnknowns& unknowns) {
    // Gauss points of [0, 1]: exact to degree 5.
    constexpr std::array<double, 3> at{.1127016653792583, .5, .8872983346207417};
    constexpr std::array<double, 3> weight{5. / 18, 8. / 18, 5. / 18};
    std::vector<double> load(unknowns.node_of_unknown.size(), 0);
    double whole = 0;
    for (const auto& [nodes, boundary] : problem.mesh.edges) {
        if (boundary != Boundary::support) continue;
        std::array<double, 3> x{};
        for (std::size_t i = 0; i < 3; ++i) x[i] = problem.mesh.nodes[nodes[i]][0];
        for (std::size_t q = 0; q < at.size(); ++q) {
            const double s = at[q];
            const std::array<double, 3> shape{(1 - s) * (1 - 2 * s), s * (2 * s - 1),
                                              4 * s * (1 - s)};  // ends, middle
            const double here = shape[0] * x[0] + shape[1] * x[1] + shape[2] * x[2];
            const double slope = (4 * s - 3) * x[0] + (4 * s - 1) * x[1] + (4 - 8 * s) * x[2];
            const double area = weight[q] * std::abs(slope) * extent(problem.solid, here);
            whole += area;
            for (std::size_t i = 0; i < 3; ++i)
                if (const int unknown = unknowns.of_node[nodes[i]][1]; unknown >= 0)
                    load[unknown] += area * shape[i];
        }
    }
    for (double& force : load) force /= whole;
    return load;
}

// The forces f on the contact press against the load -L (R'f), L of the resultant one and R the
// displacement by one along z: the node that is pinned carries nothing. Displacements count from
// the mean L'u, the one that does the load's work. With w = K^-1 L, then
//   C - w R' - R w' + (L'w) R R'.
void press_evenly(const BodyProblem& problem, const SectionUnknowns& unknowns,
                  const SectionSurface& surface, const Condensation& condensation,
                  const std::vector<double>& load, std::vector<double>& compliance) {
    const std::vector<double> moved = condensation.solve(load);
    const double mean = std::inner_product(load.begin(), load.end(), moved.begin(), 0.);
    const std::size_t n = surface.nodes.size();
    std::vector<double> along(2 * n, 0), rigid(2 * n, 0);
    for (std::size_t i = 0; i < n; ++i) {
        const auto frame = frame_at(problem, surface.along[i]);
        for (std::size_t d = 0; d < 2; ++d) {
            rigid[d * n + i] = frame[d][1];
            for (std::size_t a = 0; a < 2; ++a)
                if (const int unknown = unknowns.of_node[surface.nodes[i]][a]; unknown >= 0)
                    along[d * n + i] += frame[d][a] * moved[unknown];
        }
    }
    for (std::size_t k = 0; k < 2 * n; ++k)
        for (std::size_t i = 0; i < 2 * n; ++i)
            compliance[k * 2 * n + i] +=
                mean * rigid[i] * rigid[k] - along[i] * rigid[k] - rigid[i] * along[k];
}

}  // namespace

CondensedSection condense(const BodyProblem& problem) {
    const SectionSurface surface = surface_of(problem);
    const SectionUnknowns unknowns = number_unknowns(problem, surface);
    Stiffness stiffness = assemble(problem, unknowns);
    Condensation condensation(stiffness.matrix, unknowns.node_of_unknown, unknowns.n_interior);
    condensation.factorise();
    CondensedSection body;
    body.solid = problem.solid;
    body.is_pinned = is_loose(problem.support);
    body.along = surface.along;
    for (const int node : surface.nodes) body.x.push_back(problem.mesh.nodes[node][0]);
    body.edges = surface.edges;
    body.compliance = in_frames(problem, unknowns, surface, condensation.compliance());
    std::vector<double> load;
    if (counts_from_mean(problem.support)) {
        load = even_load(problem, unknowns);
        press_evenly(problem, unknowns, surface, condensation, load, body.compliance);
    }
    body.missing_reaction =
        missing_reaction(problem, unknowns, surface, condensation, std::move(stiffness.held_row));
    body.whole = std::make_shared<WholeSection>(problem, surface, unknowns, std::move(condensation),
                                                std::move(load));
    return body;
}

}  // namespace tricontact::fem::planar
