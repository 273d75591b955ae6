#pragma once

#include <cmath>
#include <optional>

#include "contact/base/bulk_state.h"
#include "contact/base/special_values.h"

namespace tricontact::contact {

/// Linear elastic, isotropic body.
struct Material {
    double young;    ///< Young's modulus E [Pa], > 0; infinite: rigid
    double poisson;  ///< Poisson's ratio nu [-], -1 < nu <= 1/2

    bool is_rigid() const { return std::isinf(young); }
    /// Shear modulus G = E / (2 (1 + nu)) [Pa].
    double shear_modulus() const { return young / (2 * (1 + poisson)); }
    /// (1 - nu^2)/E [1/Pa]: what a half-space adds to 1/E*.
    double plane_compliance() const { return (1 - poisson * poisson) / young; }
    /// A material of this many times the shear modulus and the same bulk modulus.
    Material with_shear_ratio(double ratio) const;
};

/// `stress`: XX [Pa].
inline BulkState bulk_state(const Material& material, double stress, bool plane_strain) {
    const double nu = material.poisson, along = stress / material.young;
    if (!plane_strain) return {{stress, 0}, {along, -nu * along, -nu * along}};
    return {{stress, nu * stress}, {(1 - nu * nu) * along, 0, -nu * (1 + nu) * along}};
}

/// A body that does not deform.
inline constexpr Material rigid_material{infinity, 0};

/// Elastic constants of two bodies in contact; one of them may be rigid.
/// Sources: Johnson (1985), Contact Mechanics, ch. 4, 5, 7; Dundurs (1969).
class MaterialPair {
  public:
    /// `indenter` empty: rigid. Throws InputError if a modulus or a ratio is out of range, or if
    /// both are rigid.
    MaterialPair(std::optional<Material> indenter, Material substrate);

    /// E* [Pa]: 1/E* = sum (1 - nu_i) / (2 G_i).
    double effective_modulus() const { return 1 / normal_compliance_; }
    /// G* [Pa]: 1/G* = sum (2 - nu_i) / (4 G_i).
    double effective_shear_modulus() const { return 1 / tangential_compliance_; }
    /// Dundurs' beta [-] (plane strain): zero when normal and tangential contact do not couple.
    double dundurs_beta() const { return coupling_compliance_ / (2 * 2 * normal_compliance_); }

    /// Sums over both bodies that scale the surface Green's functions [1/Pa]:
    /// (1 - nu)/G, nu/G, and the signed (1 - 2 nu)/G (substrate minus indenter).
    double one_minus_nu_over_g() const { return 2 * normal_compliance_; }
    double nu_over_g() const { return nu_over_g_; }
    double one_minus_two_nu_over_g() const { return coupling_compliance_; }

  private:
    double normal_compliance_ = 0;
    double tangential_compliance_ = 0;
    double nu_over_g_ = 0;
    double coupling_compliance_ = 0;
};

}  // namespace tricontact::contact
