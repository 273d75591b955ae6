#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "bem/settings.h"
#include "contact/attraction/adhesive_edge.h"
#include "contact/cells.h"
#include "contact/rig_stiffness.h"
#include "contact/substrates/normal_tangential.h"
#include "contact/wearing_contact.h"
#include "io/case/case_checks.h"

namespace tricontact::io {

namespace {

using contact::Case;
using contact::ModelKind;

const std::string omit_adhesion = "leave out [adhesion]";

void check_adhesive_model(const std::string& model, const Case& c, const Document& document) {
    const ModelKind& kind = contact::model_kind(model);
    const std::string key = "adhesion.work";
    if (!kind.sees_adhesion)
        refuse(document, key, model + " knows no surfaces that attract each other",
               "leave out " + model + ", or " + omit_adhesion);
    if (kind.is_on_line() && !c.adhesion->is_short_ranged()) {
        if (kind.is_layer())
            refuse(document, used(document, "adhesion.range", "adhesion.peak_stress"),
                   "the springs of " + model + " let go at the edge alone, the range is 0 there",
                   "leave out " + model + ", or omit the range");
        if (c.adhesion->law != contact::Adhesion::Law::dugdale)
            refuse(document, "adhesion.law",
                   "of a range the springs of " + model + " know a constant tension alone",
                   "leave out " + model + R"(, or take law = "dugdale")");
    }
    const bool is_of_cells = kind.is_on_cells_of(ModelKind::Body::half_space),
               by_cell = is_of_cells && c.of<contact::AdhesiveEdge>().is_by_cell();
    if (!kind.is_on_line() && !by_cell && !c.adhesion->is_reversible())
        refuse(document, "adhesion.approach_work",
               model + " knows one work of adhesion for approach and separation",
               is_of_cells && *c.adhesion->approach_work == 0
                   ? R"(take mdr, mdr-layer or bem.adhesive_edge = "cell", or omit it)"
                   : "take mdr or mdr-layer, or omit it");
    if (kind.couples && c.contact.coupling &&
        (!kind.is_half_space() || contact::half_spaces_couple(c.materials())))
        refuse(document, key,
               "normal and tangential contact of " + model +
                   " are coupled: friction on surfaces that attract each other is not computed",
               "set contact.coupling = false");
}

void check_works(const Case& c, const Document& document) {
    const contact::Adhesion& adhesion = *c.adhesion;
    const std::string key = "adhesion.approach_work";
    if (adhesion.approach_work.value_or(0) > adhesion.work)
        refuse(document, key, "more is gained by the approach than separation takes",
               "give at most adhesion.work");
    if (!adhesion.is_reversible() && !adhesion.is_short_ranged())
        refuse(document, key, "with a range one work of adhesion is computed",
               "omit it, or the range");
}

/// A sphere that is not pressed on a half-space: by Johnson, Kendall and Roberts a^3 = 9 pi w R^2/
/// (2 E*) without a range, by Derjaguin, Muller and Toporov a third of that with a long one.
void check_unloaded_sphere(const Case& c, const Document& document) {
    if (c.indenter.shape != Case::Shape::sphere || c.layer.thickness) return;
    const double factor = c.adhesion->is_short_ranged() ? 4.5 : 1.5, r = c.indenter.radius;
    const double a = std::cbrt(factor * std::numbers::pi * c.adhesion->work * r * r /
                               c.materials().effective_modulus());
    if (a > largest_sphere_ratio * r)
        refuse(document, "adhesion.work",
               "without a load it pulls the sphere into a contact of the radius " + rounded(a) +
                   " m, more than " + rounded(largest_sphere_ratio) + " of its own, " + rounded(r) +
                   " m: small deformations are assumed",
               "check the units of the work, the radius and the moduli");
}

/// Cells that let go one by one.
void check_edge_of_cells(const Case& c, const Document& document) {
    if (!c.of<contact::AdhesiveEdge>().is_by_cell()) return;
    const auto demand = [&](bool holds, const char* rule, const std::string& remedy) {
        if (!holds) refuse(document, "bem.adhesive_edge", rule, remedy + R"(, or take "ring")");
    };
    const auto count = [&](ModelKind::Body body) {
        return std::ranges::count_if(c.models, [&](const std::string& model) {
            return contact::model_kind(model).is_on_cells_of(body);
        });
    };
    demand(count(ModelKind::Body::layer) == 0,
           "the criterion is that of cells of a half-space, which bem-layer has not",
           "leave out bem-layer");
    demand(count(ModelKind::Body::half_space) > 0, "it is bem that has cells of a half-space",
           "add bem to the models");
    demand(c.adhesion->approach_work == 0.,
           "cells that let go one by one gain nothing by the approach",
           R"(set adhesion.approach_work = "0 J/m2")");
    demand(c.is_pressed_only(), "cells that let go one by one carry no friction and do not roll",
           "set load.tangential_ratio = 0 and omit rolling and shifts");
    demand(!c.is_cylindrical() && !c.period && c.of<contact::Cells>().ratio.value_or(1) == 1,
           "the criterion is that of square cells under a body of finite size, on no period",
           "press such a body, and omit bem.cell_ratio");
    demand(!c.of<bem::Settings>().influence,
           "the criterion knows the influence coefficients of a half-space", "omit bem.influence");
}

/// Tangential loads, shifts and rolling.
void check_adhesive_friction(const Case& c, const Document& document) {
    if (!c.friction.is_strength_alone())
        refuse(document, "adhesion.work",
               "what friction carries under tension is known of a shear strength alone, tau_0 "
               "wherever the surfaces touch; the case has tau = " +
                   c.friction.formula(),
               "give friction.shear_strength alone, set load.tangential_ratio = 0 and omit rolling "
               "and shifts, or " +
                   omit_adhesion);
    if (c.tractive_rolling)
        refuse(document, "adhesion.work",
               "rolling on of surfaces that attract each other is not computed",
               "roll back and forth by [rolling], or " + omit_adhesion);
    if (!c.adhesion->is_reversible() &&
        (c.rolling || (c.prescribed_path && c.prescribed_path->reach() != contact::Vector2{})))
        refuse(document, "adhesion.approach_work",
               "a contact that rolls closes in front by less work than opens it behind, and is no "
               "disc then",
               "omit it, or rolling and offsets");
    if (c.has_bulk_stress())
        refuse(document, "adhesion.work",
               "surfaces that attract each other under a bulk stress are not computed",
               "omit bulk_stress, or " + omit_adhesion);
}

}  // namespace

void check_adhesion(const Case& c, const Document& document) {
    if (!c.adhesion) return;
    const std::string key = "adhesion.work";
    check_works(c, document);
    check_unloaded_sphere(c, document);
    if (!c.is_pressed_only()) check_adhesive_friction(c, document);
    if (c.law != Case::Law::linear)
        refuse(document, key, "finite strains know no surfaces that attract each other",
               R"(set substrate.material to "linear", or )" + omit_adhesion);
    if (c.relaxation)
        refuse(document, key, "the work of adhesion of a relaxing substrate is not computed",
               "leave out [substrate.relaxation] or [adhesion]");
    if (c.interface.is_elastic())
        refuse(document, key, "springs between the surfaces do not let go",
               "leave out [interface] or [adhesion]");
    if (c.yield_stress.any())
        refuse(document,
               document.find("substrate.yield_stress") ? "substrate.yield_stress"
                                                       : "indenter.yield_stress",
               "strength is judged of contacts that do not attract each other alone",
               "omit it, or " + omit_adhesion);
    if (c.kept.find<contact::Wear>())
        refuse(document, "wear.cycles", "surfaces that attract each other are not worn",
               "leave out [wear] or [adhesion]");
    const auto* const rig = c.kept.find<contact::RigStiffness>();
    if (rig && rig->yields())
        refuse(document, rig->normal ? "rig.normal_stiffness" : "rig.tangential_stiffness",
               "where a rig yields the place of the jumps is not computed",
               "prescribe what the contact feels, or " + omit_adhesion);
    check_edge_of_cells(c, document);
    for (const std::string& model : c.models) check_adhesive_model(model, c, document);
}

}  // namespace tricontact::io
