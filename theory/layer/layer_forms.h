#pragma once

#include <optional>

#include "theory/rolling/mapped_shakedown.h"

namespace tricontact::theory {

// What a bonded layer makes of the Hertzian contact of a paraboloid under the same force, in closed
// forms; `solve_layer_contact` is exact. chi = a_H/b = D_c/(2 b), with Hertz' contact radius a_H,
// and
//   s = [nu/(1 - nu)]^1.4: 0 at nu = 0, 1 at nu = 1/2.
// A thick layer lifts the contact as a whole, d by alpha chi and the shift by alpha_t chi of Hertz'
// values, and bends the gap by A chi^3 at next order; with the layer's deficits of compliance
// D(x), x = k b, alpha = 4/(3 pi) ∫ D33 dx, alpha_t the same of the tangential compliance, the mean
// of the directions, and A = 4/(9 pi) ∫ D33 x^2 dx. The forms have these limits, by
//   alpha = 0.514 + 0.237 s, alpha_t = 0.325 - 0.1 nu + 0.07 nu^2, A = 0.266 + 0.276 s
// (within 0.6, 0.5 and 2.4 % of the integrals). For thin incompressible layers a and d have the
// right powers, chi^(-1/2) and chi^(-1). Range: b/D_c >= 0.25 or chi <= 2, nu in [0, 1/2];
// std::domain_error outside. Errors: largest and median over ln(b/D_c) up to 40, against the atlas
// of the exact solution.

/// A bonded layer under a paraboloid.
struct LayerForm {
    double thickness_ratio = 1;  ///< b/D_c = b/(2 a_H)
    double poisson = .5;
};

/// Throws std::domain_error out of range.
void check(const LayerForm& layer);

/// a/a_H = [1 + A chi^3/(1 + (1.35 + 0.25 s) chi^2)]^(-1/2): 0.5 %, 0.001 %.
double layer_radius_ratio(const LayerForm& layer);

/// d/d_H = 1/{1 + alpha chi + alpha^2 chi^2/[1 + (1.37 - 0.82 s) chi^2]}: 2.4 %, 0.03 %.
double layer_indentation_ratio(const LayerForm& layer);

/// lambda = (0.083 + 0.058 s) chi^5/(1 + 1.1 chi^4): how much more the pressure is gathered at the
/// centre than Hertz', the share of p ~ (1 - r^2/a^2)^(3/2) in it.
double layer_pressure_shape(const LayerForm& layer);

/// p0/p0_H = (1 + 2/3 lambda)(a_H/a)^2: 0.8 %, 0.004 %.
double layer_pressure_ratio(const LayerForm& layer);

/// U_max/U_max,H = (p0/p0_H)/[1 + alpha_t chi + chi^2 (alpha_t^2 + (0.172 + 0.046 s) chi)/
/// (1 + 0.64 chi^2)]: 1 %, 0.006 %.
double layer_unit_shift_ratio(const LayerForm& layer);

/// f_T,lim = (1 - 3/2 w + 1/2 w^3) - 3/8 lambda w (1 - w^2)^(2 + lambda), w = W/a in [0, 0.85] over
/// the layer's own radius: 1.4 %, 0.006 % (Hertz' limit alone 16 %). The second term is that of the
/// shape above.
double layer_shakedown_limit(const LayerForm& layer, double w);

// Under a tangential force the layer lacks the compliance alpha_t chi of the contact as a whole,
// which gives a shift in proportion to the force and no slip. Over the layer's own U_max, with
//   Lambda = alpha_t chi/(1 + chi/2),
// u = (u_H - Lambda f)/(1 - Lambda), u_H that of the half-space at the same f and w, both over the
// layer's own scales. Exact for thick layers without coupling of normal and tangential contact.

/// u_stat = U_stat/U_max at f = F_T/(mu F_N) in [0, 1], u_H = 1 - (1 - f)^(2/3). Against the
/// coupled contact of the atlas `sphere_layer_static` (mu from 0.25, nu from 0.3): 14 %, 0.7 %.
double layer_static_shift_ratio(const LayerForm& layer, double f);

/// What coupling of normal and tangential contact takes of the friction: K = C13/(C11 mu), the
/// layer's compliances (`layer_compliance`) at the wave number 2/a_H; of a thick layer
/// (1 - 2 nu)/[2 (1 - nu) mu], Dundurs' constant over mu. mu >= 0.4, infinity without coupling.
double layer_coupling(const LayerForm& layer, double friction);

/// u_sd = U_sd/U_max with u_H = `half_space_settled_shift_ratio`, times 1 + K^2 w with
/// K = `layer_coupling`. Empty beyond the limit `layer_shakedown_limit`. nu is the layer's, not the
/// point's. Against the atlas `sphere_layer` (w <= 0.48, loads from 0.05 to 0.9 of the limit, mu
/// from 0.5, pressed with friction): 12 %, 0.55 %; the largest errors are those of strong coupling
/// and large w.
std::optional<double> layer_settled_shift_ratio(const LayerForm& layer, const MappedRolling& point,
                                                double friction);

}  // namespace tricontact::theory
