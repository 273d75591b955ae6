#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/indenter.h"
#include "contact/material.h"

namespace tricontact::contact {

/// What a case file says, in SI units, as the user said it: where a quantity may be given as a
/// value or as a ratio, exactly one of the two is set.
struct Case {
    enum class Shape { paraboloid, sphere };
    enum class AmplitudeReference { hertz, model };
    enum class Steps { increment, per_quarter, turning_points };
    enum class VtkOutput { none, quarters, all };

    struct IndenterData {
        Shape shape = Shape::paraboloid;
        double radius = 0;                 ///< R [m]
        std::optional<Material> material;  ///< empty: rigid
    };

    struct Load {
        std::optional<double> normal_force;      ///< F_N [N]
        std::optional<double> indentation;       ///< d [m], instead of normal_force
        std::optional<double> tangential_force;  ///< F_T [N] along x
        std::optional<double> tangential_ratio;  ///< F_T / (mu F_N), instead of tangential_force
        /// Superposed oscillation in the rolling period's phase: the normal control (force or
        /// indentation) and F_T are multiplied by 1 + ratio * triangle(phase + shift).
        double normal_amplitude_ratio = 0;      ///< [-], in [0, 1)
        double normal_phase = 0;                ///< [rad]
        double tangential_amplitude_ratio = 0;  ///< [-]
        double tangential_phase = 0;            ///< [rad]
    };

    struct Rolling {
        std::optional<double> amplitude;        ///< W [m]
        std::optional<double> amplitude_ratio;  ///< w = W over a contact radius, instead
        AmplitudeReference amplitude_reference = AmplitudeReference::hertz;
        double angle = 0;      ///< between rolling direction and tangential load [rad]
        int periods = 12;      ///< at most
        bool run_all = false;  ///< do not stop at shakedown
        Steps steps = Steps::per_quarter;
        double increment = 0;       ///< dW [m], for Steps::increment
        int steps_per_quarter = 6;  ///< for Steps::per_quarter
    };

    struct Bem {
        std::optional<double> spacing;           ///< cell size h [m]
        std::optional<double> cells_per_radius;  ///< Hertz radius / h, instead
        double tolerance = 1e-7;                 ///< see TangentialSolver, NormalSolver
    };

    struct Mdr {
        int springs = 10000;  ///< over the whole bed, contact diameter plus rolling path
    };

    struct Output {
        VtkOutput vtk = VtkOutput::quarters;
    };

    std::string title;
    std::vector<std::string> models;
    IndenterData indenter;
    Material substrate{0, 0};
    double friction_coefficient = 0;
    Load load;
    std::optional<Rolling> rolling;  ///< empty: static loading only
    Bem bem;
    Mdr mdr;
    Output output;

    MaterialPair materials() const { return {indenter.material, substrate}; }
    std::unique_ptr<AxisymmetricIndenter> make_indenter() const;
};

/// Hertz' solution of a case's paraboloid (R of a sphere): what ratios refer to. SI units.
struct HertzScales {
    double contact_radius;  ///< a [m]
    double indentation;     ///< d [m]
    double normal_force;    ///< F_N [N]
    double peak_pressure;   ///< p0 [Pa]
    double unit_shift;      ///< U_max = mu (E*/G*) d [m]
};
HertzScales hertz_scales(const Case& c);

/// W [m] of the case, `reference_radius` being the contact radius that a ratio refers to [m].
double rolling_amplitude(const Case::Rolling& rolling, double reference_radius);

}  // namespace tricontact::contact
