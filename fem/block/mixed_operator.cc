#include "fem/block/mixed_operator.h"

#include <algorithm>

#include "fem/finite_strain/lanes.h"
#include "fem/quadratic_line.h"

// Sum factorisation (Orszag 1980): gradients at the 27 Gauss points by products with 3 x 3 matrices
// along one direction after another, eight elements of a row along x side by side. Rows of elements
// that share no node are added up by threads at the same time; the four kinds of rows come in
// order, so that sums do not depend on the number of threads.

namespace tricontact::fem {

namespace {

const QuadraticLine line;

using Values = std::array<Lanes, 27>;  // x fastest

// to_q = sum_i matrix[q][i] from_i along a direction of stride 1, 3 or 9.
template <int stride, bool transposed, bool added>
TRICONTACT_INLINE void along(const QuadraticLine::Matrix& matrix, const Values& from, Values& to) {
    for (int a = 0; a < 9; ++a) {
        const int base = stride == 1 ? 3 * a : stride == 3 ? a % 3 + a / 3 * 9 : a;
        for (int q = 0; q < 3; ++q) {
            Lanes sum = added ? to[base + q * stride] : Lanes(0);
            for (int i = 0; i < 3; ++i)
                sum += Lanes(transposed ? matrix[i][q] : matrix[q][i]) * from[base + i * stride];
            to[base + q * stride] = sum;
        }
    }
}

struct Brick {
    Lanes inverse_x, volume;
    double inverse_y, inverse_z, shear, inverse_bulk;
};

// Derivatives of one component along x, y, z at the points of the unit cube.
TRICONTACT_INLINE void gradients(const Values& u, Values& g_x, Values& g_y, Values& g_z) {
    Values at_x, at_xy, slope;
    along<1, false, false>(line.value, u, at_x);
    along<1, false, false>(line.slope, u, slope);
    along<3, false, false>(line.value, slope, at_xy);
    along<9, false, false>(line.value, at_xy, g_x);
    along<3, false, false>(line.slope, at_x, slope);
    along<9, false, false>(line.value, slope, g_y);
    along<3, false, false>(line.value, at_x, at_xy);
    along<9, false, false>(line.slope, at_xy, g_z);
}

// The transpose.
TRICONTACT_INLINE void divergence(const Values& s_x, const Values& s_y, const Values& s_z,
                                  Values& to) {
    Values a, b, c;
    along<9, true, false>(line.value, s_y, a);
    along<3, true, false>(line.slope, a, b);
    along<9, true, false>(line.slope, s_z, a);
    along<3, true, true>(line.value, a, b);
    along<1, true, false>(line.value, b, to);
    along<9, true, false>(line.value, s_x, a);
    along<3, true, false>(line.value, a, c);
    along<1, true, true>(line.slope, c, to);
}

// Of the dilatation times the functions of the pressures, over the unit cube.
TRICONTACT_INLINE std::array<Lanes, 4> dilatations(const Brick& brick,
                                                   const std::array<std::array<Values, 3>, 3>& g) {
    std::array<Lanes, 4> sums{0., 0., 0., 0.};
    for (int q = 0; q < 27; ++q) {
        const int i = q % 3, j = q / 3 % 3, k = q / 9;
        const Lanes at = Lanes(line.weight[i] * line.weight[j] * line.weight[k]) *
                         (g[0][0][q] * brick.inverse_x + g[1][1][q] * Lanes(brick.inverse_y) +
                          g[2][2][q] * Lanes(brick.inverse_z));
        sums[0] += at;
        sums[1] += Lanes(line.centred[i]) * at;
        sums[2] += Lanes(line.centred[j]) * at;
        sums[3] += Lanes(line.centred[k]) * at;
    }
    return sums;
}

// Gradients become stresses, with these pressures, times what they are integrated with.
TRICONTACT_INLINE void stresses(const Brick& brick, const std::array<Lanes, 4>& p,
                                std::array<std::array<Values, 3>, 3>& g) {
    for (int q = 0; q < 27; ++q) {
        const int i = q % 3, j = q / 3 % 3, k = q / 9;
        const double x = line.centred[i], y = line.centred[j], z = line.centred[k];
        const Lanes weight = brick.volume * Lanes(line.weight[i] * line.weight[j] * line.weight[k]);
        Lanes d[3][3];
        for (int a = 0; a < 3; ++a) {
            d[a][0] = g[a][0][q] * brick.inverse_x;
            d[a][1] = g[a][1][q] * Lanes(brick.inverse_y);
            d[a][2] = g[a][2][q] * Lanes(brick.inverse_z);
        }
        const Lanes dilatation = d[0][0] + d[1][1] + d[2][2];
        const Lanes pressure = p[0] + Lanes(x) * p[1] + Lanes(y) * p[2] + Lanes(z) * p[3];
        const Lanes mean = pressure - Lanes(2. / 3 * brick.shear) * dilatation;
        for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b) {
                Lanes s = Lanes(brick.shear) * (d[a][b] + d[b][a]);
                if (a == b) s += mean;
                const Lanes scale = b == 0   ? brick.inverse_x
                                    : b == 1 ? Lanes(brick.inverse_y)
                                             : Lanes(brick.inverse_z);
                g[a][b][q] = weight * scale * s;
            }
    }
}

struct Row {
    const double *x, *scale;  // scale: of pressures that are eliminated
    double* to;
    std::size_t n_nodes, n_elements, line_stride, plane_stride, first_node, first_element;
    const double* edge;  // along x
    int n;
    double edge_y, edge_z;
    Moduli moduli;
};

TRICONTACT_LANES_CLONES void apply_to_row(const Row& row) {
    std::array<Values, 3> u;
    std::array<std::array<Values, 3>, 3> g;
    std::array<Lanes, 4> p, inverse_scale;
    for (int first = 0; first < row.n; first += static_cast<int>(n_lanes)) {
        const int n = std::min(static_cast<int>(n_lanes), row.n - first);
        Brick brick{0., 0., 1 / row.edge_y, 1 / row.edge_z, row.moduli.shear, 1 / row.moduli.bulk};
        for (int l = 0; l < static_cast<int>(n_lanes); ++l) {
            const int e = first + std::min(l, n - 1);
            brick.inverse_x[l] = 1 / row.edge[e];
            brick.volume[l] = row.edge[e] * row.edge_y * row.edge_z;
            for (int c = 0; c < 3; ++c)
                for (int a = 0; a < 9; ++a) {
                    const double* const from = row.x + c * row.n_nodes + row.first_node + 2 * e +
                                               a % 3 * row.line_stride + a / 3 * row.plane_stride;
                    for (int i = 0; i < 3; ++i) u[c][3 * a + i][l] = from[i];
                }
            for (int m = 0; m < 4; ++m) {
                const std::size_t at = m * row.n_elements + row.first_element + e;
                p[m][l] = row.x[3 * row.n_nodes + at];
                inverse_scale[m][l] = row.scale ? 1 / row.scale[at] : 0;
            }
        }
        for (int c = 0; c < 3; ++c) gradients(u[c], g[c][0], g[c][1], g[c][2]);
        const std::array<Lanes, 4> sums = dilatations(brick, g);
        std::array<Lanes, 4> rest;
        for (int m = 0; m < 4; ++m) {
            rest[m] = brick.volume * sums[m];
            if (row.scale)
                rest[m] = p[m] = inverse_scale[m] * (rest[m] - p[m]);
            else
                rest[m] += Lanes(m == 0 ? -brick.inverse_bulk : -brick.inverse_bulk / 3) *
                           brick.volume * p[m];
        }
        stresses(brick, p, g);
        for (int c = 0; c < 3; ++c) divergence(g[c][0], g[c][1], g[c][2], u[c]);
        for (int c = 0; c < 3; ++c)
            for (int a = 0; a < 9; ++a) {
                double* const at = row.to + c * row.n_nodes + row.first_node + 2 * first +
                                   a % 3 * row.line_stride + a / 3 * row.plane_stride;
                for (int l = 0; l < n; ++l)
                    for (int i = 0; i < 3; ++i) at[2 * l + i] += u[c][3 * a + i][l];
            }
        for (int m = 0; m < 4; ++m)
            for (int l = 0; l < n; ++l)
                row.to[3 * row.n_nodes + m * row.n_elements + row.first_element + first + l] =
                    rest[m][l];
    }
}

}  // namespace

MixedOperator::MixedOperator(const BlockGrid& grid, int n_threads)
    : grid_(grid), n_threads_(n_threads), n_nodes_(grid.n_nodes()), n_elements_(grid.n_elements()) {
    for (int e = 0; e < grid_.axes[0].n_elements(); ++e) edges_x_.push_back(grid_.axes[0].edge(e));
}

void MixedOperator::apply_row(int e_y, int e_z, const double* x, const double* scale,
                              double* to) const {
    const auto& [along_x, along_y, along_z] = grid_.axes;
    const auto n_x = static_cast<std::size_t>(along_x.n_nodes());
    apply_to_row({.x = x,
                  .scale = scale,
                  .to = to,
                  .n_nodes = n_nodes_,
                  .n_elements = n_elements_,
                  .line_stride = n_x,
                  .plane_stride = n_x * along_y.n_nodes(),
                  .first_node = grid_.node(0, 2 * e_y, 2 * e_z),
                  .first_element = (static_cast<std::size_t>(e_z) * along_y.n_elements() + e_y) *
                                   along_x.n_elements(),
                  .edge = edges_x_.data(),
                  .n = along_x.n_elements(),
                  .edge_y = along_y.edge(e_y),
                  .edge_z = along_z.edge(e_z),
                  .moduli = grid_.moduli[e_z]});
}

void MixedOperator::apply_free(std::span<const double> x, const double* scale,
                               std::span<double> to) const {
    std::ranges::fill(to, 0.);
    for (int kind = 0; kind < 4; ++kind) {
        const int first_y = kind % 2, first_z = kind / 2;
        const int n_y = (grid_.axes[1].n_elements() - first_y + 1) / 2;
        const int n_z = (grid_.axes[2].n_elements() - first_z + 1) / 2;
#pragma omp parallel for num_threads(n_threads_) schedule(dynamic) if (n_threads_ > 1)
        for (int row = 0; row < n_y * n_z; ++row)
            apply_row(first_y + 2 * (row % n_y), first_z + 2 * (row / n_y), x.data(), scale,
                      to.data());
    }
}

template <class Visit>
void MixedOperator::for_held(Visit visit) const {
    const std::array<int, 3> n{grid_.axes[0].n_nodes(), grid_.axes[1].n_nodes(),
                               grid_.axes[2].n_nodes()};
    for (int d = 0; d < 3; ++d)
        for (int end = 0; end < 2; ++end)
            for (int c = 0; c < 3; ++c) {
                if (!(grid_.axes[d].held[end] >> c & 1)) continue;
                std::array<int, 3> at{};
                const int a = (d + 1) % 3, b = (d + 2) % 3;
                at[d] = end == 0 ? 0 : n[d] - 1;
                for (at[a] = 0; at[a] < n[a]; ++at[a])
                    for (at[b] = 0; at[b] < n[b]; ++at[b])
                        visit(c, c * n_nodes_ + grid_.node(at[0], at[1], at[2]));
            }
}

void MixedOperator::clear_held(std::span<double> x) const {
    for_held([&](int, std::size_t at) { x[at] = 0; });
}

void MixedOperator::apply(std::span<const double> x, std::span<double> to) const {
    apply_free(x, nullptr, to);
    clear_held(to);
}

void MixedOperator::apply_eliminated(std::span<const double> x, std::span<const double> scale,
                                     std::span<double> to) const {
    apply_free(x, scale.data(), to);
    clear_held(to);
}

std::array<double, 3> MixedOperator::held_forces(std::span<const double> x) const {
    std::vector<double> forces(size());
    apply_free(x, nullptr, forces);
    std::array<double, 3> sums{};
    for_held([&](int c, std::size_t at) {
        sums[c] += forces[at];
        forces[at] = 0;  // edges of the block lie on two sides
    });
    return sums;
}

// Displacements carry less of linear pressures than of constant ones; fewest iterations on graded
// meshes, by a tenth, at this ratio.
std::vector<double> MixedOperator::pressure_scale(double share, double of_bulk) const {
    constexpr double carried = .65;
    const auto& [along_x, along_y, along_z] = grid_.axes;
    std::vector<double> scale(4 * n_elements_);
    std::size_t e = 0;
    for (int k = 0; k < along_z.n_elements(); ++k)
        for (int j = 0; j < along_y.n_elements(); ++j)
            for (int i = 0; i < along_x.n_elements(); ++i, ++e) {
                const double volume = along_x.edge(i) * along_y.edge(j) * along_z.edge(k);
                const Moduli& m = grid_.moduli[k];
                const double of_constant = share / m.shear + of_bulk / m.bulk,
                             of_linear = (share * carried / m.shear + of_bulk / m.bulk) / 3;
                for (int p = 0; p < 4; ++p)
                    scale[p * n_elements_ + e] = volume * (p == 0 ? of_constant : of_linear);
            }
    return scale;
}

}  // namespace tricontact::fem
