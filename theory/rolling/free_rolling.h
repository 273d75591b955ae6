#pragma once

namespace tricontact::theory {

// Dissimilar cylinders roll freely, F_T = 0: the normal load alone stretches both surfaces unlike,
// and they creep. Bentall and Johnson (1967), Int. J. Mech. Sci. 9, 389. Creepages over a/R, a
// being Hertz' half width without friction; beta is Dundurs' constant, the substrate's compliance
// counted positive (contact::MaterialPair). Signs as in carter.h. What friction there is decides
// between both values. |beta| is at most 1/2 for nu >= 0, and below 3/4 for all nu > -1; beyond,
// they throw std::domain_error.

/// All sticks, mu far above |beta|: 2 e/sqrt(1 + 4 e^2), e = ln((1 + beta)/(1 - beta))/(2 pi).
/// p + i q is a multiple of (a - x)^(1/2 + i e) (a + x)^(1/2 - i e), the solution of the coupled
/// singular integral equations that is bounded at both edges (Muskhelishvili 1953); its expansion
/// at infinity, z - 2 i e a - (1/2 + 2 e^2) a^2/z, tells creepage and force.
double rough_free_creepage(double beta);

/// All slips, mu far below |beta|: .9148 beta. Hertz' pressure alone strains the surface, by
/// 2 beta p/E*; it slips to one side in the strip that carries half of the load, to the other one
/// beside it.
double smooth_free_creepage(double beta);

/// Over b/R, of a rigid body x^2/(2 R) + f(y) that slips everywhere, mu far below b/a, on a bonded
/// layer of the thickness b, much thinner than the contact: (1 - 4 nu)/(2 (1 - 2 nu)). Pressed in
/// by w(x) such a layer bulges by -(1 - 4 nu)/(2 (1 - 2 nu)) b w' along x, and no correction of
/// higher order comes from a parabola, which stretches it evenly. Who sticks creeps less: at the
/// leading edge the surface comes in with half of that. nu < 1/2, else std::domain_error: an
/// incompressible thin layer gives way by flowing.
double thin_layer_smooth_creepage(double poisson);

}  // namespace tricontact::theory
