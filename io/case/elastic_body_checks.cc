#include "contact/bodies/body_forms.h"
#include "contact/bodies/body_shapes.h"
#include "contact/bodies/upper_plate.h"
#include "io/case/case_checks.h"
#include "io/results/output.h"

namespace tricontact::io {

namespace {

using contact::BodyForm;
using contact::Case;
using contact::ElasticBody;
using contact::UpperPlate;

template <class Words>
std::string any_of(const Words& words) {
    std::string out;
    for (const auto word : words) out += (out.empty() ? "\"" : " or \"") + std::string(word) + '"';
    return out;
}

void check_form(const Case& c, const Document& document) {
    const ElasticBody& body = *c.indenter.body;
    const BodyForm& form = contact::body_form(body.form);
    const std::string word = body.form == ElasticBody::Form::mesh
                                 ? "a body in a file "
                                 : "the body \"" + std::string(form.word) + "\" ";
    if (!std::ranges::count(form.shapes, c.indenter.shape)) {
        std::vector<std::string_view> shapes;
        for (const auto shape : form.shapes) shapes.push_back(contact::body_shape(shape).word);
        refuse(document, body.key(),
               word + "has no surface of the shape \"" +
                   std::string(contact::body_shape(c.indenter.shape).word) + '"',
               "take indenter.shape = " + any_of(shapes) + ", or another body");
    }
    if (!std::ranges::count(form.supports, body.support)) {
        std::vector<std::string_view> supports;
        for (const auto support : form.supports) supports.push_back(contact::word_of(support));
        refuse(document, "indenter.support",
               word + "is not held by \"" + std::string(contact::word_of(body.support)) + '"',
               "take " + any_of(supports));
    }
    const bool has_hub = body.support == ElasticBody::Support::hub;
    if (!has_hub && document.find("indenter.hub_radius"))
        refuse(document, "indenter.hub_radius", "the body is not held by a hub",
               "omit it, or take indenter.support = \"hub\"");
    if (has_hub && body.hub_radius >= c.indenter.radius)
        refuse(document, "indenter.hub_radius",
               "is not smaller than the radius of " + rounded(c.indenter.radius) + " m",
               "reduce it");
    if (!form.has_height && document.find("indenter.height"))
        refuse(document, "indenter.height", word + "has the height that its radius says",
               "omit it");
}

void check_rigid_substrate(const Case& c, const Document& document) {
    for (const char* key : {"substrate.young", "substrate.poisson", "substrate.material",
                            "substrate.thickness", "substrate.thickness_ratio"})
        if (document.find(key))
            refuse(document, key, "a rigid substrate has neither material nor thickness",
                   "omit it, or omit substrate.rigid");
    if (c.indenter.shape == Case::Shape::roller)
        refuse(document, "substrate.rigid",
               "the ends of a roller on a rigid plane are not modelled",
               "take a cylinder, or a substrate that deforms");
    for (const std::string& model : c.models)
        if (!contact::model_kind(model).sees_rigid_substrate)
            refuse(document, "models", model + " models a substrate that deforms",
                   "leave it out, or omit substrate.rigid");
}

void check_plate_alone(const UpperPlate& plate, const Document& document) {
    for (const char* key : {"upper_plate.young", "upper_plate.poisson", "upper_plate.thickness"})
        if (plate.is_rigid && document.find(key))
            refuse(document, key, "a rigid plate has neither material nor thickness",
                   "omit it, or omit upper_plate.rigid");
}

/// The key that [upper_plate] begins with.
std::string first_key(const Document& document) {
    return used(document, "upper_plate.rigid", "upper_plate.young");
}

void check_upper_plate(const Case& c, const Document& document) {
    const UpperPlate* const plate = c.kept.find<UpperPlate>();
    if (!plate) return;
    const std::string key = first_key(document);
    check_plate_alone(*plate, document);
    if (!c.indenter.body || c.indenter.body->support != ElasticBody::Support::plates)
        refuse(document, key, "no body of the case lies between two plates",
               "omit [upper_plate], or take indenter.support = \"plates\"");
    if (c.contact.coupling)
        refuse(document, "contact.coupling",
               "between unlike plates bodies are pressed without friction: what slips at one "
               "plate would move the surface at the other",
               "omit it, or omit [upper_plate]");
    for (const std::string& model : c.models)
        if (const auto& kind = contact::model_kind(model); kind.is_meshed() && !kind.is_section())
            refuse(document, "models", model + " presses a body between plates that are alike",
                   "take fem-axisymmetric or fem-plane, or omit [upper_plate]");
    if (c.relaxation)
        refuse(document, key, "unlike plates are elastic",
               "omit [substrate.relaxation] or [upper_plate]");
    if (c.interface.is_elastic())
        refuse(document, key, "unlike plates have no springs of an interface",
               "omit [interface] or [upper_plate]");
    if (document.find_section("wear"))
        refuse(document, key, "surfaces between unlike plates do not wear",
               "omit [wear] or [upper_plate]");
    if (c.of<Output>().volume != Output::Volume::none)
        refuse(document, "output.volume", "the inside of a body between unlike plates is not shown",
               "omit it, or omit [upper_plate]");
    for (const char* section : {"record", "measurement", "design"})
        if (document.find_section(section))
            refuse(document, key, "experiments are about bodies on one substrate",
                   "omit [upper_plate], or leave out the sections of experiments");
}

}  // namespace

void make_upper_plate(Case& c, const Document& document) {
    if (!document.find_section("upper_plate")) return;
    c.of<UpperPlate>().is_rigid = document.find("upper_plate.rigid");  // until it is read
}

void check_bodies(const Case& c, const Document& document) {
    check_hole(c, document);
    check_punch(c, document);
    if (c.indenter.body) check_form(c, document);
    check_upper_plate(c, document);
    if (c.has_rigid_substrate) check_rigid_substrate(c, document);
}

namespace {

/// What the closed forms of the stresses inside do not know; empty: nothing of the case.
std::string unknown_part(const Case& c) {
    const bool is_hertz = contact::is_hertz_round(c) || c.indenter.shape == Case::Shape::cylinder;
    if (!is_hertz || c.indenter.roughness) return "other bodies than smooth spheres and cylinders";
    if (c.has_hole()) return "holes";
    if (!c.friction.is_coulomb()) return "other laws of friction than Coulomb's";
    if (c.interface.is_elastic()) return "springs of the interface";
    if (c.relaxation) return "a substrate that relaxes";
    if (c.law != Case::Law::linear) return "finite strains";
    if (c.has_rigid_substrate) return "a rigid substrate";
    if (c.indenter.body) return "a finite body of the indenter";
    if (c.tractive_rolling) return "contacts that roll on";
    return {};
}

}  // namespace

void check_yield_stress(const Case& c, const Document& document) {
    if (!c.yield_stress.any()) return;
    const std::string key =
        c.yield_stress.substrate ? "substrate.yield_stress" : "indenter.yield_stress";
    if (const std::string part = unknown_part(c); !part.empty())
        refuse(document, key, "strength is judged by closed forms that do not know " + part,
               "omit it");
    for (const std::string& model : c.models)
        if (!contact::model_kind(model).is_half_space())
            refuse(document, key,
                   "strength is judged by closed forms of the half-space, and " + model +
                       " is of a layer",
                   "omit it, or take bem or mdr");
}

}  // namespace tricontact::io
