#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "contact/base/special_values.h"
#include "contact/case.h"
#include "experiments/assumptions/sliding_slope.h"
#include "io/case/rig_file.h"
#include "statistics/correlations.h"
#include "statistics/estimate.h"

namespace tricontact::experiments {

using statistics::Estimate;

/// A number that a publication states, SI units.
struct PrintedValue : io::UncertainNumber {
    std::string name;    ///< of the quantity: "contact_radius"
    std::string text;    ///< as printed: "4.56 mm"
    std::string source;  ///< "table 5.1.1"
};

/// What a rig measures: U under F_T before it rolls, U after it has rolled until it stands, d under
/// a force, the radius (half the width) of the contact.
enum class Measured { static_shift, settled_shift, indentation, contact_radius };

/// A body pressed by F_N, and then loaded by coupling_tangential_ratio of mu F_N; standard errors
/// are numerical.
struct BodyContact {
    Estimate indentation, contact_radius;  ///< d; of a circle of the contact's area [m]
    Estimate peak_pressure;                ///< [Pa]; NaN under a conical tip
    Estimate static_shift;                 ///< [m]
    /// Of a height map: share of F_N on cells at its border [-].
    double border_force_share = 0;
};
struct BodyContacts {
    BodyContact half_space, layer;  ///< normal and tangential contact uncoupled
    Estimate coupled_static_shift;  ///< on the layer [m]
};

/// A rig's indenter pressed by F_N, with and without Rig::Dgamma, by springs.
struct AttractedContact {
    double pull_off;                ///< [N]
    double radius, radius_without;  ///< [m]
};
struct AttractedContacts {
    AttractedContact half_space, layer;
    std::string why_none = {};  ///< not computed: why, and where; else empty
};

/// A number of a rig; not known until it is stated.
struct RigNumber : Estimate {
    RigNumber() : RigNumber(contact::undefined) {}
    RigNumber(double its_value, double its_error = 0) : Estimate{its_value, its_error} {}
    RigNumber(const Estimate& estimate) : Estimate(estimate) {}
    bool is_known() const { return !std::isnan(value); }
    operator double() const { return value; }
    explicit operator bool() const = delete;  // zero is known
};

/// The numbers of a rig by their symbols in its formulas, SI units. Rolling rigs and those of the
/// micro-walking machine share what both have; their keys: rig_quantities().
struct RigData {
    RigNumber R, L;                     ///< radius and length of the roller
    RigNumber E_1, nu_1, E_2, nu_2;     ///< of roller or disc, and substrate
    RigNumber b, l_x, l_y;              ///< thickness and sides of the layer
    RigNumber mu, F_N, F_T, f_T;        ///< f_T = F_T/(mu F_N)
    RigNumber v, alpha, n, t_rest;      ///< drive: speed, angle to F_T, periods; wait under F_T
    RigNumber a, D_c;                   ///< radius or half width of the contact; its diameter
    RigNumber a_reference;              ///< that w and w_pivot are multiples of
    RigNumber w, W, w_pivot, W_pivot;   ///< least amplitude; that of DU: over a_reference, [m]
    RigNumber W_x = 0, W_y = 0;         ///< reach of rolling from its middle
    RigNumber f_0, f_1, DU;             ///< fastest drive, eigenfrequency; wobble of the shift
    RigNumber f_0_printed, Dh_printed;  ///< f_0, and Dh of the pivot, as published
    RigNumber rho, eta, G_ratio;        ///< density; standard solid: viscosity, G_2/G_1
    RigNumber Dgamma, z_0;              ///< work of adhesion, distance of atoms
    RigNumber h_rms, s_rms;             ///< roughness: heights, slopes
    RigNumber k_th, c_T, k_w;           ///< conductivity, dE/(E dT), wear
    RigNumber theta, theta_axis;        ///< tilt of the surface: along F_T, along the axis
    RigNumber t;                        ///< thickness of a specimen that is no layer
    RigNumber U_a, f_c;                 ///< of a fretting test: half the range of the shift; cycles
    RigNumber sigma;                    ///< bulk stress
    RigNumber Y_1, Y_2;                 ///< yield stresses
    RigNumber q, delta;                 ///< errors of an estimate and of a fit

    // Micro-walking: b and a are half the width and height of the specimen.
    RigNumber m, D, l_1, l_2, R_c;                    ///< mass; discs: diameter, lengths, edge
    RigNumber D_wear, tau;                            ///< of wear spots; characteristic time
    RigNumber k, k_sensor, l_s, E_s;                  ///< of rod and sensor
    RigNumber k_x, k_z, k_s;                          ///< of one contact, of spring and sensor
    RigNumber kappa_8, Omega_exp, omega_sim, f_samp;  ///< see docs/explanation/rig.md
};

/// An experiment whose evaluation takes something for granted.
struct Rig : RigData {
    /// Sphere, cylinder: a heavy roller that lies on a layer of rubber, bonded to a rigid plate,
    /// and is rolled back and forth by a lever. Micro-walking: an hourglass of a body and two discs
    /// that lies with four contact spots in a prism (two planes at 45 degrees) and is dragged by a
    /// rod or spring. Body: as the sphere, but of another shape.
    enum class Kind { sphere, cylinder, body, micro_walking };

    Kind kind = Kind::sphere;
    std::string title;
    contact::Case c = {};  ///< of a rolling rig, by the values
    std::vector<PrintedValue> printed = {};
    std::optional<BodyContacts> body = {};  ///< of Kind::body, by models that the caller has
    /// Of Kind::body, and of a sphere that is not rigid beside its layer; where Dgamma is known.
    std::optional<AttractedContacts> attracted = {};
    std::optional<SlidingSlope> sliding = {};    ///< of a rolling rig's measurement.sliding_force
    std::vector<Measured> measured = {};         ///< what the file has records of; empty: anything
    statistics::Correlations correlations = {};  ///< of the data, by their keys
    std::vector<std::string> uncertain = {};     ///< keys whose numbers have a standard error
};

/// Young's modulus [Pa] that stands for a rigid indenter: beyond what a file can state.
inline constexpr double rigid_young = 1e18;

/// A quantity whose printed value may be compared.
struct PrintedKey {
    std::string_view name;
    io::Dimension dimension = io::Dimension::none;
};
const std::vector<PrintedKey>& printed_keys(Rig::Kind kind);

/// A rolling rig as a case file describes it, with [rig] and [printed] (docs/how-to/rig.md). What
/// the case resolves - a thickness by its ratio, the amplitude of its rolling, a standard solid -
/// is taken from there. Bodies other than spheres and cylinders still need their contacts. Throws
/// contact::InputError in one line, `file:line:column: key = value: rule; remedy`, for what
/// formulas do not cover: layers on anything but a rigid base to
/// which they are bonded, a prescribed indentation.
Rig rolling_rig(const io::RigFile& file);

/// A rig of the micro-walking machine as its case, which has been checked, describes it. `keys`:
/// all that the file may hold.
Rig walking_rig(const io::Document& document, const io::KeyList& keys);

}  // namespace tricontact::experiments
