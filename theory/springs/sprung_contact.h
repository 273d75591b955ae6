#pragma once

#include <memory>
#include <vector>

#include "contact/case.h"
#include "contact/solvers/control.h"

namespace tricontact::theory {

/// A bonded layer's influence on round contacts (theory/springs/abel_layer.h), which keeps what it
/// computed.
class AbelLayer;
/// Throws contact::InputError unless -1 < nu <= 1/2.
std::shared_ptr<AbelLayer> make_abel_layer(double poisson);

/// A paraboloid of the radius R on a half-space, both joined by springs k_n [Pa/m] at each point,
/// pressed without friction.
struct SprungPress {
    double normal_force = 0, contact_radius = 0, indentation = 0;  ///< [N, m]
};
/// With lengths along the surface in E*/k_n all such contacts are one family, tabulated once: 1e-4
/// of the force. `modulus`: E* of the pair [Pa]. Throws std::domain_error unless all are positive.
SprungPress press_on_springs(double radius, double modulus, double normal_stiffness,
                             const contact::NormalControl& control);

/// The same on a bonded layer of the thickness b, by as many equations as it takes. `layer`: of its
/// Poisson's ratio; `modulus`: E* of the layer, under a rigid body. Throws contact::InputError
/// where the contact is too wide.
SprungPress press_on_layer(double radius, double modulus, double normal_compliance,
                           const contact::NormalControl& control, double thickness,
                           AbelLayer& layer);

/// The same contact under one force F_T along the surface, applied once: springs k_t shear, and a
/// point carries tau = min(tau_0 + mu p_r (p/p_r)^n, tau_cap) at most. As in Cattaneo and Mindlin's
/// theory all tractions are along the force, and displacements their mean over directions: exact
/// but for what the other direction and, unless nu is 1/2 of incompressible bodies or 0, the normal
/// one do. A stiffness that is not given is rigid; HertzUnderLaw if neither is.
class SprungContact {
  public:
    /// `effective_modulus` E*, `effective_shear_modulus` G* of the pair [Pa].
    SprungContact(const contact::Friction& friction, const contact::Interface& interface,
                  double radius, double normal_force, double effective_modulus,
                  double effective_shear_modulus);
    /// On a layer, whose contact has the radius a under F_N (press_on_layer).
    SprungContact(const contact::Friction& friction, const contact::Interface& interface,
                  double contact_radius, double normal_force, double effective_modulus,
                  double effective_shear_modulus, double thickness, AbelLayer& layer);

    /// Force at which all slides [N].
    double friction_limit() const { return forces_.front(); }
    /// U at that force [m].
    double unit_shift() const { return shifts_.front(); }
    double contact_radius() const { return contact_radius_; }
    /// dF_T/dU before anything slips [N/m]; 0 where the edge slips at once.
    double stuck_stiffness() const;
    /// U [m] of F_T >= 0 [N]. Throws contact::InputError above the limit.
    double shift(double force) const;

  private:
    double contact_radius_;
    std::vector<double> forces_, shifts_;  // of the stick radius from 0 to a
};

}  // namespace tricontact::theory
