#pragma once

#include <span>
#include <vector>

#include "contact/vector2.h"

namespace tricontact::contact {

/// A tangential vector per contact point, by component.
struct TangentialField {
    std::vector<double> x, y;

    TangentialField() = default;
    explicit TangentialField(std::size_t n) : x(n, 0.0), y(n, 0.0) {}
    std::size_t size() const { return x.size(); }
};

/// Where tractions act and displacements are read. On a grid x runs fastest.
struct ContactPoints {
    std::vector<double> x, y;    ///< positions on the substrate [m]
    std::vector<double> area;    ///< tributary areas [m^2]
    int n_x = 0, n_y = 0;        ///< > 0 on a regular grid
    Vector2 first{}, spacing{};  ///< of a regular grid [m]

    std::size_t size() const { return x.size(); }
    /// Regular grid of n_x * n_y cells; `first` is the centre of the first one.
    static ContactPoints grid(int n_x, int n_y, Vector2 first, Vector2 spacing);
};

/// The linear elasticity of both bodies as seen from the contact surface: tractions [Pa] on the
/// contact points give displacements [m] of the substrate relative to the indenter. Self-adjoint
/// and positive definite in the inner product weighted by the points' areas.
class Compliance {
  public:
    virtual ~Compliance() = default;

    virtual const ContactPoints& points() const = 0;
    /// Normal traction displaces tangentially and vice versa.
    virtual bool is_coupled() const = 0;

    /// Displacement into the substrate under the pressure p.
    virtual void normal(std::span<const double> p, std::span<double> u_z) const = 0;
    /// Displacement in the surface under the tangential traction t on the substrate.
    virtual void tangential(const TangentialField& t, TangentialField& u) const = 0;
    /// Displacement of a point under unit traction on its own area alone, a typical value [m/Pa].
    virtual double local_tangential() const = 0;
    /// A symmetric positive definite approximation of the inverse of `tangential`; its scale is
    /// free.
    virtual void precondition_tangential(const TangentialField& r, TangentialField& z) const = 0;
};

}  // namespace tricontact::contact
