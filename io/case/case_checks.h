#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "contact/case.h"
#include "contact/half_space_scales.h"
#include "contact/models/model_kind.h"
#include "io/keys/key_checks.h"

// Rules that join several keys, one file of them each; case_checks.cc calls the others. All throw
// contact::InputError that points into the document.
namespace tricontact::io {

/// Of an indenter over the substrate, up to which layers count it as rigid.
inline constexpr double largest_compliance_ratio = 1e-3;

/// Of a contact's radius over that of a sphere, whose equator it stays far from.
inline constexpr double largest_sphere_ratio = 0.5;

/// Whether a model of the case has this property of ModelKind.
template <class Property>
bool computes(const contact::Case& c, const Property& property) {
    return std::ranges::any_of(c.models, property, contact::model_kind);
}

/// Whether all have, and there are some.
template <class Property>
bool all_have(const contact::Case& c, const Property& property) {
    return !c.models.empty() && std::ranges::all_of(c.models, property, contact::model_kind);
}

/// Keys of a force or shift that alternates about zero: a path that [load] says.
inline constexpr std::array oscillation_keys{"load.tangential_amplitude", "load.shift_amplitude"};
/// The key that says the path: where the rows of [path] come from, or an oscillation.
std::string path_key(const Document& document);
/// Whether there is one.
inline bool says_path(const Document& document) {
    return document.find_section("path") ||
           std::ranges::any_of(oscillation_keys, [&](auto* key) { return document.find(key); });
}

/// The key that says that force.
inline std::string tangential_key(const contact::Case& c) {
    if (c.load.is_by_limit()) return c.load.limit_key();
    return c.load.tangential_force ? "load.tangential_force" : "load.tangential_ratio";
}

/// The key that presses the contact.
inline std::string load_key(const Document& document) {
    if (document.find_section("path")) return path_key(document);
    return document.find("load.indentation") ? "load.indentation" : "load.normal_force";
}

/// 1 - F_T/(mu F_N) that solvers over surfaces need: they balance forces to 1e-10 of mu F_N, and
/// what a contact that all but slides still holds back goes with the square of the angles between
/// tractions and force, 1e-3 here. The springs of mdr have no angles.
inline constexpr double closest_to_sliding = 1e-6;

/// Reads the rows of [path], in place of the keys of [load] that they prescribe.
void resolve_path(contact::Case& c, const Document& document);

/// Makes the path of a force or shift that alternates about zero.
void resolve_oscillation(contact::Case& c, const Document& document);

/// Prescribed paths: the bodies, models and materials know the motions, and friction carries the
/// forces.
void check_prescribed_path(const contact::Case& c, const Document& document);

/// Yield stresses go with what strength is known of: Hertz' contacts on half-spaces.
void check_yield_stress(const contact::Case& c, const Document& document);

/// A bulk stress goes with a half-space that is elastic, and with a contact that does not roll.
void check_bulk_stress(const contact::Case& c, const Document& document);
/// [wear]: a path with a closed cycle that does not roll, friction and substrate that forget, and
/// models that have a place for a worn profile.
void check_wear(const contact::Case& c, const Document& document);

/// Rules that concern several keys at once: friction limit, coupling of the materials, scale of
/// the contact against the indenter, resolution and cost.
void check_case(const contact::Case& c, const Document& document);

/// bem.influence: the file is there, and one model is to use it. output.volume: the inside is
/// known. bem.period: the model is one whose mean displacement is defined, the period holds a whole
/// number of cells and more than the rolling path, and layers that cannot be compressed have room
/// to give way.
void check_bem_options(const contact::Case& c, const Document& document);

/// Bounds of the contact radius on a layer of whatever Poisson's ratio and base [m], the load at
/// the crest of its oscillation. The extreme is the bonded incompressible layer: under a given
/// force `low` is 0.72 to 0.97 of its radius for b/a from 0.025 to 10 (exact layer, Fredholm's
/// equation of frictionless contact: Lebedev and Ufliand 1958).
struct RadiusBounds {
    double low, high;
};
RadiusBounds contact_radius_bounds(const contact::Case& c);

/// Rules for the finite element layer: there is a layer, the indenter is as good as rigid, contact
/// and rolling path have elements enough and not too many and fit on the block. `steps` [-]: of the
/// whole run.
void check_fem(const contact::Case& c, double steps, const Document& document);
/// The body that rolls: of revolution about the axis that it rolls about.
inline bool is_cylinder_on_hub(const contact::ElasticBody& body) {
    return body.form == contact::ElasticBody::Form::cylinder &&
           body.support == contact::ElasticBody::Support::hub;
}
/// The same of a sphere, for bodies that roll on.
inline bool is_round_on_hub(const contact::ElasticBody& body) {
    return body.support == contact::ElasticBody::Support::hub &&
           (body.form == contact::ElasticBody::Form::cylinder ||
            body.form == contact::ElasticBody::Form::ball);
}
/// A cylinder on a hub turns no farther to either side than by 115 degrees, two radii of way, and
/// its inside is shown where it stands upright.
void check_rolling_on_hub(const std::string& model, const contact::Case& c,
                          const Document& document);
/// What fem computes of an indenter's body.
void check_fem_body(const contact::Case& c, const Document& document);

/// The key that says how thick the layer is.
inline std::string thickness_key(const Document& document) {
    return used(document, "substrate.thickness", "substrate.thickness_ratio");
}

/// Makes a thickness of its ratio to the contact on the half-space.
void resolve_thickness(contact::Case& c, const Document& document);

/// Makes the case's lower layers of the lists of [lower_layer].
void resolve_lower_layers(contact::Case& c, const Document& document);

/// The lists of [lower_layer] from the case's lower layers, for the writer.
void state_lower_layers(contact::Case& c);

/// [ground] and substrate.base = "half-space" go together.
void check_ground(const contact::Case& c, const Document& document);

/// The case has layers that this model can take.
void check_layer(const std::string& model, const contact::Case& c, const Document& document);

/// What cylinder and roller cannot be combined with; nothing for other bodies.
void check_line_contact(const contact::Case& c, const Document& document);

/// Reads the file of a height map.
void resolve_height_map(contact::Case& c, const Document& document);

/// What finite elements of a section can have, see ModelKind::Cut.
void check_section(const contact::ModelKind& kind, const contact::Case& c,
                   const Document& document);

/// The body of an indenter that deforms goes with its shape and support, a rigid substrate and an
/// upper plate with what is said of them and with the models.
void check_bodies(const contact::Case& c, const Document& document);

/// [upper_plate]: the part of the case, before its keys are read.
void make_upper_plate(contact::Case& c, const Document& document);

/// A hole goes with a cylinder that fits into it, with models that know it, and with what is
/// pressed without friction.
void check_hole(const contact::Case& c, const Document& document);

/// Punches with a sharp edge or along y are known to models of sections, and do not roll.
void check_punch(const contact::Case& c, const Document& document);

/// Height maps, planes and roughness: models that can, a period that fits, cells that resolve, and
/// nothing that refers to a radius of contact where there is none.
void check_rough_bodies(const contact::Case& c, const Document& document);

/// The numbers of [friction] go together, and with the models.
void check_friction(const contact::Case& c, const Document& document);

/// Models and materials know the springs of [interface].
void check_interface(const contact::Case& c, const Document& document);

/// Models, bodies and loads know surfaces that attract each other.
void check_adhesion(const contact::Case& c, const Document& document);

/// F_T points along x except where the body rolls on, and stays below mu F_N all along the path, by
/// what the models can tell. With a prescribed indentation they find F_N, and check again.
void check_friction_limit(const contact::Case& c, const contact::HalfSpaceScales& scales,
                          const Document& document);

/// Refuses what does not go with [tractive_rolling].
void check_tractive_rolling(const contact::Case& c, const Document& document);

/// The word that stands for a shape in case files.
std::string_view word_of(contact::Case::Shape shape);

/// Throws contact::InputError at a key of [indenter] that the case's shape, which has been read,
/// does not take.
void check_indenter_keys(const contact::Case& c, const Document& document);

/// Reads what `indenter.file` holds of a profile. Throws contact::InputError at the key.
void resolve_indenter_file(contact::Case& c, const Document& document);

/// Reads the table of friction.map.
void resolve_friction_map(contact::Case& c, const Document& document);

/// Turns whichever of the four ways a case took (`relaxation_input`) into the branches of
/// `relaxation`, and into the moduli and times that say the same. Without relaxation it does
/// nothing. Throws contact::InputError; contact::NotConverged if no series fits a DMA table.
void resolve_relaxation(contact::Case& c, const Document& document);

/// Makes moduli and times say what `relaxation` is, wherever it comes from.
void state_relaxation(contact::Case& c);

/// Rules for a relaxing substrate: steps between turning points, and a bulk modulus that the
/// models can take. Throws contact::InputError.
void check_relaxation(const contact::Case& c, const Document& document);

/// [indenter.heat], [substrate.heat]: the contact rolls on, by models that know where it is heated,
/// so fast that heat flows into the depth alone, and not through a layer.
void check_heat(const contact::Case& c, const contact::HalfSpaceScales& scales,
                const Document& document);

}  // namespace tricontact::io
