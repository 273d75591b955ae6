#include "atlas/predictable.h"

#include "atlas/prediction.h"
#include "comparisons/adhesion/adhesion_forms.h"
#include "comparisons/quantities/reference.h"
#include "contact/base/error.h"
#include "contact/models/model_kind.h"
#include "theory/rolling/rolled_law.h"

namespace tricontact::atlas {

namespace {

using contact::Case;

/// Compliance of an indenter over that of the layer below which it counts as rigid.
constexpr double rigid_share = 1e-3;

/// What no atlas is about; empty if nothing is in the way.
std::string what_is_not_mapped(const Case& c) {
    if (!contact::is_hertz_round(c) && !c.is_cylindrical())
        return "bodies other than smooth paraboloids, spheres and cylinders";
    if (c.has_hole()) return "pins in holes";
    if (c.tractive_rolling) return "rolling on";
    if (c.prescribed_path) return "prescribed paths";
    if (c.relaxation) return "relaxing substrates";
    if (c.law != Case::Law::linear) return "finite strains";
    if (!comparisons::constant_loads(c)) return "oscillating loads";
    const theory::RolledLaw* law = theory::rolled_law(c.friction);
    if (!law) return "laws of friction other than Coulomb's and a shear strength alone";
    if (c.interface.is_elastic()) return "interfaces with springs";
    if (c.has_bulk_stress()) return "bulk stresses";
    if (c.adhesion) return "surfaces that attract each other";
    if (!law->is_coulomb())
        return c.is_line_contact() ? "line contacts under a shear strength" : "";
    if (c.friction_coefficient() <= 0) return "contacts without friction";
    return "";
}

std::string what_layer_is_not_mapped(const Case& c) {
    const auto& [thickness, base, width, depth, lower, ground] = c.layer;
    if (!thickness) return "a half-space as a layer";
    if (!c.friction.is_coulomb()) return "layers under a shear strength";
    if (base != Case::Base::bonded || !lower.empty())
        return "layers that are not bonded to a rigid base";
    if (width || depth) return "layers of finite width or depth";
    if (!c.contact.coupling) return "layers without coupling of normal and tangential contact";
    if (c.load.press != Case::Press::friction || c.load.press_steps < 20)
        return "layers that are not pressed with friction in 20 steps or more";
    if (const auto& indenter = c.indenter.material)
        if (indenter->plane_compliance() > rigid_share * c.substrate.plane_compliance())
            return "indenters on a layer that are not rigid";
    return "";
}

/// Surfaces that attract each other are no atlas' matter, but theory's.
bool is_predicted_adhesion(const Case& c) {
    return comparisons::adhesive_forms(c).has_value();
}

}  // namespace

std::string what_is_not_mapped(const Case& c, const std::string& model) {
    if (contact::model_kind(model).is_independent() && is_predicted_adhesion(c)) return "";
    if (const std::string what = what_is_not_mapped(c); !what.empty()) return what;
    const contact::ModelKind& kind = contact::model_kind(model);
    if (!kind.has_maps()) return "what " + model + " computes";
    if (kind.is_layer()) return what_layer_is_not_mapped(c);
    if (comparisons::couples(c, model))
        return "half-spaces that couple normal and tangential contact (set contact.coupling = "
               "false, or give a layer)";
    if (kind.is_on_line() && c.is_line_contact()) return "line contacts by MDR";
    return "";
}

std::vector<std::string> predictable_models(const Case& c) {
    if (is_predicted_adhesion(c)) return {contact::models::mdr};
    std::vector<std::string> models;
    // A half-space instead of a layer has to be asked for.
    std::string what = c.layer.thickness ? what_is_not_mapped(c, contact::models::bem_layer) : "";
    if (!what.empty())
        throw contact::InputError("no atlas is about " + what + "; tricontact run computes it" +
                                  (what_is_not_mapped(c, contact::models::mdr).empty()
                                       ? " (the model mdr would leave the layer out)"
                                       : ""));
    for (const contact::ModelKind& model : contact::model_kinds()) {
        if (!model.has_maps()) continue;
        const std::string here = what_is_not_mapped(c, model.name);
        if (here.empty())
            models.emplace_back(model.name);
        else if (what.empty())
            what = here;
    }
    if (models.empty())
        throw contact::InputError("no atlas is about " + what + "; tricontact run computes it");
    return models;
}

}  // namespace tricontact::atlas
