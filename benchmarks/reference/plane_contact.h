#pragma once

#include <optional>
#include <vector>

#include "contact/case.h"
#include "contact/solvers/control.h"
#include "theory/layer/line_contact.h"

namespace tricontact::benchmarks {

/// Frictionless contact of a cylinder, profile x^2/(2R), with a half-space (Hertz; Johnson 1985,
/// section 4.2c) or, of a rigid one, with an elastic layer on a rigid plane
/// (theory/layer/line_contact.h), plane strain. All loads per length.
class PlaneContact {
  public:
    /// Throws contact::InputError, contact::NotConverged.
    PlaneContact(const contact::Case& c, const contact::NormalControl& control);

    double half_width() const { return half_width_; }       ///< a [m]
    double load() const { return load_; }                   ///< F_N/L [N/m]
    double centre_pressure() const { return pressure(0); }  ///< [Pa]
    /// Of a layer: d [m] and dF/dd [Pa]. The half-space has no d in plane strain.
    std::optional<double> indentation() const {
        return on_layer_ ? std::optional(on_layer_->indentation) : std::nullopt;
    }
    std::optional<double> stiffness() const {
        return on_layer_ ? std::optional(on_layer_->stiffness) : std::nullopt;
    }

    double pressure(double x) const;     ///< [Pa]
    double load_within(double x) const;  ///< ∫ p dx over the distance x >= 0 [N/m]
    /// u_x [m] of the substrate's surface at x >= 0: -(1 - 2 nu)/(4 G) times the load within
    /// (Johnson 1985, eq. 2.25), on the layer more by what its C13 lacks.
    double displacement_along(double x) const;
    /// u_z [m] where a rigid body presses the layer; NaN elsewhere.
    double normal_displacement(double x) const;

    double pressure_squared() const;              ///< ∫ p^2 dx [N^2/m^3]
    double work_of_slope() const;                 ///< ∫ p h'(x) u_x dx [N], see RadialContact
    std::optional<double> stored_energy() const;  ///< of a layer [J/m]

  private:
    struct Wave {
        double k, value;  ///< [1/m], [m]
    };
    void find_waves(const theory::ElasticLayer& layer);

    contact::Material material_;
    double radius_, coupling_;
    double half_width_ = 0, load_ = 0;
    std::optional<theory::LineContact> on_layer_;
    std::vector<Wave> waves_;
};

}  // namespace tricontact::benchmarks
