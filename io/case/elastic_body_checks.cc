#include "contact/bodies/body_forms.h"
#include "contact/bodies/body_shapes.h"
#include "io/case/case_checks.h"

namespace tricontact::io {

namespace {

using contact::BodyForm;
using contact::Case;
using contact::ElasticBody;

template <class Words>
std::string any_of(const Words& words) {
    std::string out;
    for (const auto word : words) out += (out.empty() ? "\"" : " or \"") + std::string(word) + '"';
    return out;
}

void check_form(const Case& c, const Document& document) {
    const ElasticBody& body = *c.indenter.body;
    const BodyForm& form = contact::body_form(body.form);
    const bool in_file = body.form == ElasticBody::Form::mesh;
    const std::string word =
        in_file ? "a body in a file " : "the body \"" + std::string(form.word) + "\" ";
    if (!std::ranges::count(form.shapes, c.indenter.shape)) {
        std::vector<std::string_view> shapes;
        for (const auto shape : form.shapes) shapes.push_back(contact::body_shape(shape).word);
        refuse(document, body.key(),
               word + "has no surface of the shape \"" +
                   std::string(contact::body_shape(c.indenter.shape).word) + '"',
               "take indenter.shape = " + any_of(shapes) + ", or another body");
    }
    if (in_file && document.find("indenter.support"))
        refuse(document, "indenter.support",
               "the file's surface \"support\" is what holds the body", "omit it");
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
        refuse(
            document, "indenter.height",
            word + (in_file ? "has the height of its mesh" : "has the height that its radius says"),
            "omit it");
}

void check_rigid_substrate(const Case& c, const Document& document) {
    for (const char* key : {"substrate.young", "substrate.poisson", "substrate.material",
                            "substrate.thickness", "substrate.thickness_ratio"})
        if (document.find(key))
            refuse(document, key, "a rigid substrate has neither material nor thickness",
                   "omit it, or omit substrate.rigid");
    if (document.find_section("substrate.relaxation"))
        refuse(document, "substrate.rigid", "a rigid substrate does not relax",
               "omit it, or omit [substrate.relaxation]");
    if (c.indenter.shape == Case::Shape::roller)
        refuse(document, "substrate.rigid",
               "the ends of a roller on a rigid plane are not modelled",
               "take a cylinder, or a substrate that deforms");
    for (const std::string& model : c.models)
        if (!contact::model_kind(model).sees_rigid_substrate)
            refuse(document, "models", model + " models a substrate that deforms",
                   "leave it out, or omit substrate.rigid");
}

}  // namespace

void check_bodies(const Case& c, const Document& document) {
    check_hole(c, document);
    check_punch(c, document);
    if (c.indenter.body) check_form(c, document);
    if (c.has_rigid_substrate) check_rigid_substrate(c, document);
}

}  // namespace tricontact::io
