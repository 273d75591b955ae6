#pragma once

#include "contact/substrates/material.h"
#include "theory/layer/layer_compliance.h"

namespace tricontact::theory {

// Tangential stiffness F_T/U [N/m] of a circular contact of radius a that sticks everywhere: the
// slope at which F_T sets in, before anything slips. The contact's disc moves by U along x, not
// across, and does not turn.

/// On the half-space 2 G* a, of a rigid indenter 8 G a/(2 - nu); exact where normal and tangential
/// contact are uncoupled. Mindlin (1949). Throws contact::InputError for a radius out of range.
double sticking_stiffness(const contact::MaterialPair& materials, double radius);

/// Which tractions a sticking contact may put up against its shift.
enum class StickTractions {
    /// Along x and a function of r alone: the approximation by which MDR treats the layer. It makes
    /// u_x right in the mean over every circle only. Never above `in_plane`; the same on the
    /// half-space.
    radial,
    /// All tangential ones, t_x = t_0(r) + t_2(r) cos 2 theta, t_y = t_2(r) sin 2 theta; the
    /// pressure is what it was. The disc's displacement is uniform: exact without coupling.
    in_plane,
    /// Pressure p_1(r) cos theta too, which keeps the contact closed (u_z = 0): exact for the
    /// coupled layer as long as the contact neither opens nor slips.
    all
};

/// On a layer bonded to its base, under a rigid indenter: Galerkin's method in the space of the
/// exact tractions on the half-space, t_m = (1 - r^2/a^2)^(-1/2) r^m times polynomials, whose
/// Hankel transforms are spherical Bessel functions j_n(k a). Relative error about 1e-10; of `all`
/// at nu < 1/2 about 1e-6, since stresses then oscillate at the edge. Range 0 < a <= 32 b.
/// Throws contact::InputError, also for a frictionless base, which offers no hold.
double sticking_stiffness(const ElasticLayer& layer, double radius, StickTractions tractions);

}  // namespace tricontact::theory
