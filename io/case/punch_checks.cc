#include "contact/bodies/body_forms.h"
#include "io/case/case_checks.h"

namespace tricontact::io {

namespace {

using contact::Case;
using contact::ElasticBody;
using Cut = contact::ModelKind::Cut;

constexpr double shortest_punch = 5;  // lengths of a punch along y over its flat width

void check_punch_models(const Case& c, const Document& document) {
    const bool is_long = c.indenter.is_long_punch();
    for (const std::string& model : c.models) {
        const contact::ModelKind& kind = contact::model_kind(model);
        const Cut cut = kind.cut;
        const bool is_solid = kind.is_meshed() && !kind.is_section();
        const bool is_block = c.indenter.shape == Case::Shape::flat_punch && c.indenter.body;
        if (is_long && is_solid && is_block) continue;
        if (is_long && is_solid)
            refuse(document, "models",
                   model + " knows a punch along y as a body with sharp edges alone",
                   "give shape = \"flat-punch\" and indenter.body = \"block\", or take fem-plane");
        if (is_long && cut != Cut::plane_strain)
            refuse(document, "models", model + " knows no punch along y",
                   "take fem-plane, or omit indenter.length: it is of revolution then");
        if (!is_long && cut != Cut::of_revolution)
            refuse(document, "models", model + " knows no punch of revolution with a sharp edge",
                   "take fem-axisymmetric, or fem-plane with indenter.length");
    }
    if (is_long && c.indenter.length < 2 * shortest_punch * c.indenter.flat_radius)
        refuse(document, "indenter.length",
               "is less than " + rounded(shortest_punch) +
                   " widths of the punch's flat face: no "
                   "line contact",
               "enlarge it");
}

void check_punch_motion(const Case& c, const Document& document) {
    const std::string rule = "a flat punch does not roll";
    if (c.rolling)
        refuse(document, used(document, "rolling.amplitude_ratio", "rolling.amplitude"), rule,
               "leave [rolling] out");
    if (c.tractive_rolling)
        refuse(document, "tractive_rolling.distance", rule, "leave [tractive_rolling] out");
    if (says_path(document))
        refuse(document, path_key(document), "flat punches are pressed and pulled, without a path",
               "leave the path out");
}

/// What holds a loose body is the contact, by its pressures alone.
void check_loose_body(const Case& c, const Document& document) {
    const ElasticBody& body = *c.indenter.body;
    if (c.load.is_tangential())
        refuse(document, tangential_key(c),
               "nothing holds a body that " + std::string(contact::word_of(body.support)) +
                   " presses against a load along the surface",
               "set load.tangential_ratio = 0, or take indenter.support = \"holder\"");
    if (body.support == ElasticBody::Support::force && c.load.indentation)
        refuse(document, "load.indentation",
               "where a force is concentrated the body gives way without bound: there is no depth",
               "give load.normal_force, or take indenter.support = \"pressure\"");
}

}  // namespace

void check_punch(const Case& c, const Document& document) {
    if (c.indenter.shape == Case::Shape::flat_punch || c.indenter.is_long_punch()) {
        check_punch_models(c, document);
        check_punch_motion(c, document);
    }
    if (c.indenter.body && c.indenter.body->is_loose()) check_loose_body(c, document);
}

}  // namespace tricontact::io
