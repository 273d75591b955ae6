#include "fem/case/model.h"

#include <fmt/format.h>

#include <algorithm>

#include "contact/base/error.h"
#include "contact/models/model_kind.h"
#include "contact/relaxing_case.h"
#include "contact/surface_model.h"
#include "fem/case/indenter_body.h"
#include "fem/case/iterative_model.h"
#include "fem/case/layer_condenser.h"
#include "fem/case/mesh_choice.h"
#include "fem/case/meshed_bodies.h"
#include "fem/finite_strain/strained_model.h"
#include "fem/mortar/mean_heights.h"
#include "fem/settings.h"
#include "meshes/mesh_file.h"

// From a case to a model of docs/explanation/models/fem.md:
//
//   radius of the contact (probed)  --> size of elements --> patch = contact + path + margin
//       --> mesh --> condensed layer --> Substrate --> SurfaceModel     linear
//                                    \-> StrainedModel                  finite strains
//
// At finite strains the contact moves with the shift, which the plan expects to first order only: a
// run that reaches the edge of its patch begins anew on one larger by `patch_growth`. A mesh of the
// user's is taken as it is.

namespace tricontact::fem {

using contact::Case;

namespace {

/// The surface moves under the indenter by friction.
constexpr double patch_margin = 1.03;
/// Of the room in the patch when the contact has reached its edge.
constexpr double patch_growth = 1.3;

void require_layer(const Case& c) {
    const bool in_file = c.indenter.body && c.indenter.body->mesh;
    if (c.indenter.body && c.of<Settings>().mesh && !in_file)
        throw contact::InputError(
            "fem.mesh: the nodes of a mesh file do not match those of the indenter's body; leave "
            "out fem.mesh or indenter.body");
    if (c.has_rigid_substrate) return;
    if (!c.layer.thickness && !c.of<Settings>().mesh)
        throw contact::InputError(
            "fem: the finite element layer needs substrate.thickness (or a fem.mesh)");
    if (c.layer.base == Case::Base::half_space || c.layer.lower.size() > 1)
        throw contact::InputError(
            "fem: at most two layers on a rigid ground are meshed; take bem-layer for more, or for "
            "an elastic ground");
}

void say_what_was_chosen(const Case& c, const meshes::LayerMeshSpec& spec,
                         const LayerCondenser& condenser) {
    if (c.has_rigid_substrate) return;
    const double total = spec.thickness + spec.lower_thickness;
    if (!c.layer.width || !c.layer.depth)
        condenser.say(fmt::format("block of {:.4g} mm x {:.4g} mm where the case gives no size",
                                  2e3 * spec.half_x, 2e3 * spec.half_y));
    const double least =
        c.is_cylindrical() || is_block(c) ? spec.half_x : std::min(spec.half_x, spec.half_y);
    if (least < far_sides(c) * total * (1 - 1e-9))
        condenser.say(fmt::format(
            "the sides are {:.3g} layer thicknesses away, less than {:.3g}: they will be felt",
            least / total, far_sides(c)));
    if (c.layer.base == Case::Base::frictionless && c.of<Settings>().sides == Sides::free)
        condenser.say("on a frictionless base the sides are held, or the layer would slide away");
}

void require_room(const char* side, double half, double patch, double size) {
    if (half < patch + size)
        throw contact::InputError(fmt::format(
            "substrate.{}: the contact patch with its path is {:.4g} m wide and must leave an "
            "element on either side of the block's {:.4g} m; enlarge it or reduce the load",
            side, 2 * patch, 2 * half));
}

/// What a mesh has to have room for [m].
struct Plan {
    double size, contact_radius, shift;
};

meshes::LayerMeshSpec spec_of(const Case& c, const Plan& plan) {
    const auto spec = spec_for(c, plan.size, plan.contact_radius, plan.shift);
    if (c.has_rigid_substrate) return spec;
    require_room("width", spec.half_x, spec.patch_x, spec.size);
    if (!c.is_cylindrical() && !is_block(c))
        require_room("depth", spec.half_y, spec.patch_y, spec.size);
    return spec;
}

/// At finite strains the contact goes where friction and F_T shift the indenter: about 1 to 2 mu
/// f_T d, and d is half of a^2/R on thin layers, nearly all of it on thick ones. Where that is too
/// little, the run begins anew on a larger patch.
double shift_to_expect(const Case& c, double contact_radius) {
    const Case::Load& load = c.load;
    const bool loaded = load.tangential_ratio || load.tangential_force || load.is_by_limit();
    if (c.law == Case::Law::linear || !loaded) return 0;
    // The limit of which a fraction is given is at most 1.
    const double by_limit = load.is_by_limit() ? load.ratio_by_limit(1) : 1;
    const double f = std::min(1., std::abs(load.tangential_ratio.value_or(by_limit)));
    return contact::expected_friction(c) * f * contact_radius * contact_radius / c.indenter.radius;
}

// The hardest press (crest factor of an oscillating F_N) decides the radius; the path and the shift
// add to the patch, not to the size of the elements.
Plan plan(const Case& c, LayerCondenser& condenser) {
    require_layer(c);
    contact::NormalControl hardest = contact::press_step(c).normal;
    hardest.value *= contact::crest_factor(c);
    const double radius = patch_margin * probe_radius(c, hardest, condenser);
    const std::optional<double>& given = c.of<Settings>().size;
    const double size = given ? *given : size_for_accuracy(c, radius, condenser);
    const double ring = c.adhesion ? contact::points_without_range * size : 0;
    const Plan plan{size, radius + ring, shift_to_expect(c, radius)};
    say_what_was_chosen(c, spec_of(c, plan), condenser);
    return plan;
}

meshes::HexMesh read_users_mesh(const Case& c) {
    const std::string& file = *c.of<Settings>().mesh;
    meshes::HexMesh mesh = meshes::read_mesh(file, c.of<Settings>().mesh_unit);
    if (mesh.has_symmetry() && !contact::is_mirror_symmetric(c))
        throw contact::InputError(file +
                                  ": the mesh has a plane of symmetry, but the rolling direction "
                                  "is not in it; mesh the whole body or set rolling.angle to 0");
    const bool has_lower =
        std::count(mesh.regions.begin(), mesh.regions.end(), meshes::Region::lower_layer) > 0;
    if (has_lower && c.layer.lower.empty())
        throw contact::InputError(file +
                                  ": the mesh has a lower layer, the case no [lower_layer] that "
                                  "names its material; add one");
    return mesh;
}

std::unique_ptr<contact::Model> make_strained(const Case& c, const std::optional<Plan>& own,
                                              const Say& say) {
    StrainedModel::Setup setup{.layer = {},
                               .indenter = c.make_indenter(),
                               .rolling_radius = c.indenter.radius,
                               .friction = c.friction.law(),
                               .tolerance = of_fem_tolerance * c.of<Settings>().tolerance,
                               .c01_ratio = {c.c01_ratio.value_or(0), c.c01_ratio.value_or(0)},
                               .relaxation = c.relaxation.value_or(contact::Relaxation{})};
    if (!own) {
        setup.layer = LayerCondenser(c, say).make(read_users_mesh(c));
        return std::make_unique<StrainedModel>(std::move(setup));
    }
    const auto on = [c, say](const Plan& plan) -> std::shared_ptr<const CondensedCompliance> {
        LayerCondenser condenser(c, say);
        return make_fitting_layer(c, spec_of(c, plan), condenser);
    };
    setup.layer = on(*own);
    setup.larger_layer = [on, plan = *own]() mutable {
        plan.contact_radius *= patch_growth;
        plan.shift *= patch_growth;
        return on(plan);
    };
    return std::make_unique<StrainedModel>(std::move(setup));
}

/// Bodies of files: their meshes say how fine, and how far.
std::unique_ptr<contact::Model> make_meshed(const Case& c, const LayerCondenser& condenser,
                                            const Say& say) {
    MeshedContact bodies = make_meshed_contact(c, condenser);
    const auto of_elastic = [&](const Case& elastic) -> std::shared_ptr<const contact::Compliance> {
        return make_meshed_contact(elastic, LayerCondenser(elastic, say)).compliance;
    };
    return std::make_unique<contact::SurfaceModel>(
        contact::models::fem,
        *contact::make_substrate(c, false, std::move(bodies.compliance), of_elastic),
        std::move(bodies.indenter), c.friction.law(), c.of<Settings>().tolerance, c.contact);
}

}  // namespace

meshes::LayerMeshSpec mesh_spec(const Case& c, const Say& say) {
    LayerCondenser condenser(c, say);
    return spec_of(c, plan(c, condenser));
}

meshes::HexMesh make_mesh(const Case& c, const Say& say) {
    if (c.has_rigid_substrate)
        throw contact::InputError(
            "substrate.rigid: a rigid substrate has no mesh; give the substrate a thickness");
    return c.of<Settings>().mesh ? read_users_mesh(c) : make_layer_mesh(mesh_spec(c, say));
}

std::unique_ptr<contact::Model> make_model(const Case& c, const Say& say, int n_threads) {
    require_layer(c);
    LayerCondenser condenser(c, say);
    if (c.indenter.body && c.indenter.body->mesh) return make_meshed(c, condenser, say);
    std::optional<Plan> own;
    if (!c.of<Settings>().mesh) own = plan(c, condenser);
    if (c.law != Case::Law::linear) return make_strained(c, own, say);
    auto of_elastic = [&](const Case& elastic) -> std::unique_ptr<contact::Compliance> {
        LayerCondenser other(elastic, say);
        if (!own) return other.make(read_users_mesh(elastic));
        return make_fitting(elastic, spec_of(c, *own), other);
    };
    const auto direct = [&]() -> std::unique_ptr<contact::Model> {
        auto relaxed = contact::relaxes_as_one(c) ? of_elastic(c) : nullptr;
        std::shared_ptr<const contact::Indenter> indenter = c.make_indenter();
        if (c.adhesion)
            indenter = std::make_shared<MeanHeights>(indenter, relaxed->points().spacing);
        auto model = std::make_unique<contact::SurfaceModel>(
            contact::models::fem,
            *contact::make_substrate(c, false, std::move(relaxed), of_elastic), indenter,
            c.friction.law(), c.of<Settings>().tolerance, c.contact);
        if (c.adhesion) model->attract(c.adhesion->attraction(), c.materials().effective_modulus());
        return model;
    };
    return own ? by_solver(c, spec_of(c, *own), n_threads, say, direct) : direct();
}

}  // namespace tricontact::fem
