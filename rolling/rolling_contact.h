#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/base/vector2.h"
#include "contact/bodies/indenter.h"
#include "contact/friction/friction_law.h"
#include "contact/friction/friction_rate.h"
#include "contact/heat.h"
#include "contact/history.h"
#include "contact/load_path.h"
#include "contact/surface.h"
#include "theory/creep_law.h"

/// Tractive rolling: the indenter rolls on in the direction +x over the substrate; the contact is
/// at rest in a frame that moves along, and the substrate flows through it towards -x.
///
/// Slip is the indenter's surface over the substrate's, per rolled way. With u the displacement of
/// the substrate relative to the indenter (see contact::Compliance) and (x, y) measured from the
/// indenter's lowest point, the centre of rotation, it is, once steady,
///   s = (longitudinal - spin y, lateral + spin x) + du/dx,
/// Kalker (1990), Three-Dimensional Elastic Bodies in Rolling Contact, eq. 1.39. Friction acts on
/// the substrate along s: force and creepage have the same sign, and a force along +x is that of a
/// braked indenter.

namespace tricontact::rolling {

using theory::Creepage;

/// What drives the contact: in x and in y either the creepage or the force on the substrate.
struct Drive {
    std::array<std::optional<double>, 2> creepage;  ///< [-]
    contact::Vector2 force{};                       ///< where no creepage is given [N]
    /// In place of force[0]: F_x over mu F_N of each state, which a prescribed depth does not tell.
    std::optional<double> force_ratio{};
    double spin = 0;  ///< phi [1/m]
};

/// Where the search for a steady state begins: nothing slips yet, or all slips without end.
/// Friction that falls with the speed of slip may have several states, of which each of both finds
/// one.
enum class SlipStart { slow, fast };

/// What rolls over a substrate.
struct RollingProblem {
    std::shared_ptr<const contact::Indenter> indenter;
    std::shared_ptr<const contact::FrictionLaw> friction;
    contact::NormalControl normal;
    Drive drive;
    bool coupling = true;     ///< of normal and tangential contact
    double tolerance = 1e-7;  ///< on RollingState::residual
    double speed = 0;         ///< of rolling [m/s], for a relaxing substrate and a rate; 0: slow
    /// Of Coulomb's law at rest, in the steady state; rolling from rest does not know it.
    std::optional<contact::FrictionRate> rate{};
    SlipStart slip_start = SlipStart::slow;
    /// The state that a search from the other start found, to begin with and to be recognised; see
    /// solve_steady_rated. It outlives the problem; null: none.
    const contact::Surface* other_state = nullptr;
    /// Of a steady state whose temperatures are asked for, at `speed`.
    std::optional<contact::ContactHeat> heat{};
    /// Of Coulomb's law by the temperatures of `heat`, in the steady state likewise.
    std::optional<contact::FrictionTemperature> friction_temperature{};
};

/// Temperatures per point of a grid, see temperatures.h.
struct SurfaceTemperatures {
    std::vector<double> indenter, substrate;  ///< of both surfaces [degC]
    std::vector<double> friction_rise = {};   ///< part of both by friction [K]
};

/// Highest temperatures in contact, where both surfaces are as warm.
struct HighestTemperature {
    double value = 0;          ///< [degC]
    double friction_rise = 0;  ///< of the part by friction [K]
};

/// One state of the contact, steady or on the way there.
struct RollingState {
    double distance = 0;        ///< rolled since the contact was at rest [m]; infinite: steady
    Creepage creepage;          ///< of the last rolled cell
    double normal_force = 0;    ///< F_N [N]
    double friction_bound = 0;  ///< summed over the contact [N]
    double indentation = 0;     ///< d [m]
    contact::Vector2 force{};   ///< friction on the substrate [N]
    double spin_moment = 0;     ///< of friction about the centre of spin, on the substrate [N m]
    double half_length = 0;     ///< of the contact in x [m]
    double half_width = 0;      ///< of the contact in y [m]
    double peak_pressure = 0;   ///< [Pa]
    double contact_area = 0;    ///< [m^2]
    double stick_area = 0;      ///< [m^2]
    double slip_area = 0;       ///< [m^2]
    double dissipation = 0;     ///< of friction, per rolled way [J/m]
    double material_dissipation = 0;  ///< of a relaxing substrate, per rolled way [J/m]
    /// Of the pressure on the body's slope, against the rolling [N]: what it takes of work per way.
    double resistance = 0;
    /// Moment of the pressure about y through the centre over F_N [m]: positive where the pressure
    /// leans forward and resists.
    double pressure_lead = 0;
    int iterations = 0;   ///< applications of the compliance
    double residual = 0;  ///< see contact::TangentialSolver; steady: solve_steady [-]
    std::optional<HighestTemperature> temperature{};  ///< of a steady state, where asked for
};

/// What was computed of one problem.
struct RollingHistory {
    std::vector<RollingState> transient;  ///< from rest, a state per rolled cell; first: at rest
    RollingState steady;
    std::optional<RollingState> from_fast_slip;  ///< see SlipStart; empty: not looked for, or why
    std::string why_no_fast_slip = {};           ///< the search did not end in one: why
    contact::Surface surface;  ///< steady; slip [-] and dissipation [Pa] per rolled way
    std::optional<SurfaceTemperatures> temperatures = {};  ///< steady, where asked for
};

/// What follows from the fields of a grid under a body: forces, moments, areas, extent and
/// friction's dissipation. Slip and dissipation of `surface` are those per rolled way, its offset
/// is the contact's centre.
RollingState state_of(const contact::Surface& surface, const contact::Indenter& indenter);

}  // namespace tricontact::rolling
