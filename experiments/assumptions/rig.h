#pragma once

#include <optional>
#include <string>
#include <vector>

#include "statistics/estimate.h"

namespace tricontact::experiments {

using statistics::Estimate;

/// A number that a publication states, SI units.
struct PrintedValue {
    std::string name;             ///< of the quantity: "contact_radius"
    std::string text;             ///< as printed: "4.56 mm"
    Estimate value;               ///< with the printed error, 0 if there is none
    double half_digit = 0;        ///< half a unit of the last digit of the value ...
    double half_error_digit = 0;  ///< ... and of its error
    std::string source;           ///< "table 5.1.1"
};

/// An experiment in which a heavy roller lies on a layer of rubber, bonded to a rigid plate, and is
/// rolled back and forth by a lever. SI units; empty where the experimenter does not say.
struct RollingRig {
    enum class Shape { sphere, cylinder };

    struct Roller {
        Shape shape = Shape::sphere;
        Estimate radius;                 ///< R [m]
        std::optional<Estimate> length;  ///< L [m] of a cylinder
        Estimate young;                  ///< E_1 [Pa]
        Estimate poisson;                ///< nu_1 [-]
    };
    struct Substrate {
        Estimate thickness;                     ///< b [m]
        Estimate young;                         ///< E_2 [Pa]
        Estimate poisson;                       ///< nu_2 [-]
        std::optional<Estimate> density;        ///< rho [kg/m^3]
        std::optional<Estimate> viscosity;      ///< eta [Pa s] of a standard solid with G_1 = E_2's
        std::optional<Estimate> maxwell_ratio;  ///< G_2/G_1 of that solid
    };
    struct Drive {
        Estimate speed;                            ///< v [m/s] of the roller's centre
        Estimate smallest_amplitude_ratio;         ///< least W/a
        std::optional<Estimate> reference_radius;  ///< a [m] of these ratios; empty: Hertz'
        std::optional<Estimate> eigenfrequency;    ///< f_1 [Hz], the lowest of the rig
    };
    /// The substrate's oscillation under a roller that should not move it.
    struct Pivot {
        Estimate displacement;     ///< DU [m], amplitude
        Estimate amplitude_ratio;  ///< W/a
    };

    std::string title;
    Roller roller;
    Substrate substrate;
    Estimate friction_coefficient;  ///< mu
    Estimate normal_force;          ///< F_N [N]
    Drive drive;
    std::optional<Pivot> pivot;
    std::optional<Estimate> measured_contact_size;  ///< diameter, or width 2a of a line [m]
    std::vector<PrintedValue> printed;
};

/// An experiment with a micro-walking machine: an hourglass of a body and two discs lies with four
/// contact spots in a prism (two planes at 45 degrees) and is dragged by a rod or spring. SI units;
/// empty where the experimenter does not say.
struct WalkingRig {
    struct Specimen {
        Estimate mass;           ///< m [kg]
        Estimate disc_diameter;  ///< D [m]
        Estimate disc_length;    ///< l_2 [m]
        Estimate centre_length;  ///< l_1 [m], between the discs
        Estimate edge_radius;    ///< R_c [m] of the discs where they touch
        Estimate young;          ///< E_1 [Pa] of the discs
        Estimate poisson;        ///< nu_1 [-]
    };
    struct Substrate {
        Estimate young;    ///< E_2 [Pa]
        Estimate poisson;  ///< nu_2 [-]
    };
    struct Contact {
        Estimate diameter;                      ///< D_c [m] that the evaluation uses
        std::optional<Estimate> wear_diameter;  ///< [m] of the wear spots
    };
    struct Spring {
        Estimate stiffness;                        ///< [N/m] of the spring alone
        std::optional<Estimate> sensor_stiffness;  ///< [N/m], in series with it
        std::optional<Estimate> length;            ///< l_s [m] of a rod
        std::optional<Estimate> young;             ///< E_s [Pa] of a rod
        std::optional<Estimate> height_ratio;      ///< kappa_8 = h/a, where it attaches
    };
    /// Characteristic frequency of the spring force, in the experiment and in its simulation.
    struct Oscillation {
        Estimate frequency;                     ///< Omega_exp [Hz]
        Estimate simulated;                     ///< omega_sim [-], in units of 1/tau
        Estimate time;                          ///< tau [s] that the evaluation uses
        std::optional<Estimate> sampling_rate;  ///< [Hz] of the force
    };

    std::string title;
    Specimen specimen;
    Substrate substrate;
    Estimate friction_coefficient;  ///< mu
    Contact contact;
    Spring spring;
    std::optional<Oscillation> oscillation;
    std::vector<PrintedValue> printed;
};

}  // namespace tricontact::experiments
