#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/base/vector2.h"
#include "contact/friction/friction_rate.h"
#include "contact/heat.h"
#include "contact_program/case_digits.h"
#include "contact_program/sequence_step.h"

namespace tricontact::contact_program {

/// Undeformed distance of the bodies of an input file [m].
struct UndeformedDistance {
    int line = 0;  ///< of IBASE
    int data_line = 0;
    int planform = 1;  ///< IPLAN; 1: unrestricted
    /// A, B [1/m] of h = A (x - x0)^2 + B (y - y0)^2 - depth, unless there are heights.
    contact::Vector2 curvature{};
    contact::Vector2 offset{};  ///< (x0, y0) [m]
    double depth = 0;           ///< of the lowest point below the height 0 [m]
    bool is_turned = false;     ///< its axes are not those of x and y
    bool is_inclined = false;   ///< along an axis without curvature
    /// Per cell, x fastest; null: quadratic.
    std::shared_ptr<const std::vector<double>> heights;
    std::function<double(double x, double y)> height_at;  ///< of them [m]; empty: listed
};

/// Layer between the bodies, M = 4.
struct ThirdBody {
    int line = 0;
    double shear_modulus = 0;  ///< GG3 [Pa]
    double thickness = 0;      ///< LAYTHK [m]; 0: no layer
    double yield_stress = 0;   ///< TAU_C0 [Pa]; none up to 0
    double hardening = 0;      ///< K_TAU [Pa/m]
};

/// FACPHI where it is not given.
inline constexpr double usual_spin_ahead = 1. / 6;

/// One case of an input file of CONTACT's module 3, complete: what it keeps of the one before is
/// copied. SI units.
struct ProgramCase {
    CaseDigits digits;
    int loads_line = 0;
    double normal = 0;  ///< F_N [N], or PEN [m] where N = 0, from the height 0
    SequenceStep step;  ///< what it does

    double tolerance = 0;  ///< EPS
    int friction_line = 0;
    int friction_law = 0;             ///< L of the last one that was not kept
    double friction_coefficient = 0;  ///< at rest, of the last L that was not kept
    /// L = 2 to 4: how it falls with the speed of slip; empty: Coulomb's law.
    std::optional<contact::FrictionRate> friction_rate;

    /// L = 6: how it changes with the temperature.
    std::optional<contact::FrictionTemperature> friction_temperature;
    bool has_temperature_memory = false;  ///< MEMDST > 0

    int rolling_line = 0;
    double direction = 0;    ///< CHI [rad]
    double step_length = 0;  ///< DQ [m]
    double speed = 0;        ///< VELOC [m/s]
    double spin_ahead = 0;   ///< FACPHI: where spin is taken, of a step ahead of a cell's centre

    int materials_line = 0;
    int influence = 0;                                 ///< C of the last one that was not kept
    std::string influence_file;                        ///< CFNAME of C = 9
    std::array<double, 2> poisson{}, shear_modulus{};  ///< bodies 1 and 2 [-], [Pa]
    /// M = 1: creep compliance J(t) = (1 + f (1 - exp(-t/tau)))/G.
    std::array<double, 2> creep_ratio{}, creep_time{};  ///< FG, TC: f [-], tau [s]
    std::optional<ThirdBody> third_body;                ///< of the last M = 4 that was not kept
    /// Of the last H = 3: body 1 is the indenter.
    std::optional<contact::ContactHeat> heat;

    int cells_line = 0;
    bool is_hertzian = false;  ///< cells and distance follow from Hertz' theory
    int n_x = 0, n_y = 0;
    contact::Vector2 first{}, spacing{};  ///< centre of the first cell, and their size [m]

    UndeformedDistance distance;
    bool has_extra_slip = false;  ///< E = 9, or kept
    double deepest = 0;           ///< of the points inside [m]; 0: none is asked for
};

/// Reads all cases of an input file; `name` stands for it in messages. Throws contact::InputError
/// with line and column for what is no such file. Whether a case is one here is another question
/// (check_known).
std::vector<ProgramCase> read_program_cases(std::string text, const std::string& name);

/// Throws contact::InputError, naming file and line, for what no model here computes.
void check_known(const ProgramCase& one, const std::string& name);

}  // namespace tricontact::contact_program
