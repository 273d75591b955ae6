#pragma once

#include <optional>
#include <vector>

#include "walking/machine/bed.h"
#include "walking/machine/spot.h"

namespace tricontact::walking {

/// Dimensionless parameters of a micro-walking machine: a body of mass m, half height a, half width
/// b and moment of inertia Theta on contact spots of stiffness k_x and k_z, dragged by a spring k_s
/// at height h above its centre of gravity, whose base moves at v_0. Lengths are in units of b,
/// times of sqrt(m/k_x). Wetter (2016), table 4.1.1.
struct Kappas {
    double kappa1 = 0;  ///< k_s/k_x
    double kappa2 = 0;  ///< k_z/k_x
    double kappa3 = 0;  ///< a/b
    double kappa4 = 0;  ///< m g/(k_x b)
    double kappa5 = 0;  ///< friction coefficient mu
    double kappa6 = 0;  ///< (v_0/b) sqrt(m/k_x)
    double kappa7 = 0;  ///< Theta/(m b^2)
    double kappa8 = 0;  ///< h/a

    bool operator==(const Kappas&) const = default;
};

/// Friction above which the sliding body tilts over its leading spot; infinite where the spring
/// pulls at or below the base. Wetter (2016), eq. 4.2.13.
double critical_friction(const Kappas& kappas);

/// What the motion may make use of; taking one away tells how much it matters.
struct Mechanisms {
    bool vertical = true;  ///< else z stays at rest
    bool rotation = true;  ///< else phi stays 0
    bool coupling = true;  ///< else friction is bounded by mu times the spots' static normal forces

    bool operator==(const Mechanisms&) const = default;
};

/// Harmonic load on the body from outside, sin(omega t).
struct Excitation {
    double moment = 0;     ///< amplitude, counter-clockwise, in units of k_x b^2
    double force = 0;      ///< amplitude, downwards, in units of k_x b
    double frequency = 0;  ///< omega, in units of sqrt(k_x/m)

    bool operator==(const Excitation&) const = default;
};

/// A micro-walking machine, dimensionless.
struct Machine {
    enum class Model {
        two_spot,  ///< at both ends of the base: Wetter (2016), section 4.1.3
        prism,     ///< the same in a prism of 45 degrees, two contacts a side: section 5.2.3, B.4
        spots      ///< any number, anywhere along the base
    };

    Kappas kappas;
    Model model = Model::two_spot;
    std::vector<Spot> spots = {};  ///< of Model::spots only
    std::optional<Bed> bed = {};   ///< of every spot; not in the prism
    Mechanisms mechanisms = {};
    Excitation excitation = {};
    double tilting_angle = 0.1;  ///< |Phi| [rad] above which it counts as tilting

    bool operator==(const Machine&) const = default;
};

/// The spots that carry the machine: its own, or those of its model, left one first.
std::vector<Spot> spots_of(const Machine& machine);

/// The springs that carry it: its spots, or those of their beds, spot after spot.
std::vector<Spot> springs_of(const Machine& machine);

/// Vertical displacement at rest with phi = 0, in units of b; kappa4/(2 kappa2) for two spots at
/// the base plane: Wetter (2016), eq. 4.1.22. Prism: tangential springs of its flanks at rest.
double static_displacement(const Machine& machine);

/// Factor of the friction force in <f_s> = factor mu kappa4 for steady sliding: 1, or sqrt(2) in
/// the prism: Wetter (2016), eqs. 4.1.24 and 5.2.26.
double normal_load_factor(const Machine& machine);

/// f_s while all spots slide, in units of k_x b: the one that mu_e = 1 stands for.
double sliding_force(const Machine& machine);

/// Friction above which the steadily sliding machine tilts over its leading spot; infinite where
/// the spring pulls at or below the base. Wetter (2016), eq. 4.2.13, for spots anywhere and with
/// the larger friction of the prism.
double critical_friction(const Machine& machine);

/// |phi| above which the machine counts as tilting. At the 0.1 rad that a machine has by default
/// the sine of the small rotation that the model assumes is off by 0.2 % and its cosine by 0.5 %.
/// One that vibrates in the range of its static displacement stays far below, one that tilts goes
/// through any limit; large ones let machines that jump high go on.
double tilting_limit(const Machine& machine);

/// Frequency of the spring force while the body is in the air, in cycles per unit time: with
/// e = x_s - x + kappa8 phi, e'' = -kappa1 (1 + kappa3^2 kappa8^2/kappa7) e follows from Wetter
/// (2016), eqs. 4.1.17 and 4.1.19, to first order in phi.
double free_flight_frequency(const Kappas& kappas);

}  // namespace tricontact::walking
