#pragma once

#include <Eigen/Dense>
#include <optional>
#include <vector>

#include "contact/case.h"
#include "contact/solvers/control.h"

namespace tricontact::benchmarks {

/// How a contact differs from one of rigid surfaces whose gap is that of the undeformed ones.
struct InterfaceLaw {
    double compliance = 0;      ///< 1/K of a Winkler layer in series [m/Pa]
    bool is_displaced = false;  ///< gap and normal on the displaced surface, to first order
};

/// Frictionless contact of a body of revolution with a half-space or, of a rigid body, with a layer
/// on a rigid plane, by rings of constant pressure: what an interface changes of RadialContact is
/// the difference of two states on the same rings. The pressures p of the rings make least
///   1/2 p A p + 1/2 sum of p^2 dA/K + sum of p h' u_r[p] dA - sum of p (d - h) dA,  p >= 0,
/// A and u_r by line loads on the half-space (1/2 p A p = (1/E*) ∫ q^2 dx, Popov and Hess 2015)
/// and what the layer's C33 and C13 differ by; the sum with u_r is the energy whose derivative is
/// FirstOrderEffects::displaced_surface. SI units.
class RingContact {
  public:
    /// Rings about a contact of the radius `a` [m], to `reach` a.
    RingContact(const contact::Case& c, double a, int rings_inside);

    struct State {
        std::vector<double> pressure;  ///< of rings [Pa]
        double force = 0;              ///< [N]
        double indentation = 0;        ///< [m]
    };
    /// Empty where the contact is no disc on the rings. Throws nothing.
    std::optional<State> solve(const contact::NormalControl& control,
                               const InterfaceLaw& law) const;

    const std::vector<double>& radii() const { return middles_; }  ///< of the rings' middles [m]

    static constexpr double reach = 1.25;

  private:
    void set_half_space(double modulus);
    void add_layer(const contact::Case& c, double a);
    Eigen::MatrixXd operator_of(const InterfaceLaw& law) const;
    std::optional<State> solve_disc(const Eigen::MatrixXd& matrix,
                                    const contact::NormalControl& control, int n) const;

    std::vector<double> edges_, middles_;
    Eigen::VectorXd areas_, heights_, slopes_;
    Eigen::MatrixXd stiff_;  // A: means of u_z times areas per pressure
    Eigen::MatrixXd along_;  // u_r of the substrate less that of the body, per pressure
};

}  // namespace tricontact::benchmarks
