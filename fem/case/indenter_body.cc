#include "fem/case/indenter_body.h"

#include "contact/base/error.h"
#include "contact/load_path.h"
#include "fem/settings.h"
#include "meshes/layer_mesh.h"
#include "meshes/layered_body_mesh.h"
#include "meshes/round_body_mesh.h"

// What holds a body is its base (meshes/round_body_mesh.h): a holder and a hub are bonded to it. Of
// a body between plates the base is the plane of symmetry between them, which takes no shear: what
// slides along it is held by that symmetry, since no force may pull it. What a pressure presses on
// its base has no other hold than the contact.

namespace tricontact::fem {

using contact::Case;
using contact::ElasticBody;

namespace {

meshes::HexMesh mesh_of(const Case& c, const meshes::LayerMeshSpec& patch) {
    const ElasticBody& body = *c.indenter.body;
    switch (body.form) {
        case ElasticBody::Form::hemisphere:
        case ElasticBody::Form::ball:
            if (body.support == ElasticBody::Support::hub)
                return meshes::make_hub_ball_mesh({.radius = c.indenter.radius,
                                                   .hub_radius = body.hub_radius,
                                                   .size = patch.size,
                                                   .patch_x = patch.patch_x,
                                                   .patch_y = patch.patch_y,
                                                   .growth = patch.growth,
                                                   .half_model = patch.half_model,
                                                   .rolls = rolls_on_its_hub(c)});
            return meshes::make_half_ball_mesh({.radius = c.indenter.radius,
                                                .size = patch.size,
                                                .patch_x = patch.patch_x,
                                                .patch_y = patch.patch_y,
                                                .growth = patch.growth,
                                                .half_model = patch.half_model});
        case ElasticBody::Form::cylinder:
            return meshes::make_cylinder_mesh({.radius = c.indenter.radius,
                                               .size = patch.size,
                                               .patch_x = patch.patch_x,
                                               .half_y = patch.half_y,
                                               .growth = patch.growth,
                                               .hub_radius = body.hub_radius,
                                               .rolls = rolls_on_its_hub(c)});
        case ElasticBody::Form::punch:
            return meshes::make_punch_mesh(
                {.radius = c.indenter.flat_radius + c.indenter.radius,
                 .height = body.height,
                 .size = patch.size,
                 .patch_x = patch.patch_x,
                 .patch_y = patch.patch_y,
                 .growth = patch.growth,
                 .half_model = patch.half_model,
                 .profile = [shape = std::shared_ptr(c.make_indenter())](double r) {
                     return shape->height(r, 0);
                 }});
        case ElasticBody::Form::block: {
            meshes::LayerMeshSpec block = patch;
            block.half_x = patch.patch_x;
            block.thickness = body.height;
            block.lower_thickness = 0;
            return meshes::make_layer_mesh(block);
        }
        default:  // of files: meshed_bodies.h
            break;
    }
    throw contact::InputError(
        "indenter.body: fem meshes hemispheres, balls, cylinders, punches and blocks; choose one "
        "of these or leave out fem");
}

}  // namespace

bool is_block(const Case& c) {
    return c.indenter.body && c.indenter.body->form == ElasticBody::Form::block;
}

bool rolls_on_its_hub(const Case& c) {
    const auto& body = c.indenter.body;
    if (!body || body->support != ElasticBody::Support::hub) return false;
    const bool moves = contact::path_reach(c, c.indenter.radius)[0] > 0;
    if (body->form == ElasticBody::Form::ball) return moves;
    return body->form == ElasticBody::Form::cylinder && (moves || c.tractive_rolling);
}

LayerProblem indenter_problem(const Case& c, const meshes::LayerMeshSpec& patch) {
    LayerProblem problem;
    problem.mesh = mesh_of(c, patch);
    problem.materials = {*c.indenter.material, *c.indenter.material};
    if (c.indenter.body->support == ElasticBody::Support::plates) {
        problem.base = Case::Base::frictionless;
        problem.held_by_symmetry = true;
    }
    problem.pressed_evenly = c.indenter.body->support == ElasticBody::Support::pressure;
    if (c.is_line_contact()) problem.line_length = c.indenter.length;
    return problem;
}

}  // namespace tricontact::fem
