#include "benchmarks/reference/reference_kinds.h"

#include <algorithm>
#include <cmath>

#include "bem/settings.h"
#include "comparisons/half_space/layer.h"
#include "contact/base/error.h"
#include "contact/half_space_scales.h"
#include "contact/load_path.h"
#include "contact/substrates/normal_tangential.h"

namespace tricontact::benchmarks {

namespace {

using contact::Case;
using contact::NormalControl;

[[noreturn]] void refuse(const std::string& assumption, const std::string& remedy) {
    throw contact::InputError("reference: " + assumption + "; " + remedy);
}

bool has_friction_law(const Case& c) {
    return c.friction.law()->ratio_at(1) > 0;
}

}  // namespace

void check_has_reference(const Case& c) {
    if (c.law != Case::Law::linear)
        refuse("small strains and linear elasticity are assumed, but the substrate is hyperelastic",
               "take substrate.material = \"linear\", or a run of fem as the reference");
    c.require_coulomb("a reference", "reference", "take a run of bem-layer as the reference");
    if (c.relaxation)
        refuse("an elastic substrate is assumed, but this one relaxes",
               "remove [substrate.relaxation]");
    if (c.indenter.roughness || contact::is_nominally_flat(c))
        refuse("a smooth body with one contact is assumed, but the indenter is rough or a map",
               "take a smooth indenter");
    if (c.tractive_rolling && !has_carter(c))
        refuse(
            "a contact that stays in its place or rolls back and forth is assumed, or Carter's "
            "cylinder, but this one rolls on",
            "take tricontact run, whose creep curves stand beside closed forms");
    if (c.has_bulk_stress())
        refuse(
            "a substrate that the contact alone loads is assumed, but this one has a bulk stress",
            "omit bulk_stress");
    if (c.period) refuse("one indenter is assumed, but the case repeats it", "remove bem.period");
    if (c.of<bem::Settings>().influence)
        refuse(
            "the elasticity of the case's materials is assumed, but its coefficients come from "
            "a file",
            "remove bem.influence");
}

NormalControl final_normal(const Case& c) {
    return c.prescribed_path ? c.prescribed_path->rows.back().normal
                             : contact::press_step(c).normal;
}

Case pressed_alone(Case c, const NormalControl& control) {
    const bool by_force = control.kind == NormalControl::Kind::force;
    Case::Load load;
    (by_force ? load.normal_force : load.indentation) = control.value;
    load.tangential_ratio = 0;
    load.press = Case::Press::frictionless;
    c.load = load;
    c.rolling.reset();
    c.prescribed_path.reset();
    c.contact.coupling = false;
    return c;
}

bool is_uncoupled(const Case& c) {
    if (!has_friction_law(c) || !c.contact.coupling) return true;
    return !c.layer.thickness && !contact::half_spaces_couple(c.materials());
}

bool would_couple(Case c) {
    c.contact.coupling = true;
    return !is_uncoupled(c);
}

bool is_frictionless(const Case& c) {
    if (!c.is_pressed_only()) return false;
    return is_uncoupled(c) || (!c.prescribed_path && c.load.press == Case::Press::frictionless);
}

bool has_exact_radial_contact(const Case& c) {
    if (c.is_cylindrical() || c.indenter.shape == Case::Shape::ellipsoid) return false;
    if (has_finite_body(c)) return false;
    if (c.interface.is_elastic()) return false;
    return !c.layer.thickness || comparisons::why_no_exact_theory(c).empty();
}

bool has_exact_line_contact(const Case& c) {
    return c.is_line_contact() && !has_finite_body(c) && !c.interface.is_elastic() &&
           (!c.layer.thickness || comparisons::why_no_exact_theory(c).empty());
}

ReferenceValue central_difference(double step, double minus_2, double minus_1, double plus_1,
                                  double plus_2) {
    const double near = (plus_1 - minus_1) / (2 * step), far = (plus_2 - minus_2) / (4 * step);
    return {.value = (4 * near - far) / 3, .grid = std::abs(near - far)};
}

}  // namespace tricontact::benchmarks
