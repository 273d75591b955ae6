#pragma once

#include <Eigen/Dense>
#include <functional>
#include <optional>
#include <vector>

#include "contact/case.h"
#include "contact/solvers/control.h"

namespace tricontact::benchmarks {

/// How a contact differs from one of rigid surfaces whose gap is that of the undeformed ones.
struct InterfaceLaw {
    double compliance = 0;             ///< 1/K of a Winkler layer in series [m/Pa]
    bool is_displaced = false;         ///< gap and normal on the displaced surface, to first order
    double tangential_compliance = 0;  ///< 1/K_T of elastic slip [m/Pa]
};

/// Frictionless contact of a body of revolution with a half-space or, of a rigid body, with a layer
/// on a rigid plane, by rings of constant pressure; of a cylinder by strips, per length, on the
/// half-space under a force alone, as its depth there has no datum. What an interface changes of
/// RadialContact or PlaneContact is the difference of two states on the same rings. The pressures p
/// make least
///   1/2 p A p + 1/2 sum of p^2 dA/K + sum of p h' u_r[p] dA - sum of p (d - h) dA,  p >= 0,
/// A and u_r by line loads on the half-space (1/2 p A p = (1/E*) ∫ q^2 dx, Popov and Hess 2015) and
/// what the layer's C33 and C13 differ by; of strips A is that of ln x and, on a layer, of
/// ln(1 + b^2/x^2)/2 and what C33 differs by. The sum with u_r is the energy whose derivative is
/// FirstOrderEffects::displaced_surface. SI units.
class RingContact {
  public:
    /// Rings about a contact of the radius or half width `a` [m], to `reach` a.
    RingContact(const contact::Case& c, double a, int rings_inside);

    struct State {
        std::vector<double> pressure;  ///< of rings [Pa]
        double force = 0;              ///< [N], of strips [N/m]
        double indentation = 0;        ///< [m]
    };
    /// Under a force of the whole length or a depth. Empty where the contact is no disc on the
    /// rings, and of strips on the half-space under a depth. Throws nothing.
    std::optional<State> solve(const contact::NormalControl& control,
                               const InterfaceLaw& law) const;

    /// Tangential traction along x that friction carries.
    struct Shear {
        std::vector<double> traction;  ///< of rings [Pa]
        double force = 0;              ///< [N], of strips [N/m]
        double shift = 0;              ///< [m]
        int stuck = 0;                 ///< rings that stick
    };
    /// A shift or force along x, > 0, applied once behind the pressing, as Cattaneo's (1938) and
    /// Mindlin's (1949): traction along x alone, uncoupled, on a layer by the mean of C11 and C22
    /// over all directions, of strips by C11. q = mu p - t >= 0 where it sticks, with the
    /// displacement of mu p less the shift as the gap. Empty where all slips.
    std::optional<Shear> shear(const State& pressed, const contact::TangentialControl& control,
                               double mu, const InterfaceLaw& law) const;

    const std::vector<double>& radii() const { return middles_; }  ///< of the rings' middles [m]
    const Eigen::VectorXd& areas() const { return areas_; }        ///< [m^2], of strips [m]
    bool is_plane() const { return length_.has_value(); }

    static constexpr double reach = 1.25;

  private:
    /// What a layer's compliances differ by from those that stand for all short waves.
    struct Lacks {
        double normal, along, coupling;  ///< at a wave number [m/Pa]
    };
    /// How rings or strips see waves of the number k.
    struct Waves {
        double last, panel;                    ///< k b: the end of the sum, the widest panel of it
        int points;                            ///< of a panel
        double (*stiff)(double k);             ///< what a wave counts in p A p, per dk,
        double (*along)(double k);             ///< and in u_r
        double (*within)(double k, double r);  ///< the wave's sum over all within r
        double (*beside)(double k, double r);  ///< its slope at r
    };

    void set_rings(const contact::Case& c);
    void set_strips(const contact::Case& c);
    Eigen::MatrixXd on_half_space(double modulus) const;
    void add_layer(double thickness, const Waves& waves,
                   const std::function<Lacks(double k)>& lacks);
    Eigen::MatrixXd strips_matrix(double modulus, std::optional<double> thickness) const;
    Eigen::MatrixXd operator_of(const InterfaceLaw& law) const;
    std::optional<State> solve_disc(const Eigen::MatrixXd& matrix,
                                    const contact::NormalControl& control, int n) const;

    std::vector<double> edges_, middles_;
    Eigen::VectorXd areas_, heights_, slopes_;
    Eigen::MatrixXd stiff_;         // A: means of u_z times areas per pressure
    Eigen::MatrixXd tangential_;    // the same of u_x per traction along x
    Eigen::MatrixXd along_;         // u_r of the substrate less that of the body, per pressure
    std::optional<double> length_;  // of a cylinder [m]
    bool has_datum_ = true;
};

}  // namespace tricontact::benchmarks
