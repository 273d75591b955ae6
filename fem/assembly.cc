#include <algorithm>
#include <cmath>
#include <numeric>

#include "fem/discretisation.h"
#include "fem/memory.h"

// Two passes over the elements: `pattern` finds which unknowns couple, node by node (all three
// directions of two nodes couple or none), then `add` sums the element stiffnesses into the rows
// that are there. Only the lower triangle is kept, by columns, as CHOLMOD wants it.
//
// `held_rows`: K u over the held components, summed by direction, is the force of what holds the
// body. It costs three vectors and lets the reaction of the ground be compared with the applied
// force in every step, without the solution of the whole system (missing_reaction).
//
// Stresses come from the 2 x 2 x 2 Gauss points, where strains of quadratic elements have one order
// more than elsewhere (Barlow 1976).

namespace tricontact::fem {

namespace {

using Cell = std::array<int, 27>;

// Which of some cells each node has, by compressed rows.
struct CellsOfNodes {
    std::vector<int> start, cell;

    CellsOfNodes(const Q2Space& space, std::span<const int> some)
        : start(space.nodes.size() + 1, 0) {
        for (const int c : some)
            for (const int node : space.cells[c]) ++start[node + 1];
        for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
        cell.resize(start.back());
        std::vector<int> next(start.begin(), start.end() - 1);
        for (const int c : some)
            for (const int node : space.cells[c]) cell[next[node]++] = c;
    }
};

// A node's unknowns are coupled with those of all nodes of its elements. The cells of a node come
// first (CellsOfNodes), so that rows are found without a set: `seen_by` marks what the row has
// already.
// Calls visit(node, sorted unknowns of all nodes that share one of the cells with it).
template <typename Visit>
void for_neighbourhoods(const Q2Space& space, const Unknowns& unknowns, const CellsOfNodes& cells,
                        Visit visit) {
    std::vector<int> seen_by(space.nodes.size(), -1), neighbours;
    for (int node = 0; node < static_cast<int>(seen_by.size()); ++node) {
        neighbours.clear();
        for (int k = cells.start[node]; k < cells.start[node + 1]; ++k)
            for (const int other : space.cells[cells.cell[k]]) {
                if (seen_by[other] == node) continue;
                seen_by[other] = node;
                for (const int unknown : unknowns.of_node[other])
                    if (unknown >= 0) neighbours.push_back(unknown);
            }
        std::ranges::sort(neighbours);
        visit(node, neighbours);
    }
}

// Counted first, filled then: the largest arrays of an assembly are allocated once.
SparseMatrix pattern(const Q2Space& space, const Unknowns& unknowns, std::span<const int> some) {
    const CellsOfNodes cells(space, some);
    SparseMatrix matrix;
    matrix.n = unknowns.n;
    matrix.column_start.assign(unknowns.n + 1, 0);
    const auto below = [](const std::vector<int>& neighbours, int unknown) {
        return std::ranges::lower_bound(neighbours, unknown);
    };
    for_neighbourhoods(space, unknowns, cells, [&](int node, const std::vector<int>& neighbours) {
        for (const int u : unknowns.of_node[node])
            if (u >= 0) matrix.column_start[u + 1] = neighbours.end() - below(neighbours, u);
    });
    for (int u = 0; u < unknowns.n; ++u) matrix.column_start[u + 1] += matrix.column_start[u];
    reserve_large(matrix.row, matrix.column_start.back());
    matrix.row.resize(matrix.column_start.back());
    for_neighbourhoods(space, unknowns, cells, [&](int node, const std::vector<int>& neighbours) {
        for (const int u : unknowns.of_node[node])
            if (u >= 0)
                std::copy(below(neighbours, u), neighbours.end(),
                          matrix.row.begin() + matrix.column_start[u]);
    });
    reserve_large(matrix.value, matrix.row.size());
    matrix.value.assign(matrix.row.size(), 0.0);
    return matrix;
}

// The unknowns of one element: increasing, each with its row in the element's stiffness; and its
// held components.
struct LocalUnknowns {
    struct Pair {
        int unknown, local;
    };
    std::vector<Pair> free, held;

    void gather(const Cell& nodes, const Unknowns& unknowns) {
        free.clear();
        held.clear();
        for (int c = 0; c < 3; ++c)
            for (int i = 0; i < 27; ++i) {
                const int unknown = unknowns.of_node[nodes[i]][c];
                (unknown >= 0 ? free : held).push_back({unknown, c * 27 + i});
            }
        std::ranges::sort(free, {}, &Pair::unknown);
    }
};

// Unknowns of an element increase, and so do the rows of a column: one walk down the column finds
// all. What falls on a held component goes to the sums of its direction instead of the matrix,
// since held components have no row.
void add(const ElementStiffness& k, const LocalUnknowns& local, AssembledStiffness& to) {
    auto& [n, start, row, value] = to.matrix;
    for (std::size_t c = 0; c < local.free.size(); ++c) {
        const auto [column, local_column] = local.free[c];
        std::int64_t at = start[column];
        for (std::size_t r = c; r < local.free.size(); ++r) {
            while (row[at] != local.free[r].unknown) ++at;
            value[at] += k[local_column][local.free[r].local];
        }
        for (const auto& held : local.held)
            to.held_rows[held.local / 27][column] += k[local_column][held.local];
    }
}

using Stress = std::array<double, 6>;  // XX YY ZZ XY YZ XZ
constexpr int n_gauss = 8;

// Weight of Gauss point g (x fastest) in the trilinear function through the 2 x 2 x 2 Gauss points,
// at each node.
std::array<std::array<double, n_gauss>, 27> extrapolation() {
    std::array<std::array<double, n_gauss>, 27> weights{};
    for (int i = 0; i < 27; ++i)
        for (int g = 0; g < n_gauss; ++g) {
            weights[i][g] = 1;
            for (int d = 0; d < 3; ++d) {
                const double x = node_positions[i][d] - 1, side = (g >> d & 1) ? 1 : -1;
                weights[i][g] *= (1 + side * std::sqrt(3.) * x) / 2;  // points at +-1/sqrt(3)
            }
        }
    return weights;
}

using Tensor = std::array<std::array<double, 3>, 3>;

Tensor displacement_gradient(const ElementValues::Gradients& shape, const double* u) {
    Tensor gradient{};
    for (int a = 0; a < 3; ++a)
        for (int i = 0; i < 27; ++i)
            for (int b = 0; b < 3; ++b) gradient[a][b] += u[a * 27 + i] * shape[i][b];
    return gradient;
}

// sigma = 2 G dev eps + K theta, theta being the projected volumetric strain.
Stress stress_of(const Tensor& gradient, double theta, const Moduli& moduli) {
    const double g = moduli.shear, mean = (gradient[0][0] + gradient[1][1] + gradient[2][2]) / 3;
    const auto normal = [&](int a) {
        return 2 * g * (gradient[a][a] - mean) + moduli.bulk * theta;
    };
    const auto shear = [&](int a, int b) { return g * (gradient[a][b] + gradient[b][a]); };
    return {normal(0), normal(1), normal(2), shear(0, 1), shear(1, 2), shear(0, 2)};
}

// 2 G dev eps : dev eps
double shear_power(const Tensor& gradient, const Moduli& moduli) {
    const Stress s = stress_of(gradient, 0, moduli);  // deviator
    return (s[0] * s[0] + s[1] * s[1] + s[2] * s[2] +
            2 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5])) /
           (2 * moduli.shear);
}

// State of one element.
class ElementState {
  public:
    /// `pressure`: see BodyState; null: that of the displacements.
    ElementState(const ElementValues& volume, const Moduli& moduli, const std::array<double, 81>& u,
                 const std::array<double, 4>* pressure)
        : moduli_(moduli), u_(u), dilatation_(volume) {
        for (const double weight : volume.weights) volume_ += weight;
        for (int m = 0; m < 4; ++m)
            if (pressure)  // its functions are orthogonal, of squares 1 and 1/3 in the mean
                amplitude_[m] =
                    std::sqrt(volume_ / (m == 0 ? 1 : 3)) * (*pressure)[m] / moduli.bulk;
            else
                for (int r = 0; r < 81; ++r) amplitude_[m] += dilatation_.rows()[m][r] * u[r];
        for (const double a : amplitude_) energy_ += moduli.bulk * a * a / 2;
        for (std::size_t q = 0; q < volume.weights.size(); ++q) {
            energy_ += volume.weights[q] *
                       shear_power(displacement_gradient(volume.gradients[q], u.data()), moduli) /
                       2;
        }
    }

    double energy() const { return energy_; }  // [J]
    double volume() const { return volume_; }

    Stress stress_at(const std::array<double, 3>& x, const ElementValues::Gradients& shape) const {
        return stress_of(displacement_gradient(shape, u_.data()), dilatation_.at(x, amplitude_),
                         moduli_);
    }

  private:
    const Moduli& moduli_;
    const std::array<double, 81>& u_;
    Dilatation dilatation_;
    std::array<double, 4> amplitude_{};
    double energy_ = 0, volume_ = 0;
};

// Gives every node one point per region that it belongs to.
void add_points(const Q2Space& space, const Discretisation::NodalDisplacement& displacement,
                contact::Interior& interior) {
    std::array<std::vector<int>, meshes::n_regions> point_of_node;
    for (auto& points : point_of_node) points.assign(space.nodes.size(), -1);
    for (std::size_t c = 0; c < space.cells.size(); ++c) {
        const auto region = static_cast<std::uint8_t>(space.regions[c]);
        interior.region.push_back(region);
        auto& hex = interior.hexes.emplace_back();
        for (int i = 0; i < 27; ++i) {
            const int node = space.cells[c][i];
            int& point = point_of_node[region][node];
            if (point < 0) {
                point = static_cast<int>(interior.points.size());
                interior.points.push_back(space.nodes[node]);
                interior.displacement.push_back(displacement[node]);
            }
            hex[i] = point;
        }
    }
}

std::array<double, 81> element_displacement(const std::array<int, 27>& nodes,
                                            const Discretisation::NodalDisplacement& displacement) {
    std::array<double, 81> u{};
    for (int a = 0; a < 3; ++a)
        for (int i = 0; i < 27; ++i) u[a * 27 + i] = displacement[nodes[i]][a];
    return u;
}

void average(std::vector<Stress>& sums, const std::vector<std::array<int, 27>>& hexes) {
    std::vector<int> count(sums.size(), 0);
    for (const auto& hex : hexes)
        for (const int point : hex) ++count[point];
    for (std::size_t p = 0; p < sums.size(); ++p)
        for (double& s : sums[p]) s /= count[p];
}

}  // namespace

AssembledStiffness Discretisation::assemble() const {
    std::vector<int> all(space.cells.size());
    std::iota(all.begin(), all.end(), 0);
    return assemble(unknowns, all);
}

AssembledStiffness Discretisation::assemble(const Unknowns& of_cells,
                                            std::span<const int> cells) const {
    AssembledStiffness stiffness;
    stiffness.matrix = pattern(space, of_cells, cells);
    for (auto& row : stiffness.held_rows) row.assign(of_cells.n, 0.0);
    ElementValues values(space, 3);
    LocalUnknowns local;
    auto k = std::make_unique<ElementStiffness>();
    for (const int c : cells) {
        values.reinit(c);
        element_stiffness(values, moduli[static_cast<int>(space.regions[c])], *k);
        local.gather(space.cells[c], of_cells);
        add(*k, local, stiffness);
    }
    return stiffness;
}

std::array<double, 3> Discretisation::held_forces(const NodalDisplacement& displacement) const {
    std::array<double, 3> forces{};
    ElementValues values(space, 3);
    LocalUnknowns local;
    auto k = std::make_unique<ElementStiffness>();
    for (std::size_t c = 0; c < space.cells.size(); ++c) {
        const Cell& nodes = space.cells[c];
        local.gather(nodes, unknowns);
        if (local.held.empty()) continue;
        values.reinit(c);
        element_stiffness(values, moduli[static_cast<int>(space.regions[c])], *k);
        for (const auto& held : local.held)
            for (int r = 0; r < 81; ++r)
                forces[held.local / 27] +=
                    (*k)[held.local][r] * displacement[nodes[r % 27]][r / 27];
    }
    return forces;
}

contact::Interior Discretisation::undeformed() const {
    contact::Interior interior;
    add_points(space, NodalDisplacement(space.nodes.size(), {0, 0, 0}), interior);
    return interior;
}

contact::Interior Discretisation::interior(const BodyState& state,
                                           std::span<const double> force) const {
    const std::vector<double>& displacement = state.displacement;
    NodalDisplacement nodal(space.nodes.size(), {0, 0, 0});
    for (int u = 0; u < unknowns.n; ++u)
        nodal[unknowns.node_of_unknown[u]][unknowns.direction_of_unknown[u]] = displacement[u];
    if (!even_load.empty()) {
        const double mean =
            std::inner_product(even_load.begin(), even_load.end(), displacement.begin(), 0.);
        for (auto& u : nodal) u[2] -= mean;
    }
    contact::Interior interior;
    add_points(space, nodal, interior);
    interior.stress.assign(interior.points.size(), Stress{});
    static const auto weights = extrapolation();
    ElementValues volume(space, 3), barlow(space, 2);
    for (std::size_t c = 0; c < space.cells.size(); ++c) {
        volume.reinit(c);
        barlow.reinit(c);
        const auto u = element_displacement(space.cells[c], nodal);
        const ElementState element(volume, moduli[interior.region[c]], u,
                                   state.pressure.empty() ? nullptr : &state.pressure[c]);
        interior.strain_energy += element.energy();
        interior.energy_density.push_back(element.energy() / element.volume());
        for (int g = 0; g < n_gauss; ++g) {
            const Stress s = element.stress_at(barlow.points[g], barlow.gradients[g]);
            for (int i = 0; i < 27; ++i)
                for (int k = 0; k < 6; ++k)
                    interior.stress[interior.hexes[c][i]][k] += weights[i][g] * s[k];
        }
    }
    average(interior.stress, interior.hexes);
    for (int u = 0; u < unknowns.n; ++u)
        interior.applied[unknowns.direction_of_unknown[u]] += force[u];
    interior.base_reaction = state.pressure.empty() ? held_forces(nodal) : state.held_forces;
    // The node that is held has its part of that pressure already.
    const double even = std::accumulate(even_load.begin(), even_load.end(), 0.);
    (*interior.base_reaction)[2] -= even * interior.applied[2];
    if (surface.points.mirrored) {
        interior.strain_energy *= 2;
        for (auto* total : {&interior.applied, &*interior.base_reaction})
            *total = {2 * (*total)[0], 0, 2 * (*total)[2]};  // y cancels
    }
    return interior;
}

}  // namespace tricontact::fem
