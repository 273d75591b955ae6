#include "theory/half_space_interior.h"

#include <numbers>

namespace tricontact::theory {

namespace {

/// Derivatives by the directions 0, 1, 2 in any order.
class Harmonic {
  public:
    explicit Harmonic(const HarmonicDerivatives& of) : of_(of) {}

    double l(int i) const { return of_[L_x + i]; }
    double l(int i, int j) const {
        const int n_z = (i == 2) + (j == 2);
        if (n_z == 2) return -(of_[L_xx] + of_[L_yy]);
        if (n_z == 1) return of_[L_xz + (i == 2 ? j : i)];
        return of_[L_xx + i + j];
    }
    double l(int i, int j, int k) const {
        const int n_z = (i == 2) + (j == 2) + (k == 2);
        const int rest = i + j + k - 2 * n_z;  // how many y
        if (n_z == 3) return -(of_[L_xxz] + of_[L_yyz]);
        if (n_z == 2) return -(of_[L_xxx + rest] + of_[L_xxx + rest + 2]);
        return of_[(n_z == 1 ? L_xxz : L_xxx) + rest];
    }
    double m(int i, int j) const { return of_[M_xx + i + j]; }
    double m(int i, int j, int k) const { return of_[M_xxx + i + j + k]; }

  private:
    const HarmonicDerivatives& of_;
};

// Of stresses: i and j of XX YY ZZ XY YZ XZ.
constexpr std::array<std::array<int, 2>, 6> indices = {
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}}};

/// 2 pi sigma_ij under a pressing force.
double pressed_stress(const Harmonic& h, double nu, double z, int i, int j) {
    const double deep = -z * h.l(i, j, 2);
    if (i < 2 && j < 2) return deep - (1 - 2 * nu) * h.l(i, j) + (i == j ? 2 * nu * h.l(2, 2) : 0);
    return i == j ? deep + h.l(2, 2) : deep;
}

/// 2 pi sigma_ij under a force along d.
double sheared_stress(const Harmonic& h, double nu, double z, int i, int j, int d) {
    const double deep = -z * h.l(i, j, d);
    if (i < 2 && j < 2)
        return deep + (i == d ? h.l(2, j) : 0) + (j == d ? h.l(2, i) : 0) + 2 * nu * h.m(i, j, d) +
               (i == j ? 2 * nu * h.l(2, d) : 0);
    return i == d && j == 2 ? deep + h.l(2, 2) : deep;
}

}  // namespace

InteriorResponse half_space_response(const contact::Material& material, double depth,
                                     const HarmonicDerivatives& derivatives) {
    const Harmonic h(derivatives);
    const double nu = material.poisson, z = depth;
    const double soft = 1 / (4 * std::numbers::pi * material.shear_modulus());
    InteriorResponse out;
    for (int i = 0; i < 2; ++i) {
        out.displacement[i][2] = soft * (-z * h.l(i, 2) - (1 - 2 * nu) * h.l(i));
        out.displacement[2][i] = soft * (-z * h.l(i, 2) + (1 - 2 * nu) * h.l(i));
        for (int d = 0; d < 2; ++d)
            out.displacement[i][d] =
                soft * ((i == d ? 2 * h.l(2) : 0) - z * h.l(i, d) + 2 * nu * h.m(i, d));
    }
    out.displacement[2][2] = soft * (-z * h.l(2, 2) + 2 * (1 - nu) * h.l(2));
    for (int c = 0; c < 6; ++c) {
        const auto [i, j] = indices[c];
        for (int d = 0; d < 2; ++d)
            out.stress[c][d] = sheared_stress(h, nu, z, i, j, d) / (2 * std::numbers::pi);
        out.stress[c][2] = pressed_stress(h, nu, z, i, j) / (2 * std::numbers::pi);
    }
    return out;
}

}  // namespace tricontact::theory
