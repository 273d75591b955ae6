#pragma once

#include <memory>
#include <vector>

#include "contact/case.h"
#include "contact/solvers/control.h"
#include "theory/layer/layer_compliance.h"
#include "theory/line_load.h"

namespace tricontact::benchmarks {

/// Frictionless contact of a body of revolution with a half-space or, of a rigid body, with an
/// elastic layer on a rigid plane: exact but for rounding, by its line load q (Popov and Hess 2015;
/// Lebedev and Ufliand 1958, theory/layer/elastic_layer.h). SI units.
class RadialContact {
  public:
    /// The case's body, substrate and thickness under `control`. Throws contact::InputError,
    /// contact::NotConverged.
    RadialContact(const contact::Case& c, const contact::NormalControl& control);

    double radius() const { return radius_; }            ///< a [m]
    double indentation() const { return indentation_; }  ///< d [m]
    double force() const { return force_; }              ///< F_N [N]
    double stiffness() const { return stiffness_; }      ///< dF_N/dd [N/m]

    double pressure(double r) const { return line_load_.pressure(r); }  ///< [Pa]
    /// ∫ p dA over the distance r from the axis [N]: F - 2 ∫ q ds, s from 0 to sqrt(a^2 - r^2),
    /// q at sqrt(r^2 + s^2).
    double load_within(double r) const;
    /// u_r [m] of the substrate's surface; positive outwards. On the half-space -(1 - 2 nu)/(4 pi G
    /// r) times the load within r (Johnson 1985, section 3.3), on the layer more by
    /// -∫ k (C13 - C13 of the half-space) p^ J1(k r) dk, p^ = (1/pi) ∫_0^a q cos(k t) dt.
    double radial_displacement(double r) const;
    /// u_z [m] of the substrate's surface, into the body.
    double normal_displacement(double r) const;

    double pressure_squared() const;  ///< ∫ p^2 dA [N^2/m^2]
    /// ∫ p h'(r) u_r dA [N m], u_r of the substrate less that of the indenter.
    double work_of_slope() const;
    double stored_energy() const;  ///< 1/2 ∫ p (u_z of both bodies) dA [J]

  private:
    struct Wave {
        double k, weight;      ///< [1/m]
        double normal, along;  ///< p^ times k times what C33, C13 of the layer lack [m/...]
    };
    void solve_half_space(const contact::Case& c, const contact::NormalControl& control);
    void solve_layer(const contact::Case& c, const contact::NormalControl& control);
    void find_waves(const theory::ElasticLayer& layer);
    double waves_along(double r) const;
    double waves_normal(double r) const;

    std::shared_ptr<const contact::AxisymmetricIndenter> indenter_;
    contact::Material material_;
    double modulus_ = 0;   // E* [Pa]
    double share_ = 1;     // of the substrate in 1/E* [-]
    double coupling_ = 0;  // sum of (1 - 2 nu)/G over both bodies, signed [1/Pa]
    double radius_ = 0, indentation_ = 0, force_ = 0, stiffness_ = 0;
    theory::LineLoad line_load_;
    std::vector<Wave> waves_;  // none on the half-space
};

}  // namespace tricontact::benchmarks
