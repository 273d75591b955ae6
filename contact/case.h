#pragma once

#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/attraction/adhesion.h"
#include "contact/base/bulk_state.h"
#include "contact/base/typed_values.h"
#include "contact/bodies/indenter.h"
#include "contact/bodies/indenter_data.h"
#include "contact/friction/friction.h"
#include "contact/interface.h"
#include "contact/prescribed_path.h"
#include "contact/solvers/contact_options.h"
#include "contact/substrates/material.h"
#include "contact/substrates/relaxation.h"

namespace tricontact::contact {

/// What a case file says, in SI units, as the user said it: where a quantity may be given as a
/// value or as a ratio, exactly one of the two is set.
struct Case {
    using IndenterData = contact::IndenterData;
    using Shape = IndenterData::Shape;
    using Heights = IndenterData::Heights;
    enum class AmplitudeReference { hertz, model };
    enum class Steps { increment, per_quarter, turning_points };
    enum class Base { bonded, frictionless, half_space };
    enum class Press { friction, frictionless };
    enum class Law { linear, neo_hookean, mooney_rivlin };

    /// The substrate's finite size; half-space models do not see it.
    struct Layer {
        struct Lower {
            double thickness = 0;  ///< [m]
            Material material{0, 0};
        };
        std::optional<double> thickness;  ///< b [m]
        Base base = Base::bonded;         ///< what the lowest layer rests on
        std::optional<double> width;      ///< along x [m]; empty: unbounded
        std::optional<double> depth;      ///< along y [m]; empty: unbounded
        std::vector<Lower> lower;         ///< further elastic layers below, from the top down
        std::optional<Material> ground;   ///< the half-space of Base::half_space

        double total_thickness() const;  ///< of all layers; `thickness` must be there [m]
    };

    /// Of the substrate: flat, that of a layer or a half-space, or a round hole along y.
    enum class SubstrateShape { layer, hole };

    /// A plate about a hole, whose lowest point the indenter presses on.
    struct Hole {
        double radius = 0;
        double outer_radius = 0;  ///< where the plate ends and is held [m]; 0: it is rigid
    };

    using Contact = ContactOptions;

    /// Yield stresses of the bodies [Pa], for findings alone: all models are elastic.
    struct YieldStresses {
        std::optional<double> indenter, substrate;
        bool any() const { return indenter || substrate; }
    };

    struct Load {
        std::optional<double> normal_force;      ///< F_N [N]
        std::optional<double> indentation;       ///< d [m], instead of normal_force
        std::optional<double> tangential_force;  ///< F_T [N] along x
        std::optional<double> tangential_ratio;  ///< F_T / (mu F_N), instead of tangential_force
        std::optional<double> limit_fraction;    ///< of the model's own limit, see own_limit.h
        /// Instead: the share of the way from the model's own limit to mu F_N, in (0, 1).
        std::optional<double> limit_excess;
        /// Superposed oscillation in the rolling period's phase: the normal control (force or
        /// indentation) and F_T are multiplied by 1 + ratio * triangle(phase + shift).
        double normal_amplitude_ratio = 0;      ///< [-], in [0, 1)
        double normal_phase = 0;                ///< [rad]
        double tangential_amplitude_ratio = 0;  ///< [-]
        double tangential_phase = 0;            ///< [rad]
        /// Of the substrate along x, tension positive, which acts and changes with F_T [Pa].
        double bulk_stress = 0;
        /// How coupled models are pressed before F_T acts: with friction, F_N rising in equal
        /// steps, or in one step without friction.
        Press press = Press::friction;
        int press_steps = 20;
        /// Time, which only a relaxing substrate feels: of the pressing (in press_steps equal
        /// parts; empty: slow, all relaxes), then, F_T having been applied at once, of the wait
        /// before rolling begins.
        std::optional<double> press_time;  ///< [s]
        double hold = 0;                   ///< [s]

        /// F_T is said by the model's own limit of shakedown.
        bool is_by_limit() const { return limit_fraction || limit_excess; }
        /// The key that says so; null if there is none.
        const char* limit_key() const;
        /// A tangential force is asked for, in whatever way.
        bool is_tangential() const {
            return tangential_force.value_or(0) != 0 || tangential_ratio.value_or(0) != 0 ||
                   is_by_limit();
        }
        /// F_T/(mu F_N) of a load by this limit.
        double ratio_by_limit(double limit) const;
        /// F_T/(mu F_N) in place of whatever says F_T.
        void set_tangential_ratio(double ratio);
    };

    /// What ends a run: `periods`, or a shift that is known where it will stand (see Verdict).
    enum class Until { periods, settled };

    struct Rolling {
        std::optional<double> amplitude;        ///< W [m]
        std::optional<double> amplitude_ratio;  ///< w = W over a contact radius, instead
        AmplitudeReference amplitude_reference = AmplitudeReference::hertz;
        double angle = 0;      ///< between rolling direction and tangential load [rad]
        int periods = 12;      ///< at most
        bool run_all = false;  ///< do not stop at shakedown
        Until until = Until::periods;
        Steps steps = Steps::per_quarter;
        double increment = 0;       ///< dW [m], for Steps::increment
        int steps_per_quarter = 6;  ///< for Steps::per_quarter
        double speed = 0;           ///< v of the drive [m/s]; 0: infinitely slow
    };

    /// Rolling on in x, after pressing: each of the two directions is driven by its force or by its
    /// creepage. F_T of the load acts in x where the longitudinal creepage is not given.
    struct TractiveRolling {
        std::optional<double> longitudinal_creepage;  ///< xi, slid over rolled way [-]
        std::optional<double> lateral_creepage;       ///< eta [-]; empty: no lateral force
        double spin = 0;      ///< phi, rotation about z per rolled way [1/m]
        double distance = 0;  ///< rolled from rest, over the contact's half length a [-]
        double speed = 0;     ///< v [m/s], which only a relaxing substrate feels; 0: slow
    };

    std::string title;
    std::vector<std::string> models;
    IndenterData indenter;
    Material substrate{0, 0};          ///< of a relaxing one: its relaxed state
    bool has_rigid_substrate = false;  ///< `substrate` is rigid_material then
    SubstrateShape substrate_shape = SubstrateShape::layer;
    Hole hole;                             ///< of SubstrateShape::hole
    Law law = Law::linear;                 ///< of the substrate in fem; others are linear
    std::optional<double> c01_ratio;       ///< c01/(c10 + c01) of Mooney and Rivlin's law [-]
    std::optional<Relaxation> relaxation;  ///< of the substrate; empty: elastic
    std::optional<double> period;          ///< of indenters and tractions along x and y [m]
    Layer layer;
    YieldStresses yield_stress;
    Friction friction;
    Interface interface;
    std::optional<Adhesion> adhesion;  ///< empty: surfaces that do not attract each other
    Contact contact;
    Load load;
    std::optional<Rolling> rolling;                   ///< empty: static loading only
    std::optional<TractiveRolling> tractive_rolling;  ///< instead of `rolling`
    /// Instead of `rolling`; `load` then has its hardest normal control and no F_T.
    std::optional<PrescribedPath> prescribed_path;

    /// What others keep with a case under types of their own: the settings of models, as
    /// bem::Settings, the cells of a surface, what is written, how the file says the case.
    TypedValues kept;
    /// T as it is kept, or by default.
    template <class T>
    const T& of() const {
        return kept.of<T>();
    }
    template <class T>
    T& of() {
        return kept.of<T>();
    }

    /// Of a body that is long along y: pressures and tractions are uniform over its length.
    bool is_line_contact() const {
        return indenter.shape == Shape::cylinder || indenter.is_long_punch();
    }
    /// Of a round body along y that ends on either side, and rolls in x.
    bool is_cylindrical() const {
        return indenter.shape == Shape::cylinder || indenter.shape == Shape::roller;
    }
    bool has_hole() const { return substrate_shape == SubstrateShape::hole; }
    /// R of the gap x^2/(2 R) between the bodies [m]: in a hole 1/R = 1/R_pin - 1/R_hole.
    double relative_radius() const {
        if (!has_hole()) return indenter.radius;
        return indenter.radius * hole.radius / (hole.radius - indenter.radius);
    }
    /// mu [-], for what presumes Coulomb's law. Throws InputError if friction follows another.
    double friction_coefficient() const;
    /// What a case may have beside two elastic bodies that touch, and not every command knows.
    enum class Extra { elastic_interface, bulk_stress, adhesion, relaxing_indenter };
    /// For a command that knows no extras but the `known` ones, `what` its subject in the plural:
    /// "maps", "designs". Throws InputError if the case has another.
    void refuse_extras(const std::string& what, std::initializer_list<Extra> known = {}) const;
    /// For what presumes Coulomb's law, tau = mu p, and is no run of a model: `what` ("a
    /// deviation"), `place` of messages, `instead` what else could be done, if anything. Throws
    /// InputError if friction follows another law.
    void require_coulomb(const std::string& what, const std::string& place = "friction",
                         const std::string& instead = {}) const;
    /// Of the substrate under this stress along x [Pa].
    BulkState bulk_state(double stress) const {
        return contact::bulk_state(substrate, stress, is_line_contact());
    }
    /// Whether the load or a row of the path has one.
    bool has_bulk_stress() const;
    /// Neither load, path nor rolling asks for anything but the normal load.
    bool is_pressed_only() const;
    /// At a phase of a run [Pa].
    double bulk_stress_at(double phase) const;
    MaterialPair materials() const { return {indenter.material, substrate}; }
    /// With its roughness.
    std::unique_ptr<Indenter> make_indenter() const;
    /// Throws InputError for a shape that is no body of revolution.
    std::unique_ptr<AxisymmetricIndenter> make_axisymmetric_indenter() const;
};

/// What ratios refer to: the case's body pressed without friction on the half-space. Hertz'
/// solution for paraboloid and sphere, its interface rigid, see half_space_scales.h for cylinder
/// and roller, half_space_scales.h for nominally flat bodies. SI units.
struct HalfSpaceScales {
    double contact_radius;  ///< a [m]; half width of a line contact, of an ellipse the geometric
                            ///< mean of both half axes
    double indentation;     ///< d [m]
    double normal_force;    ///< F_N [N]
    double peak_pressure;   ///< p0 [Pa] at the centre; the mean under a conical tip: infinite there
    double unit_shift;  ///< U_max [m], mu (E*/G*) d of Coulomb's law on a body of revolution; see
                        ///< half_space_scales.cc for ellipses, lines and other laws
    Vector2 half_widths{};    ///< of the contact along x and y [m]
    double friction_limit{};  ///< what friction carries in all [N], mu F_N of Coulomb's law
};
HalfSpaceScales half_space_scales(const Case& c);

/// Friction over pressure to be expected of the case [-]: mu of Coulomb's law, else that at its
/// mean pressure on the half-space.
double expected_friction(const Case& c);

/// A smooth paraboloid or sphere: what formulas with one radius R are about.
bool is_hertz_round(const Case& c);
/// The same under Coulomb's law of friction on a rigid interface, the substrate loaded by the
/// contact alone: what Cattaneo and Mindlin's formulas, kappa and eta are about.
bool is_coulomb_round(const Case& c);
/// Whether the pressure at the centre is infinite.
bool has_conical_tip(const Case& c);

/// W [m] of the case, `reference_radius` being the contact radius that a ratio refers to [m].
double rolling_amplitude(const Case::Rolling& rolling, double reference_radius);

/// Whether the pressure is known to fall from the centre on, as Hertz' does: not under power laws
/// of n > 2, punches, rough bodies and profiles of tables. If so, the least pressure on a path is
/// that at one of its ends.
bool pressure_falls(const Case& c);

/// Distance of the sides of a layer's block from the load at which they are hardly felt, in
/// thicknesses of all layers: the block of finite elements is chosen by it.
double far_sides(const Case& c);

}  // namespace tricontact::contact
