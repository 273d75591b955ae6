#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "contact/base/gauss_legendre.h"
#include "contact/substrates/material.h"
#include "theory/layer/layer_stack.h"

namespace tricontact::bem {

/// Displacements at the origin of the relative position (substrate minus indenter) per uniform
/// traction on a rectangle, [m/Pa]: `xy` is u_x per traction in y. z points into the substrate,
/// tractions act on the substrate. Reciprocity: zx = -xz, zy = -yz at the same relative position.
struct InfluenceCoefficients {
    double xx, xy, yy, xz, yz, zz;
    double yx() const { return xy; }
    double zx() const { return -xz; }
    double zy() const { return -yz; }
};

/// Closed forms for half-spaces (Boussinesq 1885, Cerruti 1882; integrated by Love 1929), both
/// bodies' displacements added; Johnson (1985), eq. 3.19 and 3.75-3.76.
class RectangleInfluence {
  public:
    /// `width_x`, `width_y`: sides of the rectangle [m].
    RectangleInfluence(const contact::MaterialPair& materials, double width_x, double width_y);

    /// All coefficients at (x, y) [m] from the rectangle's centre.
    InfluenceCoefficients at(double x, double y) const;

  private:
    double half_x_, half_y_;
    double symmetric_, skew_, coupling_;  // (1-nu)/(2 pi G), nu/(2 pi G), (1-2nu)/(4 pi G) [1/Pa]
};

/// A wave number k [1/m] and its weight [1/m] in integrals over k.
struct Wave {
    double k, weight;
};

/// Where the surfaces of layers and of the half-space of the top layer, b thick, no longer differ:
/// exp(-2 k b) (k b)^2 < 1e-18.
inline constexpr double last_surface_wave = 24;  // k b

/// The same inside: exp(-k b) (k b)^3 < 1e-16 at the bottom of the layer.
inline constexpr double last_inside_wave = 48;  // k b

/// Quadrature over 0 < k < `last`/b, where layers differ from that half-space: to rounding for the
/// difference times waves of the argument k r, r up to `farthest` [m].
std::vector<Wave> layer_waves(const theory::LayerStack& stack, double farthest,
                              double last = last_surface_wave);

/// The half-space that the top layer would be part of, cut where the layers are.
theory::LayerStack continued(const theory::LayerStack& stack);

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
    static double hold(const theory::LayerStack& stack) {
        const bool glides = stack.base == theory::LayerBase::frictionless && !stack.half_space;
        return glides ? frictionless_hold * stack.thickness() : 0;
    }

  private:
    struct Tables;
    double unit_;  // thickness of the top layer [m]
    std::unique_ptr<Tables> tables_;
};

/// Points and weights on (-1/2, 1/2) that integrate what layers add over a cell. It varies over the
/// thickness b: two points per direction leave (h/b)^4/4000 of it.
contact::QuadratureRule cell_rule(double width_over_thickness);

/// Influence coefficients of layers under a uniform traction on a rectangle, displacements relative
/// to an elastic or rigid indenter: closed forms of the half-space plus the layers' difference
/// kernel, integrated by Gauss points.
class LayerInfluence {
  public:
    /// `indenter` empty: rigid. `width_x`, `width_y`: sides of the rectangle [m]. `reach`: largest
    /// distance asked for [m]. Throws contact::InputError.
    LayerInfluence(const theory::LayerStack& stack,
                   const std::optional<contact::Material>& indenter, double width_x, double width_y,
                   double reach);

    /// All coefficients at (x, y) [m] from the rectangle's centre.
    InfluenceCoefficients at(double x, double y) const;

  private:
    RectangleInfluence half_space_;
    LayerKernel kernel_;
    std::vector<double> points_, weights_;  // of the unit interval (-1/2, 1/2)
    double width_x_, width_y_;
};

}  // namespace tricontact::bem
