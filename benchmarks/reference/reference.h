#pragma once

#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/case.h"
#include "contact/model_makers.h"

namespace tricontact::benchmarks {

/// A number of the reference and what it is uncertain by, half widths in its own unit (SI).
struct ReferenceValue {
    double value = 0;
    double grid = 0;          ///< what cells, elements and steps leave
    double model = 0;         ///< largest difference of the models that are exact for the case
    double domain = 0;        ///< what a finite block changes against the unbounded layer
    std::string source = {};  ///< "mdr-layer", "Hertz (1882)"

    double bar() const { return std::hypot(grid, model, domain); }
};

/// How fields vary over the surface: with the distance from an axis, along x alone, or along both.
enum class Geometry { axisymmetric, plane, spatial };

/// What the surface of the elastic body carries and does at a point. Tractions [Pa] act on the
/// elastic body, pressure positive in compression; displacements [m], z into the body.
struct SurfaceValues {
    double pressure = 0, traction_x = 0, traction_y = 0;
    double displacement_x = 0, displacement_y = 0, displacement_z = 0;
};

/// Fields of the reference about the centre of the contact.
class ReferenceFields {
  public:
    virtual ~ReferenceFields() = default;
    /// At (x, y) [m]; of plane contacts y does not matter. Displacements are NaN where the
    /// reference does not know them.
    virtual SurfaceValues at(double x, double y) const = 0;
    /// Half widths there, >= 0.
    virtual SurfaceValues bar_at(double x, double y) const = 0;
    /// ∫ p dA over the distance r from the centre [N]; of plane contacts over |x| < r [N/m].
    virtual double load_within(double r) const = 0;
};

/// Means over a square of a given area [m^2] about a point, by 4 x 4 Gauss points: what an element,
/// or a node with its share of faces, stands for.
SurfaceValues mean_values(const ReferenceFields& fields, double x, double y, double area);

/// What small changes of the interface and of the kinematics do to the resultants, to first order,
/// by the envelope theorem: with the fields of three neighbouring depths or shifts. `value` per
/// unit of what changes. Empty where the case has no such thing.
struct FirstOrderEffects {
    /// Of a Winkler layer of the stiffness K [Pa/m] in series with the contact, per 1/K: under a
    /// prescribed depth dF = -(1/2) d/dd ∫ p^2 dA [N Pa/m], under a force
    /// dd = (1/2) d/dF ∫ p^2 dA [Pa].
    std::optional<ReferenceValue> normal_compliance;
    /// Of elastic slip, stick slope K_T, per 1/K_T: dF_T = -(1/2) d/dU ∫ |t|^2 dA [N Pa/m] under a
    /// prescribed shift, dU = (1/2) d/dF_T ∫ |t|^2 dA [Pa] under a force.
    std::optional<ReferenceValue> tangential_compliance;
    /// Gap and normal on the displaced surface: dF = -d/dd ∫ p h'(r) u_r dA [N], or dd [m].
    std::optional<ReferenceValue> displaced_surface;
    /// Pressed with friction in one step instead of the case's steps: change by key of quantity.
    std::map<std::string, ReferenceValue> one_step;
};

/// Keys of Reference::values and of totals of submissions, SI units.
namespace quantity_keys {
inline constexpr const char* normal_force = "normal_force";          ///< F_N [N], [N/m] if plane
inline constexpr const char* indentation = "indentation";            ///< d [m]
inline constexpr const char* tangential_force = "tangential_force";  ///< F_T on the body [N]
inline constexpr const char* shift = "shift";                        ///< U [m]
inline constexpr const char* contact_radius = "contact_radius";      ///< a, half width [m]
inline constexpr const char* peak_pressure = "peak_pressure";        ///< p0 [Pa]
inline constexpr const char* contact_area = "contact_area";          ///< [m^2]
inline constexpr const char* stick_area = "stick_area";              ///< [m^2]
inline constexpr const char* stored_energy = "stored_energy";        ///< [J]
inline constexpr const char* dissipation = "dissipation";            ///< by friction, so far [J]
inline constexpr const char* normal_stiffness = "normal_stiffness";  ///< dF_N/dd [N/m]
inline constexpr const char* tangential_stiffness = "tangential_stiffness";  ///< dF_T/dU [N/m]
inline constexpr const char* torque = "torque";  ///< on the body, about the twist's centre [N m]
inline constexpr const char* creepage = "creepage";  ///< of steady rolling, along it [-]
// Of contacts that roll back and forth:
inline constexpr const char* static_shift = "static_shift";        ///< U before rolling [m]
inline constexpr const char* settled_shift = "settled_shift";      ///< U_sd after shakedown [m]
inline constexpr const char* shift_increment = "shift_increment";  ///< per period, ratcheting [m]
inline constexpr const char* shakedown_limit = "shakedown_limit";  ///< f_T,lim [-]
// Numbers of problems of the catalogue, whose targets say what they are over [-]:
inline constexpr const char* stick_ratio = "stick_ratio";                  ///< c/a
inline constexpr const char* settled_shift_ratio = "settled_shift_ratio";  ///< over all slipping
inline constexpr const char* creepage_ratio = "creepage_ratio";            ///< over a/R or mu a/R
inline constexpr const char* shift_ratio = "shift_ratio";                  ///< over all slipping
inline constexpr const char* increment_ratio = "increment_ratio";          ///< the same
inline constexpr const char* stiffness_ratio = "stiffness_ratio";          ///< over 4 G a
inline constexpr const char* von_mises_ratio = "von_mises_ratio";          ///< over p0
inline constexpr const char* von_mises_depth_ratio = "von_mises_depth_ratio";  ///< over a
inline constexpr const char* c11 = "c11";                                      ///< Kalker's
inline constexpr const char* c22 = "c22";
inline constexpr const char* c23 = "c23";
inline constexpr const char* c33 = "c33";
inline constexpr const char* force_ratio = "force_ratio";    ///< horizontal force over weight
inline constexpr const char* displacement = "displacement";  ///< of an interface [m]
inline constexpr const char* pressure_at_axis = "pressure_at_axis";  ///< [Pa]
inline constexpr const char* pressure_at_0_9 = "pressure_at_0_9";    ///< at r = 0.9 a [Pa]
inline constexpr const char* edge_exponent = "edge_exponent";        ///< s of p ~ r^(s - 1)
}  // namespace quantity_keys

/// A ratio that follows from another number: that number over `denominator` (SI).
struct RatioOf {
    std::string numerator;  ///< of quantity_keys
    double denominator = 1;
};

/// The best that this project knows of the end of a case's path.
struct Reference {
    contact::Case c;
    std::string digest;  ///< of the case: what a kept reference is found by
    Geometry geometry = Geometry::spatial;
    double contact_radius = 0;  ///< a; half width of a plane contact; along x [m]
    std::map<std::string, ReferenceValue>
        values;                           ///< by quantity_keys; what is undefined is not there
    std::vector<std::string> prescribed;  ///< keys of what the case prescribes
    std::shared_ptr<const ReferenceFields> fields;
    FirstOrderEffects effects;
    bool has_tractions = false;        ///< tangential ones, of friction
    std::vector<std::string> models;   ///< that stand behind it, the one of the fields first
    std::vector<std::string> remarks;  ///< sentences: what the reference leaves out
    std::map<std::string, std::string> titles;  ///< of values that a problem names otherwise
    std::map<std::string, RatioOf> ratios;      ///< values that follow from another number
    bool has_singular_edge = false;  ///< p^2 has no integral: there is no L2 norm of the pressure

    const ReferenceValue* find(const std::string& key) const {
        const auto found = values.find(key);
        return found == values.end() ? nullptr : &found->second;
    }
    bool is_prescribed(const std::string& key) const;
    bool has_friction() const { return has_tractions; }
};

/// Computes it; reference_cache.h keeps it for later calls. Throws InputError
/// where no model is a reference for the case (and says which assumption fails), NotConverged.
Reference reference(const contact::Case& c, const contact::ModelRunner& runner,
                    const contact::Say& say = contact::silent);

/// What free sides at the distance `half_width` [m] from the centre of a block, round or square,
/// change of the reference's values, by key: under a prescribed force of the indentation, under a
/// prescribed depth of the force, in SI units. Of bonded layers; empty without a layer, where no
/// theory covers the case, and under friction. By theory/layer/free_sides.h, whose upper estimate
/// ends the bar.
std::map<std::string, ReferenceValue> finite_block_effect(const Reference& reference,
                                                          double half_width);

}  // namespace tricontact::benchmarks
