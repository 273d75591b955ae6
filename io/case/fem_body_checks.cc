#include "contact/bodies/body_forms.h"
#include "contact/load_path.h"
#include "fem/settings.h"
#include "io/case/case_checks.h"
#include "io/results/output.h"

// What fem computes of an indenter that deforms: a cylinder rolls about its hub; other bodies are
// pressed and loaded where they stand, since what touches after they have turned is no longer the
// same. A body between plates is held by their symmetry alone: whatever is not mirrored in the
// plane between them, or would make it roll, has no answer.

namespace tricontact::io {

namespace {

using contact::Case;
using contact::ElasticBody;

constexpr double farthest_turn = 2;  // way over radius

/// Why a body does not roll.
std::string why_it_stands(const ElasticBody& body) {
    const std::string held = "a " + std::string(contact::body_form(body.form).title) + " held by " +
                             contact::title_of(body.support);
    if (body.support == ElasticBody::Support::plates)
        return held + " stands by symmetry alone, which rolling breaks";
    return held +
           " has another stiffness after it has turned: it is not of revolution about the "
           "axis that it rolls about";
}

void check_motion(const Case& c, const Document& document) {
    const ElasticBody& body = *c.indenter.body;
    const char* const remedy = "leave out fem, or indenter.body";
    if (c.tractive_rolling)
        refuse(document, "tractive_rolling.distance",
               "fem does not roll the body of an indenter on", remedy);
    if (body.support == ElasticBody::Support::hub) {
        check_turn_of_hub(contact::models::fem, c, document);
        return;
    }
    if (c.rolling)
        refuse(document, used(document, "rolling.amplitude_ratio", "rolling.amplitude"),
               "fem rolls a cylinder on a hub; " + why_it_stands(body), remedy);
    if (!c.prescribed_path) return;
    const contact::Vector2 reach = c.prescribed_path->reach();
    if (reach[0] > 0 || reach[1] > 0)
        refuse(document, path_key(document),
               "fem moves a cylinder on a hub by rolling; " + why_it_stands(body),
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

void check_turn_of_hub(const std::string& model, const Case& c, const Document& document) {
    const double a = contact::half_space_scales(c).contact_radius;
    if (contact::path_reach(c, a)[0] <= farthest_turn * c.indenter.radius) return;
    refuse(document,
           c.rolling ? used(document, "rolling.amplitude_ratio", "rolling.amplitude")
                     : path_key(document),
           model + " turns a cylinder about its hub by no more than 115 degrees to either side",
           "reduce it to two radii, or leave indenter.body out");
}

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
    if (c.of<fem::Settings>().mesh)
        refuse(document, "fem.mesh",
               "the nodes of a mesh file do not match those of the indenter's body",
               "omit it, or leave out indenter.body");
    if (c.has_rigid_substrate && c.of<Output>().volume != Output::Volume::none)
        refuse(document, "output.volume", "the interior is that of the substrate, which is rigid",
               "leave output.volume out");
    check_motion(c, document);
    check_plates(c, document);
}

}  // namespace tricontact::io
