#include <algorithm>

#include "contact/bodies/body_shapes.h"
#include "fem/settings.h"
#include "io/case/case_checks.h"
#include "io/results/output.h"

namespace tricontact::io {

namespace {

using contact::Case;
using contact::ElasticBody;
using contact::ModelKind;

/// Refuses in the name of a model.
class Refusal {
  public:
    Refusal(const ModelKind& kind, const Document& document) : kind_(kind), document_(document) {}
    [[noreturn]] void operator()(const std::string& key, const std::string& rule,
                                 const std::string& remedy) const {
        refuse(document_, key, std::string(kind_.name) + ' ' + rule, remedy);
    }

  private:
    const ModelKind& kind_;
    const Document& document_;
};

void check_section_substrate(const Case& c, const Refusal& refuse_key) {
    if (c.law != Case::Law::linear)
        refuse_key("substrate.material", "knows small strains alone",
                   "take fem, or set substrate.material to \"linear\"");
    if (c.has_hole()) return;
    if (c.has_rigid_substrate) {
        if (!c.indenter.body)
            refuse_key("substrate.rigid", "needs the size of a body that is to deform on it",
                       "give indenter.body");
        return;
    }
    if (!c.layer.thickness)
        refuse_key("models", "meshes a layer, but the case has no substrate.thickness",
                   "give it, or substrate.rigid = true with an indenter.body");
    if (c.layer.base == Case::Base::half_space)
        refuse_key("substrate.base", "has its layer on a rigid ground",
                   "take \"bonded\", or bem-layer");
    if (!c.layer.lower.empty())
        refuse_key("lower_layer.thickness", "meshes one layer", "take fem or bem-layer for more");
}

void check_section_indenter(const Case& c, const Refusal& refuse_key) {
    if (c.indenter.body && c.indenter.body->form == ElasticBody::Form::mesh)
        refuse_key("indenter.mesh", "meshes a section of its own", "take fem, or indenter.body");
    if (c.indenter.roughness)
        refuse_key("indenter.roughness.hurst", "knows smooth bodies alone", "take bem");
    if (c.indenter.body || !c.indenter.material) return;
    const double ratio = c.indenter.material->plane_compliance() / c.substrate.plane_compliance();
    if (ratio > largest_compliance_ratio)
        refuse_key("indenter.young", "meshes an indenter that deforms, whose size is not known",
                   "give indenter.body, or omit young and poisson to make it rigid");
}

void check_section_elements(const Case& c, const Document& document, const Refusal& refuse_key) {
    if (document.find("fem.mesh")) refuse_key("fem.mesh", "makes its own mesh", "leave it out");
    if (c.of<fem::Settings>().solver == fem::Solver::iterative)
        refuse_key("fem.solver", "has a factor that is small", "leave it out");
    if (c.of<fem::Settings>().sides == fem::Sides::fixed)
        refuse_key("fem.sides", "has the sides of the layer far away", "leave it out");
    if (c.relaxation && c.of<Output>().volume != Output::Volume::none)
        refuse_key("output.volume", "shows the inside of elastic bodies",
                   "leave it out, or omit [substrate.relaxation]");
    if (c.period) refuse_key("bem.period", "knows one contact alone", "leave it out");
}

void check_rolling_section(const Case& c, const Document& document, const Refusal& refuse_key) {
    const std::string rule =
        "presses bodies where they are, but for a cylinder on a hub: takes no ";
    if (c.rolling)
        refuse_key(used(document, "rolling.amplitude_ratio", "rolling.amplitude"),
                   rule + "[rolling]", "leave that section out, or take bem or fem");
    if (c.tractive_rolling)
        refuse_key("tractive_rolling.distance", rule + "[tractive_rolling]",
                   "leave that section out, or take bem");
    if (c.prescribed_path && !c.adhesion)
        refuse_key(path_key(document), rule + "path", "leave it out, or take bem or fem");
}

// In a hole the pin is pressed along z: friction acts along the arc, and what pulls the pin aside
// turns the contact about the hole, which is pressed along another direction then.
void check_friction_in_hole(const Case& c, const Document& document, const Refusal& refuse_key) {
    if (!c.contact.coupling) return;
    if (!c.friction.is_coulomb() || c.friction.map)
        refuse_key("contact.coupling",
                   "knows Coulomb's friction alone in a hole, the same all over",
                   "set it to false, or give friction.coefficient alone");
    if (c.interface.is_elastic())
        refuse_key("contact.coupling", "has no springs between surfaces with friction in a hole",
                   "set it to false, or omit [interface]");
    if (!c.prescribed_path) return;
    const contact::Vector2 reach = c.prescribed_path->reach();
    const bool pulled = std::ranges::any_of(c.prescribed_path->rows, [](const auto& row) {
        return row.tangential[0].value != 0 || row.tangential[1].value != 0;
    });
    if (reach[0] > 0 || reach[1] > 0 || pulled || c.prescribed_path->twists())
        refuse_key(path_key(document), "presses a pin in its hole along one direction",
                   "leave offsets, shifts, rotations and loads along the surface out");
}

void check_plane_strain(const ModelKind& kind, const Case& c, const Document& document,
                        const Refusal& refuse_key) {
    if (c.indenter.is_punch() && !c.is_line_contact())
        refuse_key("indenter.shape", "takes a punch along y, in plane strain",
                   "give its indenter.length, or take fem-axisymmetric");
    if (!c.is_line_contact())
        refuse_key("indenter.shape", "is about cylinders, in plane strain",
                   "take shape = \"cylinder\", or fem-axisymmetric");
    if (c.layer.base == Case::Base::frictionless)
        refuse_key("substrate.base", "has nothing that holds a layer which glides",
                   "take base = \"bonded\"");
    if (c.has_hole()) {
        check_friction_in_hole(c, document, refuse_key);
        return;
    }
    if (!c.indenter.body) return;
    if (is_cylinder_on_hub(*c.indenter.body))
        check_rolling_on_hub(kind.name, c, document);
    else
        check_rolling_section(c, document, refuse_key);
    if (c.load.is_tangential() && c.indenter.body->support == ElasticBody::Support::plates)
        refuse_key(tangential_key(c), "has no force along plates that press from both sides",
                   "set it to 0, or take indenter.support = \"hub\"");
}

void check_of_revolution(const Case& c, const Document& document, const Refusal& refuse_key) {
    if (c.indenter.is_long_punch())
        refuse_key("indenter.length", "takes a punch of revolution", "omit it, or take fem-plane");
    if (!contact::body_shape(c.indenter.shape).of_revolution)
        refuse_key("indenter.shape", "is about bodies of revolution",
                   c.is_line_contact() ? "take fem-plane" : "take bem or fem");
    if (c.friction.map)
        refuse_key("friction.map", "has the same friction all around its axis", "leave it out");
    if (c.adhesion && (c.indenter.body || c.has_rigid_substrate))
        refuse_key("adhesion.work", "computes attraction between a rigid indenter and a layer",
                   "leave out indenter.body or [adhesion]");
    if (c.adhesion && !c.friction.is_coulomb())
        refuse_key("adhesion.work", "has Coulomb's friction alone beside attraction",
                   "give friction.coefficient alone, or leave out [adhesion]");
    check_rolling_section(c, document, refuse_key);
    if (c.load.is_tangential())
        refuse_key(tangential_key(c), "presses along the axis alone", "set it to 0, or take fem");
}

}  // namespace

void check_section(const ModelKind& kind, const Case& c, const Document& document) {
    const Refusal refuse_key(kind, document);
    check_section_substrate(c, refuse_key);
    check_section_indenter(c, refuse_key);
    check_section_elements(c, document, refuse_key);
    if (kind.cut == ModelKind::Cut::plane_strain)
        check_plane_strain(kind, c, document, refuse_key);
    else
        check_of_revolution(c, document, refuse_key);
}

}  // namespace tricontact::io
