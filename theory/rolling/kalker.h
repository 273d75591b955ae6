#pragma once

#include "contact/substrates/material.h"

namespace tricontact::theory {

// Kalker's linear theory: creep forces in steady rolling towards +x while nearly all of an elliptic
// Hertzian contact sticks. Kalker (1967), thesis, TH Delft; (1990), Three-Dimensional Elastic
// Bodies in Rolling Contact, section 2.2.2 and table E.3. Forces act on the substrate and have the
// sign of the creepages, those of the indenter over the substrate (Kalker's own F is the
// indenter's, of opposite sign).

/// Both bodies in one: 1/G = (1/G1 + 1/G2)/2, nu/G = (nu1/G1 + nu2/G2)/2; of a rigid indenter twice
/// the substrate's G and its nu. Exact where normal and tangential contact do not couple. Kalker
/// (1990), eq. 1.44.
struct CombinedMaterial {
    double shear_modulus;  ///< G [Pa]
    double poisson;        ///< nu [-]
};
CombinedMaterial combined_material(const contact::MaterialPair& materials);

/// Creepage coefficients of the linear theory [-]. With half axes a along x and b across [m],
///   F_x = G a b C11 xi, F_y = G a b (C22 eta + sqrt(a b) C23 phi),
///   M_z = G (a b)^(3/2) (-C23 eta + sqrt(a b) C33 phi) through the centre, from x towards y.
struct KalkerCoefficients {
    double longitudinal;  ///< C11
    double lateral;       ///< C22
    double spin;          ///< C23 = -C32
    double moment;        ///< C33
};

/// For half axes a along the rolling and b across, `axes_ratio` = a/b in [1/10, 10], and nu in
/// [0, 1/2]. Kalker's table of three digits at a/b = 0.1, 0.2 ... 1, 1/0.9 ... 10 and nu = 0, 1/4,
/// 1/2; in between 1/C by a parabola in nu (for a sphere it is nearly a straight line, see
/// vermeulen_johnson_coefficient) and ln C by modified Akima interpolation in
/// ln(a/b). C23 at a/b = 0.8, nu = 1/4 is 1.25, as boundary elements have it; the 1.15 of print is
/// 8 % off and breaks the column's second difference. Throws std::domain_error out of range.
KalkerCoefficients kalker_coefficients(double axes_ratio, double poisson);

}  // namespace tricontact::theory
