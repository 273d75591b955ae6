#pragma once

#include <array>

#include "fem/finite_strain/hyperelastic.h"
#include "fem/q2_space.h"

// Derivatives of a nodal field at 27 points are sums over 27 nodes: 27 x 27 x 3 products. The shape
// functions are products of three functions of one coordinate, so the sums can be taken one axis
// after the other (sum factorisation), 27 x 3 products each:
//
//   nodes (i, j, k) --x--> (q, j, k) --y--> (q, r, k) --z--> points (q, r, s)
//
// Three derivatives share the first contractions: eight in `differentiate`. `integrate` is the
// transpose, from fluxes at the points back to forces on the nodes.

namespace tricontact::fem {

constexpr int n_points = 27;  ///< Gauss points of an element, as many as nodes, x fastest in both

/// A scalar at the nodes of elements side by side, and its three derivatives at the Gauss points.
template <class T>
using Scalar = std::array<T, n_points>;
template <class T>
using Gradient = std::array<Scalar<T>, 3>;

/// The quadratic functions of one direction, in [-1, 1], and their derivatives at the three Gauss
/// points.
struct LineFunctions {
    std::array<std::array<double, 3>, 3> value{}, derivative{};  // [point][function]
    std::array<double, 3> weight{};
    constexpr LineFunctions() {
        constexpr double root = 0.7745966692414834;  // sqrt(3/5)
        constexpr std::array<double, 3> points{-root, 0, root};
        for (int q = 0; q < 3; ++q) {
            const double x = points[q];
            value[q] = {x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2};
            derivative[q] = {x - .5, -2 * x, x + .5};
        }
        weight = {5. / 9, 8. / 9, 5. / 9};
    }
};
inline constexpr LineFunctions line_functions;

/// One direction of a tensor product: `to` at the points of axis `axis` from `from` at its nodes,
/// or, transposed, back.
template <int axis, bool transposed, class T>
TRICONTACT_INLINE void contract(const std::array<std::array<double, 3>, 3>& f,
                                const Scalar<T>& from, Scalar<T>& to) {
    constexpr int stride = axis == 0 ? 1 : axis == 1 ? 3 : 9;
    for (int k = 0; k < 9; ++k) {
        const int first = axis == 0 ? 3 * k : axis == 1 ? k % 3 + 9 * (k / 3) : k;
        const T &v0 = from[first], &v1 = from[first + stride], &v2 = from[first + 2 * stride];
        for (int q = 0; q < 3; ++q)
            to[first + q * stride] = transposed ? f[0][q] * v0 + f[1][q] * v1 + f[2][q] * v2
                                                : f[q][0] * v0 + f[q][1] * v1 + f[q][2] * v2;
    }
}

/// Derivatives along the element's own axes.
template <class T>
TRICONTACT_INLINE void differentiate(const Scalar<T>& nodal, Gradient<T>& gradient) {
    const auto &n = line_functions.value, &d = line_functions.derivative;
    Scalar<T> along_x, across, both;
    contract<0, false>(d, nodal, along_x);
    contract<1, false>(n, along_x, both);
    contract<2, false>(n, both, gradient[0]);
    contract<0, false>(n, nodal, across);
    contract<1, false>(d, across, both);
    contract<2, false>(n, both, gradient[1]);
    contract<1, false>(n, across, both);
    contract<2, false>(d, both, gradient[2]);
}

/// What multiplies the nodes' values in the sum over points of flux times gradient.
template <class T>
TRICONTACT_INLINE void integrate(const Gradient<T>& flux, Scalar<T>& nodal) {
    const auto &n = line_functions.value, &d = line_functions.derivative;
    Scalar<T> a, b, c;
    contract<2, true>(n, flux[0], a);
    contract<1, true>(n, a, b);
    contract<0, true>(d, b, nodal);
    contract<2, true>(n, flux[1], a);
    contract<1, true>(d, a, b);
    contract<2, true>(d, flux[2], a);
    contract<1, true>(n, a, c);
    for (int k = 0; k < n_points; ++k) b[k] = b[k] + c[k];
    contract<0, true>(n, b, c);
    for (int k = 0; k < n_points; ++k) nodal[k] = nodal[k] + c[k];
}

/// n_lanes elements: their nodes, geometry and material. Places that no element fills repeat the
/// last one with the weight 0.
struct ElementBatch {
    std::array<std::array<int, n_lanes>, n_points> node;  // x fastest
    std::array<Lanes, n_points> weight;                   // [m^3]
    std::array<Matrix3<Lanes>, n_points> to_physical;     // [own axis][axis], [1/m]
    std::array<std::array<Lanes, 4>, n_points> pressure;  // orthonormal functions [m^-3/2]
    MooneyRivlin<Lanes> material;
    Lanes bulk;  // K [Pa]
};

/// VTK's number of the node at each place of a tensor product.
inline std::array<int, n_points> tensor_order() {
    std::array<int, n_points> order{};
    for (int i = 0; i < n_points; ++i) {
        const auto& at = node_positions[i];
        order[at[0] + 3 * at[1] + 9 * at[2]] = i;
    }
    return order;
}

using Nodal = std::array<Scalar<Lanes>, 3>;
using Own = std::array<Gradient<Lanes>, 3>;

TRICONTACT_INLINE void gather(const ElementBatch& batch, const double* field, Nodal& nodal) {
    for (int i = 0; i < n_points; ++i)
        for (std::size_t l = 0; l < n_lanes; ++l)
            for (int a = 0; a < 3; ++a) nodal[a][i][l] = field[3 * batch.node[i][l] + a];
}

/// H at Gauss point q.
template <class T>
TRICONTACT_INLINE Matrix3<T> physical_gradient(const ElementBatch& batch,
                                               const std::array<Gradient<T>, 3>& own, int q) {
    Matrix3<T> h;
    const auto& turn = batch.to_physical[q];
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
            h[a][b] =
                own[a][0][q] * turn[0][b] + own[a][1][q] * turn[1][b] + own[a][2][q] * turn[2][b];
    return h;
}

/// Replaces the gradients at Gauss point q by what integrate() wants of the stress P there.
template <class T>
TRICONTACT_INLINE void set_flux(const ElementBatch& batch, const Matrix3<T>& stress, int q,
                                std::array<Gradient<T>, 3>& own) {
    const auto& turn = batch.to_physical[q];
    const Lanes weight = batch.weight[q];
    for (int a = 0; a < 3; ++a)
        for (int r = 0; r < 3; ++r)
            own[a][r][q] = weight * (turn[r][0] * stress[a][0] + turn[r][1] * stress[a][1] +
                                     turn[r][2] * stress[a][2]);
}

}  // namespace tricontact::fem
