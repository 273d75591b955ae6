#include "fem/case/section_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/base/error.h"
#include "contact/half_space_scales.h"
#include "contact/load_path.h"
#include "contact/relaxing_case.h"
#include "contact/solvers/contact_region.h"
#include "contact/surface_model.h"
#include "fem/case/indenter_body.h"
#include "fem/case/model_of_revolution.h"
#include "fem/planar/pair.h"
#include "fem/planar/sections.h"
#include "fem/settings.h"

// From a case to a model of a section, as fem/case/model.cc to one in three dimensions:
//
//   radius of the contact (probed) --> size of elements --> patch = contact + path + margin
//       --> sections of both bodies --> condensed --> pair --> Substrate --> SurfaceModel
//
// Sections are small: nothing is kept between runs.

namespace tricontact::fem {

using contact::Case;
using contact::ElasticBody;
using contact::ModelKind;
using planar::Solid;

namespace {

constexpr double section_margin = 1.15;
constexpr double corner = 1.4143;       // a square of revolution's surface is shown, to its corners
constexpr double section_growth = 1.5;  // of the room when the contact has reached its edge
constexpr int probing_elements = 8;     // across the half width that is expected
constexpr int most_probes = 20;
constexpr int fewest_elements = 24;
constexpr double far_side = 20;  // of the layer's side from the patch, in thicknesses

/// Elements across the contact whose force errs by no more: spheres and cylinders on meshes of 8 to
/// 60 of them err by less than .16/n^2 (tests/verification/fem/planar). No fewer than 24, since
/// they cost nothing.
int elements_for(double accuracy) {
    return std::max(fewest_elements, static_cast<int>(std::ceil(.4 / std::sqrt(accuracy))));
}

struct Patch {
    double half_width, size;
};

/// Of the indenter's body below its contact [m].
double least_depth(const Case& c) {
    const contact::ElasticBody& body = *c.indenter.body;
    if (body.form == ElasticBody::Form::punch) return body.height;
    return body.support == ElasticBody::Support::hub ? c.indenter.radius - body.hub_radius
                                                     : c.indenter.radius / 2;
}

planar::Sizes sizes_of(const Case& c, const Patch& patch) {
    const int n = std::max(2, static_cast<int>(std::ceil(patch.half_width / patch.size - 1e-9)));
    // Growth of fem.growth, which is meant for hexahedra, is too coarse for what costs nothing.
    const double growth = 1 + (c.of<Settings>().growth - 1) / 3;
    double depth = c.layer.thickness.value_or(contact::infinity);
    if (c.indenter.body) depth = std::min(depth, least_depth(c));
    const int deep = std::max(1, static_cast<int>(std::min(n / 6., depth / 4 / patch.size)));
    return {n, patch.size, growth, deep};
}

/// A section on both sides of x = 0, or from the axis outwards.
planar::BodyProblem problem_of(planar::Mesh half, Solid solid, const contact::Material& material,
                               planar::Support support) {
    planar::BodyProblem problem;
    problem.mesh = solid == Solid::plane_strain ? with_mirror_image(half) : std::move(half);
    problem.solid = solid;
    problem.material = material;
    problem.support = support;
    return problem;
}

planar::CondensedSection layer_of(const Case& c, Solid solid, const planar::Sizes& sizes) {
    const double thickness = *c.layer.thickness;
    return condense(
        problem_of(layer_section(sizes, sizes.patch() + far_side * thickness, thickness), solid,
                   c.substrate,
                   c.layer.base == Case::Base::frictionless ? planar::Support::sliding
                                                            : planar::Support::bonded));
}

planar::Mesh indenter_mesh(const Case& c, const planar::Sizes& sizes) {
    const contact::ElasticBody& body = *c.indenter.body;
    const double radius = c.indenter.radius;
    if (rolls_on_its_hub(c)) return pin_section(sizes, radius, body.hub_radius);
    if (body.support == ElasticBody::Support::hub)
        return disc_section(sizes, radius, body.hub_radius);
    if (body.form != ElasticBody::Form::punch) return half_disc_section(sizes, radius);
    const auto indenter = c.make_indenter();
    return block_section(sizes, c.indenter.flat_radius + radius, body.height,
                         [&](double x) { return indenter->height(x, 0); });
}

planar::CondensedSection indenter_of(const Case& c, Solid solid, const planar::Sizes& sizes) {
    // Between two plates the middle plane stays where it is.
    const bool plates = c.indenter.body->support == ElasticBody::Support::plates;
    planar::BodyProblem problem =
        problem_of(indenter_mesh(c, sizes), solid, *c.indenter.material,
                   plates ? planar::Support::sliding : planar::Support::bonded);
    if (rolls_on_its_hub(c)) {
        problem.frame = planar::Frame::round;
        problem.radius = c.indenter.radius;
    }
    return condense(problem);
}

/// Most that a patch may have of the indenter's body [m].
double widest_patch(const Case& c) {
    if (!c.indenter.body) return contact::infinity;
    if (c.indenter.body->form == ElasticBody::Form::punch)
        return .95 * (c.indenter.flat_radius + c.indenter.radius);
    if (rolls_on_its_hub(c)) return 2.7 * c.indenter.radius;  // along its surface, pi R
    return .65 * c.indenter.radius;  // what is beyond, the mesh needs to grow in
}

[[noreturn]] void refuse_too_large(double half_width) {
    throw contact::InputError(fmt::format(
        "load: the contact, more than {:.4g} m to either side, is too large for the indenter's "
        "body; reduce the load",
        half_width));
}

std::unique_ptr<planar::SectionCompliance> compliance_of(const Case& c, Solid solid,
                                                         const Patch& patch) {
    const planar::Sizes sizes = sizes_of(c, patch);
    if (sizes.patch() > widest_patch(c)) refuse_too_large(sizes.patch());
    std::vector<planar::CondensedSection> bodies;
    if (c.indenter.body) bodies.push_back(indenter_of(c, solid, sizes));
    if (!c.has_rigid_substrate) bodies.push_back(layer_of(c, solid, sizes));
    planar::PairOptions options;
    const bool line = solid == Solid::plane_strain;
    options.length = line ? c.indenter.length : 1;
    options.local_ratio =
        line ? 1 : c.materials().effective_modulus() / c.materials().effective_shear_modulus();
    return pair_compliance(bodies, grid_between(bodies), options);
}

contact::NormalSolution press(const Case& c, const contact::Compliance& compliance) {
    contact::NormalControl hardest = contact::press_step(c).normal;
    hardest.value *= contact::crest_factor(c);
    const contact::NormalSolver solver(compliance, 1e-6);
    return solver.solve(heights_over(compliance.points(), *c.make_indenter(), {0, 0}), hardest);
}

/// Half width or radius of the contact under the case's hardest load [m], on coarse elements.
double probed_radius(const Case& c, Solid solid) {
    double room = section_margin * contact::half_space_scales(c).contact_radius;
    const double widest = .99 * widest_patch(c);
    for (int k = 0; k < most_probes; ++k, room *= section_growth) {
        room = std::min(room, widest);
        const auto compliance = compliance_of(c, solid, {room, room / probing_elements});
        const auto solution = press(c, *compliance);
        const contact::ContactPoints& points = compliance->points();
        if (reaches_edge(points, solution.pressure)) {
            if (room >= widest) refuse_too_large(room);
            continue;
        }
        const double radius = contact_radius(points, solution.pressure, {0, 0});
        if (radius > room / 4) return radius;
        room = 2 * radius / section_growth;
    }
    throw contact::NotConverged("the radius of the contact was not found on coarse elements");
}

void require_bodies(const Case& c, const ModelKind& kind) {
    if (!c.has_rigid_substrate && !c.layer.thickness)
        throw contact::InputError(std::string(kind.name) +
                                  ": needs substrate.thickness, or substrate.rigid = true");
    if (c.has_rigid_substrate && !c.indenter.body)
        throw contact::InputError(std::string(kind.name) +
                                  ": on a rigid substrate the indenter needs an indenter.body");
}

Solid solid_of(const ModelKind& kind) {
    return kind.cut == ModelKind::Cut::plane_strain ? Solid::plane_strain : Solid::of_revolution;
}

/// Of elements, if the case does not give it, for a contact of this radius [m].
double chosen_size(const Settings& settings, double radius) {
    return radius / (settings.accuracy ? elements_for(*settings.accuracy) : fewest_elements);
}

}  // namespace

double section_size(const ModelKind& kind, const Case& c) {
    require_bodies(c, kind);
    const Settings& settings = c.of<Settings>();
    return settings.size ? *settings.size : chosen_size(settings, probed_radius(c, solid_of(kind)));
}

std::unique_ptr<contact::Model> make_section_model(const ModelKind& kind, const Case& c,
                                                   const Say& say) {
    require_bodies(c, kind);
    const Solid solid = solid_of(kind);
    const std::string name = kind.name;
    const double radius = probed_radius(c, solid);
    const Settings& settings = c.of<Settings>();
    const double size = settings.size ? *settings.size : chosen_size(settings, radius);
    if (size > radius / 2)
        throw contact::InputError(fmt::format(
            "fem.size: {}: fewer than 2 elements across the contact's {:.4g} m; reduce it", name,
            radius));
    const double margin = solid == Solid::of_revolution ? corner * section_margin : section_margin;
    const double half =
        std::min(margin * radius + contact::path_reach(c, radius)[0], widest_patch(c) - size);
    if (say && !settings.size)
        say(fmt::format("{}: elements of {:.4g} mm, {:.3g} across the contact", name, 1e3 * size,
                        radius / size));
    const auto substrate = [=](const Case& of, double room) {
        const Patch patch{room, size};
        const contact::ComplianceOf elastic = [=](const Case& other) {
            return compliance_of(other, solid, patch);
        };
        auto relaxed = contact::relaxes_as_one(of) ? elastic(of) : nullptr;
        return contact::make_substrate(of, false, std::move(relaxed), elastic);
    };
    auto model =
        std::make_unique<contact::SurfaceModel>(name, *substrate(c, half), c.make_indenter(),
                                                c.friction.law(), settings.tolerance, c.contact);
    model->set_larger_grid(
        [=, room = half](const contact::ContactAtEdge&) mutable
        -> std::unique_ptr<contact::Substrate> { return substrate(c, room *= section_growth); });
    if (solid == Solid::plane_strain) return model;
    return std::make_unique<ModelOfRevolution>(std::move(model),
                                               c.materials().effective_shear_modulus());
}

}  // namespace tricontact::fem
