#pragma once

#include <array>

#include "fem/finite_strain/lanes.h"

// Isochoric hyperelasticity from the displacement gradient H. All is written in the Green strain
// E = (H + H' + H'H)/2, so that nothing cancels at small strains: no 1 is ever subtracted from a
// number close to it.

// How digits are kept at small strains. With t, s, d the invariants of E (trace, second,
// determinant),
//
//   det C = J^2 = 1 + y,   y = 2 t + 4 s + 8 d,   c = J^(2/3) = (1 + y)^(1/3) = 1 + w
//
// and c^3 - 1 = y gives w = y/(c^2 + c + 1): no difference of near numbers. Then
//
//   J^(-2/3) I1 - 3 = (3 + 2 t)/c - 3 = 3 (1/c - 1) + 2 t/c
//                   = [y + 3 (1/c - 1)] - (4 s + 8 d) - 2 t w/c
//
// The bracket is of second order, though both of its terms are of first: with y = 3 w + 3 w^2 + w^3
// it is w^2 (6 + 4 w + w^2)/c, `first` in energy_density. I2 follows in the same way (`other`).

namespace tricontact::fem {

template <class T>
using Matrix3 = std::array<std::array<T, 3>, 3>;

/// Mooney-Rivlin (Rivlin 1948), W = c10 (J^(-2/3) I1 - 3) + c01 (J^(-4/3) I2 - 3) + K/2 (J - 1)^2,
/// I1 and I2 the invariants of C = F'F, J = det F; neo-Hookean with c01 = 0. At small strains an
/// elastic material of the shear modulus 2 (c10 + c01) and the bulk modulus K.
template <class T>
struct MooneyRivlin {
    T c10, c01;  ///< [Pa]
};

/// What a displacement gradient H [-] says about the shape and the volume.
template <class T>
struct Strain {
    Matrix3<T> green;     ///< E
    Matrix3<T> cofactor;  ///< of F = 1 + H: J F^-T
    T dilatation;         ///< J - 1

    TRICONTACT_INLINE explicit Strain(const Matrix3<T>& h) {
        for (int a = 0; a < 3; ++a)
            for (int b = a; b < 3; ++b) {
                T sum = h[a][b] + h[b][a];
                for (int c = 0; c < 3; ++c) sum = sum + h[c][a] * h[c][b];
                green[a][b] = green[b][a] = sum * .5;
            }
        const T trace = h[0][0] + h[1][1] + h[2][2];
        T of_minors = {}, determinant = {};
        for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b) {
                const int a1 = (a + 1) % 3, a2 = (a + 2) % 3, b1 = (b + 1) % 3, b2 = (b + 2) % 3;
                const T minor = h[a1][b1] * h[a2][b2] - h[a1][b2] * h[a2][b1];
                cofactor[a][b] = minor - h[b][a];
                if (a == b) {
                    cofactor[a][b] = cofactor[a][b] + trace + 1.;
                    of_minors = of_minors + minor;
                }
                if (a == 0) determinant = determinant + h[0][b] * minor;
            }
        dilatation = trace + of_minors + determinant;
    }
};

/// Invariants of E, and what they make of c = J^(2/3) = 1 + w.
template <class T>
struct Invariants {
    T trace, second, determinant;  ///< tr E, (tr^2 E - tr E^2)/2, det E
    T c, w;

    TRICONTACT_INLINE explicit Invariants(const Strain<T>& s) {
        const auto& e = s.green;
        trace = e[0][0] + e[1][1] + e[2][2];
        const T minor = e[1][1] * e[2][2] - e[1][2] * e[1][2];
        second =
            minor + e[0][0] * e[1][1] - e[0][1] * e[0][1] + e[0][0] * e[2][2] - e[0][2] * e[0][2];
        determinant = e[0][0] * minor - e[0][1] * (e[0][1] * e[2][2] - e[1][2] * e[0][2]) +
                      e[0][2] * (e[0][1] * e[1][2] - e[1][1] * e[0][2]);
        const T y = s.dilatation * (s.dilatation + 2.);  // J^2 - 1
        c = cube_root(y + 1.);
        w = y / (c * c + c + 1.);
    }
};

/// The isochoric part of the stored energy [J/m^3].
template <class T>
TRICONTACT_INLINE T energy_density(const MooneyRivlin<T>& material, const Strain<T>& strain) {
    const Invariants<T> i(strain);
    const T &w = i.w, &c = i.c;
    // J^2 - 1 + 3 (1/c - 1) and 2 (J^2 - 1) + 3 (1/c^2 - 1), both of the second order
    const T first = w * w * (6. + w * (4. + w)) / c;
    const T other = w * w * (15. + w * (20. + w * (10. + w * 2.))) / (c * c);
    const T rest = 4. * i.second + 8. * i.determinant;
    const T i1 = first - rest - 2. * i.trace * w / c;
    const T i2 =
        other - rest - 8. * i.determinant - 4. * (i.trace + i.second) * w * (2. + w) / (c * c);
    return material.c10 * i1 + material.c01 * i2;
}

/// M of the first Piola-Kirchhoff stress cof(F) M of the isochoric part [Pa]: a polynomial of E
/// without trace.
template <class T>
TRICONTACT_INLINE Matrix3<T> isochoric_stress(const MooneyRivlin<T>& material,
                                              const Strain<T>& strain) {
    const Invariants<T> i(strain);
    const auto& e = strain.green;
    const T jacobian = strain.dilatation + 1.;
    const T first = 4. * material.c10 / (i.c * jacobian);
    const T second = 4. * material.c01 / (i.c * i.c * jacobian);
    const T linear = first + second * (1. + 2. * i.trace);
    const T mean = (linear * i.trace - 2. * second * (i.trace * i.trace - 2. * i.second)) / 3.;
    Matrix3<T> m;
    for (int a = 0; a < 3; ++a)
        for (int b = a; b < 3; ++b) {
            T square = e[a][0] * e[0][b];
            for (int d = 1; d < 3; ++d) square = square + e[a][d] * e[d][b];
            m[a][b] = m[b][a] = linear * e[a][b] - 2. * second * square;
        }
    for (int a = 0; a < 3; ++a) m[a][a] = m[a][a] - mean;
    return m;
}

}  // namespace tricontact::fem
