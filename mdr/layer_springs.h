#pragma once

#include <optional>
#include <vector>

#include "contact/compliances/compliance.h"
#include "contact/interface.h"
#include "contact/substrates/material.h"
#include "mdr/line_surface.h"
#include "theory/layer/layer_stack.h"

namespace tricontact::mdr {

/// What a layer takes from the half-space's independent springs: on a line, the load q(t) raises
/// the surface at x against the half-space's by 1/E* ∫ K(x - t) q(t) dt (tangentially 1/G* and
/// K_t),
///   K(s) = 1/pi ∫_0^inf [1 - C/C_half-space](k) cos(k s) dk,
/// C33 for K, exact for axisymmetric pressure (theory/layer/layer_equation.h). K_t has the mean of
/// C11 and C22, which is exact for the mean over the circle of u_x under tractions along x that
/// depend on the distance from the axis alone; what varies as the cosine and sine of 2 theta is
/// left out.
struct LayerKernel {
    std::vector<double> normal;      ///< K at the distances 0, h, 2h, ... [1/m]
    std::vector<double> tangential;  ///< K_t; empty on a frictionless base, where it diverges
};

/// `n` values at the distance `spacing` [m], to about 1e-14 of 1/b. Throws contact::InputError.
LayerKernel layer_kernel(const theory::LayerStack& stack, double spacing, int n);

/// The springs of MDR coupled by a layer (theory/layer/layer_equation.h), on a line of equal
/// elements of length h: with line loads q,
///   u_i = 1/E* [q_i - sum_j K(x_i - x_j) q_j h],   tangentially 1/G* and K_t (layer_kernel.h).
/// K varies over the layer's thickness: the midpoint rule is of the order h^2 as long as h is
/// shorter. An elastic indenter adds its own independent springs. Those of an elastic interface
/// have C33 = 1/k_n, which on the line is k/(2 k_n): u(x) gets 1/(2 pi k_n) times the principal
/// value of ∫ q'(s)/(x - s) ds, of elements 1/(2 pi k_n h) sum_j q_j/(1/4 - (i - j)^2).
///
/// As a contact::Compliance it has a tributary area of h times 1 m per element, so that tractions
/// [Pa] are line loads [N/m] over 1 m. The line is the plane of symmetry of a mirrored surface:
/// nothing moves in y. Normal and tangential contact do not couple.
class LayerSprings final : public contact::Compliance {
  public:
    /// Of half-spaces, whose springs no layer couples, but the springs of the interface.
    LayerSprings(const contact::MaterialPair& half_spaces, int n_beside, double spacing,
                 const contact::Interface& interface);
    /// 2 `n_beside` + 1 elements about the origin. `indenter` empty: rigid. Throws
    /// contact::InputError for layers out of range and for elements longer than a quarter of the
    /// top layer, which do not resolve K.
    LayerSprings(const theory::LayerStack& stack, const std::optional<contact::Material>& indenter,
                 int n_beside, double spacing, const contact::Interface& interface = {});

    static constexpr double width = 1;              ///< of the line [m]
    static constexpr double longest_element = .25;  ///< over the thickness of the top layer

    const contact::ContactPoints& points() const override { return points_; }
    const PointRow& row() const { return row_; }
    double effective_modulus() const {
        return effective_modulus_;
    }  ///< E* at a tip [Pa]; 0: an interface rounds it
    bool is_coupled() const override { return false; }
    void normal(std::span<const double> p, std::span<double> u_z) const override {
        multiply(normal_, p, u_z);
    }
    /// Throws contact::InputError on a frictionless base, which gives no hold.
    void tangential(const contact::TangentialField& t, contact::TangentialField& u) const override;
    double local_tangential() const override {
        return tangential_.empty() ? 0 : tangential_[points_.size() - 1] * row_.spacing * width;
    }
    // The springs by themselves.
    void precondition_tangential(const contact::TangentialField& r,
                                 contact::TangentialField& z) const override {
        z = r;
    }
    const double* dense() const override { return dense_.data(); }

  private:
    int size() const { return static_cast<int>(points_.size()); }
    void place(int n_beside, double spacing);
    void fill(const contact::Interface& interface);
    void fill_block(int component, const std::vector<double>& coefficients);
    void multiply(const std::vector<double>& coefficients, std::span<const double> traction,
                  std::span<double> u) const;

    contact::ContactPoints points_;
    PointRow row_;
    double effective_modulus_;
    // Displacement over force [m/N] at the distances (1 - n) h, ..., (n - 1) h.
    std::vector<double> normal_, tangential_;
    std::vector<double> dense_;
};

}  // namespace tricontact::mdr
