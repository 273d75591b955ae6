#pragma once

#include "theory/layer/layer_forms.h"

namespace tricontact::theory {

// What a bonded layer makes of Hertz' line contact under the same force, in plane strain; the
// thickness is that over 2 a_H, a_H the half width of the half-space. With beta = b/a_H = 1/chi,
// q = nu/(1 - nu) and s = q^1.4. A layer of any thickness gives the displacements that a half-space
// in plane strain has not: they grow with ln(b/a). Range: b/(2 a_H) >= 0.25, nu in [0, 1/2];
// std::domain_error outside. Errors: largest and median against the atlas `cylinder_layer_pressed`,
// up to b = 80 a_H.

/// a/a_H = {1 + (0.623 + 0.324 s) chi^2/[1 + (2.17 - 0.56 s) chi^2]^(1/2)}^(-1/2): 0.4 %, 0.02 %.
double line_layer_width_ratio(const LayerForm& layer);

/// (p0 a)/(p0_H a_H) - 1 = (0.065 + 0.033 s) chi^4/(1 + 2.14 chi^3): how much more the pressure is
/// gathered at the centre than Hertz', which has p0 a = 2 F_N/(pi L).
double line_layer_pressure_shape(const LayerForm& layer);

/// p0/p0_H by these two: 0.4 %, 0.02 %.
double line_layer_pressure_ratio(const LayerForm& layer);

/// lambda of U_max = mu 2 F_N/(pi E* L) lambda, frictionless: 1.331 + 0.628 q - 0.076 q^2 +
/// 1/2 ln[beta^2 + (0.315 + 0.172 q) beta + 0.249 + 0.104 q]: 1 %, 0.3 %. It stands for
/// contact::line_shift_factor of the half-space, in whose place the length of the contact is.
double line_layer_shift_factor(const LayerForm& layer);

/// The same of d over 2 F_N/(pi E* L): 0.801 - 0.143 q - 0.471 q^2 + 1/2 ln[beta^2 + (0.34 -
/// 0.021 s + 0.173 s^2) beta + 0.401 + 0.334 s + 0.093 s^2]: 1.1 %, 0.3 %.
double line_layer_depth_factor(const LayerForm& layer);

/// f_T,lim at w in [0, 0.85] over the layer's own half width: that of Hertz' pressure
/// (line_shakedown_limit) less 1.24 shape w (1 - w^2)^(3/2): 0.7 %, 0.01 % (Hertz' limit alone
/// 21 %).
double line_layer_shakedown_limit(const LayerForm& layer, double w);

// u_stat and u_sd of a layer are those of the half-space at the same f and w with the layer's
// lambda (theory/oscillating_cylinder.h): exact for thick layers without coupling. Against the
// coupled contacts of the atlases `cylinder_layer_static` and `cylinder_layer`, u_sd at the same
// share of the limit: 20 %, 0.7 % and 12 %, 0.8 %, the largest at b = D_c/4 and little friction.

}  // namespace tricontact::theory
