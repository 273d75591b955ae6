#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/assumptions/printed_value.h"
#include "statistics/uncertain.h"

namespace tricontact::experiments {

/// An experiment with a micro-walking machine: an hourglass of a body and two discs lies with four
/// contact spots in a prism (two planes at 45 degrees) and is dragged by a rod or spring. SI units;
/// empty where the experimenter does not say.
struct WalkingRig {
    struct Specimen {
        statistics::Uncertain mass;           ///< m [kg]
        statistics::Uncertain disc_diameter;  ///< D [m]
        statistics::Uncertain disc_length;    ///< l_2 [m]
        statistics::Uncertain centre_length;  ///< l_1 [m], between the discs
        statistics::Uncertain edge_radius;    ///< R_c [m] of the discs where they touch
        statistics::Uncertain young;          ///< E_1 [Pa] of the discs
        statistics::Uncertain poisson;        ///< nu_1 [-]
    };
    struct Substrate {
        statistics::Uncertain young;    ///< E_2 [Pa]
        statistics::Uncertain poisson;  ///< nu_2 [-]
    };
    struct Contact {
        statistics::Uncertain diameter;                      ///< D_c [m] that the evaluation uses
        std::optional<statistics::Uncertain> wear_diameter;  ///< [m] of the wear spots
    };
    struct Spring {
        statistics::Uncertain stiffness;                        ///< [N/m] of the spring alone
        std::optional<statistics::Uncertain> sensor_stiffness;  ///< [N/m], in series with it
        std::optional<statistics::Uncertain> length;            ///< l_s [m] of a rod
        std::optional<statistics::Uncertain> young;             ///< E_s [Pa] of a rod
        std::optional<statistics::Uncertain> height_ratio;  ///< kappa_8 = h/a, where it attaches
    };
    /// Characteristic frequency of the spring force, in the experiment and in its simulation.
    struct Oscillation {
        statistics::Uncertain frequency;                     ///< Omega_exp [Hz]
        statistics::Uncertain simulated;                     ///< omega_sim [-], in units of 1/tau
        statistics::Uncertain time;                          ///< tau [s] that the evaluation uses
        std::optional<statistics::Uncertain> sampling_rate;  ///< [Hz] of the force
    };

    std::string title;
    Specimen specimen;
    Substrate substrate;
    statistics::Uncertain friction_coefficient;  ///< mu
    Contact contact;
    Spring spring;
    std::optional<Oscillation> oscillation;
    std::vector<PrintedValue> printed;
};

}  // namespace tricontact::experiments
