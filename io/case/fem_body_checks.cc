#include "contact/bodies/body_forms.h"
#include "contact/load_path.h"
#include "fem/settings.h"
#include "io/case/case_checks.h"
#include "io/results/output.h"

// What fem computes of an indenter that deforms: it is pressed and loaded where it stands. A body
// between plates is held by their symmetry alone: whatever is not mirrored in the plane between
// them, or would make it roll, has no answer.

namespace tricontact::io {

namespace {

using contact::Case;
using contact::ElasticBody;

void check_motion(const Case& c, const Document& document) {
    const auto& body = contact::body_form(c.indenter.body->form);
    const std::string held =
        "a " + std::string(body.title) + " held by " + contact::title_of(c.indenter.body->support);
    const char* const remedy = "leave out fem, or indenter.body";
    if (c.rolling)
        refuse(document, used(document, "rolling.amplitude_ratio", "rolling.amplitude"),
               "fem presses and loads the body of an indenter where it stands; " + held +
                   " that rolls is not computed",
               remedy);
    if (c.tractive_rolling)
        refuse(document, "tractive_rolling.distance",
               "fem does not roll the body of an indenter on", remedy);
    if (!c.prescribed_path) return;
    const contact::Vector2 reach = c.prescribed_path->reach();
    if (reach[0] > 0 || reach[1] > 0)
        refuse(document, path_key(document),
               "fem presses and loads the body of an indenter where it stands; " + held +
                   " that is moved by rolling is not computed",
               "leave its offsets out, or " + std::string(remedy));
}

void check_plates(const Case& c, const Document& document) {
    if (c.indenter.body->support != ElasticBody::Support::plates) return;
    const bool moved =
        c.prescribed_path && (c.prescribed_path->twists() || !contact::is_mirror_symmetric(c));
    const bool pulled =
        c.prescribed_path && std::ranges::any_of(c.prescribed_path->rows, [](const auto& row) {
            return row.tangential[0].value != 0 || row.tangential[1].value != 0;
        });
    if (has_tangential_load(c) || moved || pulled)
        refuse(document, c.prescribed_path ? path_key(document) : tangential_key(c),
               "a body between two plates rolls or spins under a tangential load: nothing holds it",
               "set the tangential load to 0, or take another support");
}

}  // namespace

void check_fem_body(const Case& c, const Document& document) {
    const auto refuse_body = [&](const std::string& why, const std::string& remedy) {
        refuse(document, "indenter.body", why, remedy);
    };
    if (c.indenter.body->form == ElasticBody::Form::punch)
        refuse_body("fem meshes hemispheres, balls and cylinders, no punch",
                    "take one of these, or leave out fem");
    if (c.law != Case::Law::linear)
        refuse_body("at finite strains fem takes the indenter as rigid",
                    "leave it out, or set substrate.material to \"linear\"");
    if (c.relaxation)
        refuse_body("fem takes the indenter of a relaxing substrate as rigid",
                    "leave it out, or omit [substrate.relaxation]");
    if (c.of<fem::Settings>().mesh)
        refuse(document, "fem.mesh",
               "the nodes of a mesh file do not match those of the indenter's body",
               "omit it, or leave out indenter.body");
    check_motion(c, document);
    check_plates(c, document);
}

}  // namespace tricontact::io
