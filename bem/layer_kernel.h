#pragma once

#include <memory>

#include "theory/layer/layer_stack.h"

namespace tricontact::bem {

/// Of tables over asinh(r/b): b/60 near the force.
inline constexpr double table_step = 1. / 60;

/// Surface displacements under a point force on a layered body less those on a half-space of its
/// top layer [m/N], at the distance r. With D = C_layers - C_half-space (see layer_compliance.h):
///   normal     g_z =  1/(2 pi) ∫ k D33 J0(kr) dk              u_z by a normal force,
///   mean       g_s =  1/(2 pi) ∫ k (D11 + D22)/2 J0(kr) dk,
///   deviation  g_d = -1/(2 pi) ∫ k (D11 - D22)/2 J2(kr) dk:   u_x = (g_s + g_d cos 2 theta) F_x,
///                                                           u_y = g_d sin 2 theta F_x,
///   coupling   g_c =  1/(2 pi) ∫ k D13 J1(kr) dk:             u_r = -g_c F_z.
/// Finite everywhere: D falls as exp(-2 k b).
class LayerKernel {
  public:
    struct Values {
        double normal, mean, deviation, coupling;
    };

    /// Tabulated for 0 <= r <= `reach` [m], to about 1e-9 of the half-space's 1/(G b).
    ///
    /// Nothing holds layers on a frictionless base against translation: there g_s is that of a body
    /// whose mean displacement around the force at a distance of frictionless_hold thicknesses is
    /// zero. Throws contact::InputError.
    LayerKernel(const theory::LayerStack& stack, double reach);
    ~LayerKernel();

    Values at(double r) const;

    static constexpr double frictionless_hold = 40;
    /// Distance [m] at which layers are held; 0: they are not.
    static double hold(const theory::LayerStack& stack);

  private:
    struct Tables;
    double unit_;  // thickness of the top layer [m]
    std::unique_ptr<Tables> tables_;
};

}  // namespace tricontact::bem
