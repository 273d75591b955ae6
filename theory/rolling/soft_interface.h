#pragma once

namespace tricontact::theory {

// A paraboloid of the radius R on an interface of springs k_n, k_t [Pa/m] that is much softer than
// the bodies, pressed by d: p = k_n (d - r^2/(2 R)), a = sqrt(2 R d), F_N = pi k_n R d^2; a point
// carries mu p. With u = k_t U/(mu k_n d), f = F_T/(mu F_N), w = W/a of a contact that rolls to and
// fro by W. Each spring stands alone, so that what settles is the least bound of the path or k_t U:
// sums over the plane. All throw std::domain_error outside of [0, 1].

/// f at the shift u of a contact at rest: 1 - (1 - u)^2. Unloads by Masing's rule.
double soft_interface_force(double u);
/// Limit of shakedown f_T,lim: 1 - 2/pi [w (1 - w^2)^(1/2) (5 - 2 w^2)/3 + arcsin w].
double soft_interface_limit(double w);
/// f at the settled shift u: limit(w) - (1 - u)^2 limit(w/(1 - u)^(1/2)), the limit 0 above w = 1.
double soft_interface_settled_force(double w, double u);

/// f of a cylinder (p as above along x) that rolls on at the creepage xi, theta = k_t xi a/(2 mu
/// k_n d): 1 - (1 - theta)^3, the brush model of tyres (Fromm 1927; Pacejka 2012, section 3.2).
double soft_interface_creep_force(double theta);

}  // namespace tricontact::theory
