#include "contact/bodies/body_forms.h"
#include "contact/load_path.h"
#include "fem/settings.h"
#include "io/case/case_checks.h"
#include "io/results/output.h"

// What fem computes of an indenter that deforms: a cylinder rolls about its hub; other bodies are
// pressed and loaded where they stand, since what touches after they have turned is no longer the
// same. A body between plates is held by their symmetry alone, one that a pressure presses by that
// about its axis: whatever breaks it, or would make it roll, has no answer.

namespace tricontact::io {

namespace {

using contact::Case;
using contact::ElasticBody;

constexpr double farthest_turn = 2;           // way over radius
constexpr double farthest_turn_of_ball = .4;  // within a disc about its pole

/// Why a body does not roll.
std::string why_it_stands(const ElasticBody& body) {
    if (body.form == ElasticBody::Form::mesh)
        return "whether a body of a file is one of revolution about the axis that it would roll "
               "about "
               "is not known";
    const std::string held = "a " + std::string(contact::body_form(body.form).title) + " held by " +
                             contact::title_of(body.support);
    if (body.support == ElasticBody::Support::plates || body.is_loose())
        return held + " stands by symmetry alone, which rolling breaks";
    return held +
           " has another stiffness after it has turned: it is not of revolution about the "
           "axis that it rolls about";
}

void check_motion(const Case& c, const Document& document) {
    const ElasticBody& body = *c.indenter.body;
    const std::string remedy = std::string("leave out fem, or ") + body.key();
    if (c.tractive_rolling) {
        if (!is_round_on_hub(body))
            refuse(document, "tractive_rolling.distance",
                   "fem rolls a cylinder or ball on a hub on; " + why_it_stands(body), remedy);
        return;
    }
    if (is_round_on_hub(body)) {
        check_rolling_on_hub(contact::models::fem, c, document);
        return;
    }
    if (c.rolling)
        refuse(document, used(document, "rolling.amplitude_ratio", "rolling.amplitude"),
               "fem rolls a cylinder or ball on a hub; " + why_it_stands(body), remedy);
    if (!c.prescribed_path) return;
    const contact::Vector2 reach = c.prescribed_path->reach();
    if (reach[0] > 0 || reach[1] > 0)
        refuse(document, path_key(document),
               "fem moves a cylinder or ball on a hub by rolling; " + why_it_stands(body),
               "leave its offsets out, or " + remedy);
}

void check_held_by_symmetry(const Case& c, const Document& document) {
    const ElasticBody& body = *c.indenter.body;
    if (body.support != ElasticBody::Support::plates && !body.is_loose()) return;
    const std::string held = body.is_loose() ? "that a pressure presses" : "between two plates";
    if (c.friction.map && c.friction.map->varies_along_y())
        refuse(document, "friction.map",
               "a body " + held + " stands by symmetry in both planes of its axis",
               "omit it, or take another support");
    const bool moved =
        c.prescribed_path && (c.prescribed_path->twists() || !contact::is_mirror_symmetric(c));
    const bool pulled =
        c.prescribed_path && std::ranges::any_of(c.prescribed_path->rows, [](const auto& row) {
            return row.tangential[0].value != 0 || row.tangential[1].value != 0;
        });
    if (c.load.is_tangential() || moved || pulled)
        refuse(document, c.prescribed_path ? path_key(document) : tangential_key(c),
               "a body " + held + " rolls or spins under a tangential load: nothing holds it",
               "set the tangential load to 0, or take another support");
}

// Bodies of files: the mesh says how fine, and its groups what holds it.
void check_meshes(const Case& c, const Document& document) {
    check_file_there(document, "indenter.mesh", *c.indenter.body->mesh, "name a gmsh file");
    if (document.find("fem.accuracy"))
        refuse(document, "fem.accuracy", "the size of elements is that of the indenter's mesh",
               "omit it, or give fem.size for the layer below");
    if (c.has_rigid_substrate && c.of<fem::Settings>().size)
        refuse(document, "fem.size", "the only mesh is the indenter's, which is a file's",
               "omit it");
    if (c.indenter.roughness)
        refuse(document, "indenter.roughness.hurst", "the surface is that of the mesh",
               "omit [indenter.roughness], or leave out fem");
    if (!c.of<fem::Settings>().mesh) return;
    if (c.has_rigid_substrate)
        refuse(document, "fem.mesh", "a rigid substrate has no mesh", "omit it");
    if (c.layer.base != Case::Base::bonded)
        refuse(document, "substrate.base", "a body of a file is bonded to its surface \"support\"",
               "omit it");
    if (c.of<fem::Settings>().sides == fem::Sides::fixed)
        refuse(document, "fem.sides", "a body of a file is held by its surface \"support\"",
               "omit it");
    if (!c.layer.lower.empty())
        refuse(document, "lower_layer.thickness",
               "a body of a file under another is of one material",
               "omit [lower_layer], or fem.mesh");
}

}  // namespace

void check_rolling_on_hub(const std::string& model, const Case& c, const Document& document) {
    const contact::Vector2 way =
        contact::path_reach(c, contact::half_space_scales(c).contact_radius);
    const double reach = way[0];
    const bool is_ball = c.indenter.body->form == ElasticBody::Form::ball;
    const auto key = [&] {
        return c.rolling ? used(document, "rolling.amplitude_ratio", "rolling.amplitude")
                         : path_key(document);
    };
    if (is_ball && way[1] > 0)
        refuse(document, c.rolling ? "rolling.angle" : key(),
               model + " turns a ball on a hub about the axis along y: it rolls along x",
               "turn the load instead, or leave indenter.body out");
    if (is_ball && reach > farthest_turn_of_ball * c.indenter.radius)
        refuse(document, key(),
               model + " turns a ball about its hub by no more than 23 degrees to either side",
               "reduce it to 0.4 radii, or leave indenter.body out");
    if (reach > farthest_turn * c.indenter.radius)
        refuse(document, key(),
               model + " turns a cylinder about its hub by no more than 115 degrees to either side",
               "reduce it to two radii, or leave indenter.body out");
    // The inside of the body is that of the upright one.
    const Output::Volume volume = c.of<Output>().volume;
    if (!(reach > 0) || volume == Output::Volume::none) return;
    if (c.prescribed_path || volume == Output::Volume::quarters)
        refuse(document, "output.volume",
               model +
                   " shows the inside of a body that rolls where it stands upright, after a "
                   "period of [rolling]",
               c.prescribed_path ? "omit it" : "take volume = \"last\"");
}

void check_fem_body(const Case& c, const Document& document) {
    const auto refuse_body = [&](const std::string& why, const std::string& remedy) {
        refuse(document, c.indenter.body->key(), why, remedy);
    };
    if (c.law != Case::Law::linear)
        refuse_body("at finite strains fem takes the indenter as rigid",
                    "leave it out, or set substrate.material to \"linear\"");
    const bool in_file = c.indenter.body->form == ElasticBody::Form::mesh;
    if (in_file) check_meshes(c, document);
    if (c.of<fem::Settings>().mesh && !in_file)
        refuse(document, "fem.mesh",
               "the nodes of a mesh file do not match those of the indenter's body",
               "omit it, or give the indenter's mesh as indenter.mesh");
    if (c.indenter.body->support == ElasticBody::Support::force)
        refuse(document, "indenter.support", "fem presses a block by a holder or by a pressure",
               "take one of these, or fem-plane for a concentrated force");
    check_motion(c, document);
    check_held_by_symmetry(c, document);
}

}  // namespace tricontact::io
