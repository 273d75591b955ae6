#pragma once

#include <cmath>

#include "contact/substrates/relaxation.h"
#include "fem/finite_strain/hyperelastic.h"

// A Maxwell branch at finite strains, after Reese and Govindjee (1998): the deformation is split
// into an elastic and a viscous one, F = F_e F_i. C_i = F_i' F_i, with det C_i = 1, is the branch's
// memory; it lives in the reference configuration, so that rotations do not touch it. The branch
// stores what the elasticity W of the spring beside it makes of the isochoric X = C_bar C_i^-1,
// C_bar = J^(-2/3) C, times its ratio g; the dashpot's law is theirs for a neo-Hookean spring,
//   tau C_i' = C_bar - 1/3 tr(X) C_i,
// which dissipates g/(2 tau) tr(T dev X) >= 0 per volume, T = 2 dev(X dW/dX): for c10, c01 >= 0
// both factors have their principal values in the same order. Small strains: a linear Maxwell
// element.
//
// The step: with m' = tr(X)/(3 tau) m the law is (m C_i)' = m C_bar/tau. If C_bar changes linearly
// in the step and tr X keeps its first value, the integral has a closed form: up to a factor, which
// det C_i = 1 determines (Shutov, Landgraf and Ihlemann 2013 did so with backward Euler), C_i is a
// mean of the last C_i and of C_bar at both ends with weights that are not negative. So it is
// positive definite for every duration, wrong by O(dt^2) of finite strains, and exact for small
// ones whatever the duration: RelaxationStep.
//
// As in hyperelastic.h everything is written in strains, E_bar = (C_bar - 1)/2 and
// E_i = (C_i - 1)/2, of which no digits are lost where they are small.

// Linear limit and the exponential formula of a step: docs/explanation/models/relaxation.md.

namespace tricontact::fem {

/// A symmetric tensor: xx, yy, zz, yz, xz, xy.
template <class T>
using Symmetric3 = std::array<T, 6>;

/// The cofactor of 1 + 2 E, its inverse if its determinant is 1.
template <class T>
TRICONTACT_INLINE Symmetric3<T> cofactor(const Symmetric3<T>& e) {
    const T x = 1. + 2. * e[0], y = 1. + 2. * e[1], z = 1. + 2. * e[2];
    return {y * z - 4. * e[3] * e[3],         x * z - 4. * e[4] * e[4],
            x * y - 4. * e[5] * e[5],         4. * e[4] * e[5] - 2. * e[3] * x,
            4. * e[3] * e[5] - 2. * e[4] * y, 4. * e[3] * e[4] - 2. * e[5] * z};
}

/// A B, of symmetric ones.
template <class T>
TRICONTACT_INLINE Matrix3<T> product(const Symmetric3<T>& a, const Symmetric3<T>& b) {
    constexpr std::array<std::array<int, 3>, 3> at{{{0, 5, 4}, {5, 1, 3}, {4, 3, 2}}};
    Matrix3<T> ab;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            ab[i][j] =
                a[at[i][0]] * b[at[0][j]] + a[at[i][1]] * b[at[1][j]] + a[at[i][2]] * b[at[2][j]];
    return ab;
}

/// tr(A B).
template <class T>
TRICONTACT_INLINE T trace_of_product(const Matrix3<T>& a, const Matrix3<T>& b) {
    T sum = a[0][0] * b[0][0];
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (i + j > 0) sum = sum + a[i][j] * b[j][i];
    return sum;
}

/// E_bar.
template <class T>
TRICONTACT_INLINE Symmetric3<T> isochoric_strain(const Strain<T>& strain) {
    const Invariants<T> i(strain);
    const auto& e = strain.green;
    const T factor = 1. / i.c, half = .5 * i.w;
    return {(e[0][0] - half) * factor, (e[1][1] - half) * factor, (e[2][2] - half) * factor,
            e[1][2] * factor,          e[0][2] * factor,          e[0][1] * factor};
}

constexpr double near_one = 1.5;
TRICONTACT_INLINE bool is_near_one(double a) {
    return a < near_one && a > 1 / near_one;
}
TRICONTACT_INLINE bool is_near_one(const Lanes& a) {
    bool near = true;
    for (std::size_t l = 0; l < n_lanes; ++l) near &= is_near_one(a[l]);
    return near;
}
template <class T>
TRICONTACT_INLINE bool is_near_one(const Dual<T>& a) {
    return is_near_one(a.value);
}

/// The strain of 1 + 2 E divided by the cube root of its determinant.
template <class T>
TRICONTACT_INLINE Symmetric3<T> unimodular(const Symmetric3<T>& e) {
    const T minor = e[1] * e[2] - e[3] * e[3];
    const T second = minor + e[0] * e[1] - e[5] * e[5] + e[0] * e[2] - e[4] * e[4];
    const T third =
        e[0] * minor - e[5] * (e[5] * e[2] - e[3] * e[4]) + e[4] * (e[5] * e[3] - e[1] * e[4]);
    const T y = 2. * (e[0] + e[1] + e[2] + 2. * second + 4. * third);  // determinant - 1
    // Means of tensors of determinant 1: it is 1 but for the square of their difference.
    const T c = is_near_one(y + 1.) ? cube_root<2>(y + 1.) : cube_root(y + 1.);
    const T factor = 1. / c, half = .5 * y / (c * c + c + 1.);
    return {(e[0] - half) * factor, (e[1] - half) * factor, (e[2] - half) * factor,
            e[3] * factor,          e[4] * factor,          e[5] * factor};
}

/// X - 1 = 2 (E_bar - E_i) C_i^-1.
template <class T>
TRICONTACT_INLINE Matrix3<T> branch_strain(const Symmetric3<T>& isochoric,
                                           const Symmetric3<T>& viscous) {
    Symmetric3<T> difference;
    for (int k = 0; k < 6; ++k) difference[k] = 2. * (isochoric[k] - viscous[k]);
    return product(difference, cofactor(viscous));
}

/// T [Pa] of X - 1 and of the spring's elasticity: T/J is to be added to isochoric_stress. Without
/// trace; not symmetric.
template <class T>
TRICONTACT_INLINE Matrix3<T> branch_stress(const MooneyRivlin<T>& spring, const Matrix3<T>& y) {
    const T linear = 2. * (spring.c10 + spring.c01 * (1. + y[0][0] + y[1][1] + y[2][2]));
    const T quadratic = 2. * spring.c01;
    Matrix3<T> t;
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
            t[a][b] = linear * y[a][b] -
                      quadratic * (y[a][0] * y[0][b] + y[a][1] * y[1][b] + y[a][2] * y[2][b]);
    const T mean = (t[0][0] + t[1][1] + t[2][2]) * (1. / 3);
    for (int a = 0; a < 3; ++a) t[a][a] = t[a][a] - mean;
    return t;
}

/// -tr(X - 1) and what else is left of the invariants for det X = 1, both of the second order.
template <class T>
struct BranchInvariants {
    T second, determinant;  ///< of X - 1

    TRICONTACT_INLINE explicit BranchInvariants(const Matrix3<T>& y) {
        const T minor = y[1][1] * y[2][2] - y[1][2] * y[2][1];
        second =
            minor + y[0][0] * y[1][1] - y[0][1] * y[1][0] + y[0][0] * y[2][2] - y[0][2] * y[2][0];
        determinant = y[0][0] * minor - y[0][1] * (y[1][0] * y[2][2] - y[1][2] * y[2][0]) +
                      y[0][2] * (y[1][0] * y[2][1] - y[1][1] * y[2][0]);
    }
    /// I1 - 3 = tr(X) - 3, not negative.
    TRICONTACT_INLINE T first() const { return -1. * (second + determinant); }
};

/// Stored [J/m^3].
template <class T>
TRICONTACT_INLINE T branch_energy(const MooneyRivlin<T>& spring, const Matrix3<T>& y) {
    const BranchInvariants<T> i(y);
    return spring.c10 * i.first() + spring.c01 * (i.first() - i.determinant);
}

/// Dissipated in the time tau [J/m^3].
template <class T>
TRICONTACT_INLINE T branch_dissipation(const MooneyRivlin<T>& spring, const Matrix3<T>& y) {
    return .5 * trace_of_product(branch_stress(spring, y), y);
}

/// Shares of the last C_i and of C_bar at the step's start and end in the new C_i, before its
/// determinant is made 1. They are not negative and their sum is 1.
struct ViscousShares {
    double viscous, start, end;

    /// A step of x relaxation times from tr(X)/3 = `rate`.
    ViscousShares(double x, double rate) {
        x *= rate;
        const double decay = std::exp(-x);
        const double mean = x == 0 ? 1 : std::isinf(x) ? 0 : -std::expm1(-x) / x;
        const double sum = rate * decay + (1 - decay);
        viscous = rate * decay / sum;
        start = (mean - decay) / sum;
        end = (1 - mean) / sum;
    }
};

/// Integrals over a step of x relaxation times of what is quadratic in a branch's strain
///   e(s) = e exp(-s x) + w mean(s x) s,   0 <= s <= 1,
/// from its values at s = 0, `middle` and 1: exact, by Simpson's rule in exp(-s x).
struct StepQuadrature {
    double middle;                 ///< s where exp(-s x) is halfway
    double middle_decay_exponent;  ///< middle x
    /// Weights of the mean over the step, for the work; of the integral over time/tau, for the
    /// dissipation. The last of infinitely many relaxation times multiplies what is zero.
    std::array<double, 3> mean, dissipation;

    explicit StepQuadrature(double x) {
        const contact::StepIntegrals s(x);
        middle_decay_exponent = -std::log1p(std::expm1(-x) / 2);
        middle = x == 0 ? .5 : std::isinf(x) ? 0 : middle_decay_exponent / x;
        if (std::isinf(x)) {
            mean = {0, 0, 1};
            dissipation = {0, 2, 0};
            return;
        }
        // Moments of v = (1 - exp(-s x))/(1 - exp(-x)).
        const double first = s.drift / s.mean, second = square_of(x, s) / (s.mean * s.mean);
        mean = {1 - 3 * first + 2 * second, 4 * (first - second), 2 * second - first};
        for (int k = 0; k < 3; ++k) dissipation[k] = x * mean[k];
    }

  private:
    // ww/x = (1 - 2 mean(x) + mean(2 x))/x^2, 1/3 at x = 0; its series where ww loses digits.
    static double square_of(double x, const contact::StepIntegrals& s) {
        constexpr double series_below = 0.1;
        if (x >= series_below) return s.ww / x;
        double power = 1. / 6, sum = 0, two = 4;
        for (int n = 2; n <= 13; ++n) {
            sum += (two - 2) * power;
            power *= -x / (n + 2);
            two *= 2;
        }
        return sum;
    }
};

}  // namespace tricontact::fem
