#include "fem/case/section_bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/base/error.h"
#include "contact/half_space_scales.h"
#include "contact/load_path.h"
#include "contact/solvers/contact_region.h"
#include "contact/solvers/normal_solver.h"
#include "fem/case/indenter_body.h"
#include "fem/case/mesh_choice.h"
#include "fem/planar/sections.h"
#include "fem/settings.h"

namespace tricontact::fem {

using contact::Case;
using contact::ElasticBody;
using contact::ModelKind;
using planar::Solid;

namespace {

constexpr double probing_margin = 1.15;
constexpr double room_growth = 1.5;  // of the room that is probed
constexpr int probing_elements = 8;  // across the half width that is expected
constexpr int most_probes = 20;
constexpr int fewest_elements = 24;
constexpr int fewest_attracted = 60;  // as a contact lets go its radius is about half of it
constexpr double widest_angle = 88 * std::numbers::pi / 180;  // of a contact in a hole
constexpr double far_side = 20;  // of the layer's side from the patch, in thicknesses

/// Elements across the contact whose force errs by no more: spheres and cylinders on meshes of 8 to
/// 60 of them err by less than .16/n^2 (tests/verification/fem/planar). No fewer than 24, since
/// they cost nothing.
int elements_for(double accuracy) {
    return std::max(fewest_elements, static_cast<int>(std::ceil(.4 / std::sqrt(accuracy))));
}

/// Of the bodies below their contact [m].
double least_depth(const Case& c) {
    if (c.has_hole() && !c.indenter.body) return c.hole.outer_radius - c.hole.radius;
    const contact::ElasticBody& body = *c.indenter.body;
    if (c.indenter.is_punch()) return body.height;
    return body.support == ElasticBody::Support::hub ? c.indenter.radius - body.hub_radius
                                                     : c.indenter.radius / 2;
}

planar::Sizes sizes_of(const Case& c, const SectionPatch& patch) {
    const int n = std::max(2, static_cast<int>(std::ceil(patch.half_width / patch.size - 1e-9)));
    const double size = patch.is_whole_face ? patch.half_width / n : patch.size;
    // Growth of fem.growth, which is meant for hexahedra, is too coarse for what costs nothing.
    const double growth = 1 + (c.of<Settings>().growth - 1) / 3;
    double depth = c.layer.thickness.value_or(contact::infinity);
    if (c.indenter.body || c.has_hole()) depth = std::min(depth, least_depth(c));
    const int deep = std::max(1, static_cast<int>(std::min(n / 6., depth / 4 / size)));
    return {n, size, growth, deep};
}

/// A section on both sides of x = 0, or from the axis outwards; `round_frame`: radius along which
/// it is pressed [m], 0: along z.
planar::BodyProblem problem_of(planar::Mesh half, Solid solid, const contact::Material& material,
                               planar::Support support, double round_frame = 0) {
    planar::BodyProblem problem;
    if (round_frame > 0) problem.frame = planar::Frame::round;
    problem.radius = round_frame;
    problem.mesh = solid == Solid::plane_strain ? with_mirror_image(half) : std::move(half);
    problem.solid = solid;
    problem.material = material;
    problem.support = support;
    return problem;
}

planar::CondensedSection layer_of(const Case& c, Solid solid, const planar::Sizes& sizes) {
    const double thickness = *c.layer.thickness;
    const double side = c.layer.width ? *c.layer.width / 2 : sizes.patch() + far_side * thickness;
    if (!(sizes.patch() < side))
        throw contact::InputError(fmt::format(
            "substrate.width: the contact's {:.4g} m to either side reach the edge; enlarge it",
            sizes.patch()));
    return condense(problem_of(layer_section(sizes, side, thickness), solid, c.substrate,
                               c.layer.base == Case::Base::frictionless ? planar::Support::sliding
                                                                        : planar::Support::bonded));
}

planar::Mesh indenter_mesh(const Case& c, const planar::Sizes& sizes) {
    const contact::ElasticBody& body = *c.indenter.body;
    const double radius = c.indenter.radius;
    if (rolls_on_its_hub(c)) return pin_section(sizes, radius, body.hub_radius);
    if (body.support == ElasticBody::Support::hub)
        return disc_section(sizes, radius, body.hub_radius);
    if (!c.indenter.is_punch()) return half_disc_section(sizes, radius);
    const auto indenter = c.make_indenter();
    // Of a punch with a sharp edge the radius is 0.
    return block_section(sizes, c.indenter.flat_radius + radius, body.height,
                         [&](double x) { return indenter->height(x, 0); });
}

planar::Support support_of(ElasticBody::Support support) {
    switch (support) {
        case ElasticBody::Support::plates:  // the middle plane stays where it is
            return planar::Support::sliding;
        case ElasticBody::Support::force:
            return planar::Support::point;
        case ElasticBody::Support::pressure:
            return planar::Support::even;
        default:
            return planar::Support::bonded;
    }
}

planar::CondensedSection indenter_of(const Case& c, Solid solid, const planar::Sizes& sizes) {
    return condense(problem_of(indenter_mesh(c, sizes), solid, *c.indenter.material,
                               support_of(c.indenter.body->support),
                               rolls_on_its_hub(c) ? c.indenter.radius : 0));
}

// Plane strain has no length of its own: the hole is meshed about the pin's radius, so that points
// of both bodies are joined by their angle.
std::vector<planar::CondensedSection> pin_and_hole(const Case& c, const planar::Sizes& sizes) {
    const double radius = c.indenter.radius;
    std::vector<planar::CondensedSection> bodies;
    const auto add = [&](planar::Mesh half, const contact::Material& material) {
        bodies.push_back(condense(problem_of(std::move(half), Solid::plane_strain, material,
                                             planar::Support::bonded, radius)));
    };
    if (c.indenter.body)
        add(pin_section(sizes, radius, c.indenter.body->hub_radius), *c.indenter.material);
    if (!c.has_rigid_substrate)
        add(hole_section(sizes, radius, c.hole.outer_radius * radius / c.hole.radius), c.substrate);
    return bodies;
}

std::vector<planar::CondensedSection> bodies_of(const Case& c, Solid solid,
                                                const planar::Sizes& sizes) {
    if (c.has_hole()) return pin_and_hole(c, sizes);
    std::vector<planar::CondensedSection> bodies;
    if (c.indenter.body) bodies.push_back(indenter_of(c, solid, sizes));
    if (!c.has_rigid_substrate) bodies.push_back(layer_of(c, solid, sizes));
    return bodies;
}

/// Half width or radius of the contact [m], 0 where it reaches the edge of the points; of surfaces
/// that attract each other as far as they do.
double pressed_radius(const Case& c, const contact::Compliance& compliance) {
    contact::NormalControl hardest = contact::press_step(c).normal;
    hardest.value *= contact::crest_factor(c);
    const contact::ContactPoints& points = compliance.points();
    const auto height = heights_over(points, *c.make_indenter(), {0, 0});
    const auto carries =
        c.adhesion ? attracted_by(c, compliance, height, hardest)
                   : contact::NormalSolver(compliance, 1e-6).solve(height, hardest).pressure;
    if (reaches_edge(points, carries)) return 0;
    return c.adhesion ? counted_radius(points, carries) : contact_radius(points, carries, {0, 0});
}

}  // namespace

SectionPatch section_patch(const Case& c, double half_width, double size) {
    if (c.indenter.shape != Case::Shape::flat_punch) return {half_width, size};
    const double face = c.indenter.flat_radius;
    if (half_width > face - 2 * size) return {face, size, true};
    return {half_width, size};
}

double widest_patch(const Case& c) {
    if (c.has_hole()) return widest_angle * c.indenter.radius;
    if (c.indenter.shape == Case::Shape::flat_punch) return c.indenter.flat_radius;
    if (!c.indenter.body) return contact::infinity;
    if (c.indenter.is_punch()) return .95 * (c.indenter.flat_radius + c.indenter.radius);
    if (rolls_on_its_hub(c)) return 2.7 * c.indenter.radius;  // along its surface, pi R
    return .65 * c.indenter.radius;  // what is beyond, the mesh needs to grow in
}

void refuse_too_large(const Case& c, double half_width) {
    throw contact::InputError(fmt::format(
        "load: the contact, more than {:.4g} m to either side, is too large for the indenter's "
        "body{}; reduce the load",
        half_width, c.has_hole() ? ", which the hole closes around" : ""));
}

std::unique_ptr<planar::SectionCompliance> section_compliance(const Case& c, Solid solid,
                                                              const SectionPatch& patch,
                                                              SectionPoints points) {
    const planar::Sizes sizes = sizes_of(c, patch);
    if (sizes.patch() > widest_patch(c) * (1 + 1e-9)) refuse_too_large(c, sizes.patch());
    const std::vector<planar::CondensedSection> bodies = bodies_of(c, solid, sizes);
    planar::PairOptions options;
    options.conforming = c.has_hole();
    options.with_friction = c.contact.coupling;
    options.radius = c.indenter.radius;
    const bool line = solid == Solid::plane_strain;
    options.length = line ? c.indenter.length : 1;
    options.local_ratio =
        line ? 1 : c.materials().effective_modulus() / c.materials().effective_shear_modulus();
    options.is_whole_face = patch.is_whole_face;
    options.first_presses = c.indenter.body.has_value();
    const auto grid = [&] {
        if (points == SectionPoints::elements) return planar::elements_of(bodies);
        return c.adhesion ? planar::rings_on_nodes(bodies) : grid_between(bodies);
    };
    return pair_compliance(bodies, grid(), options);
}

double probed_radius(const Case& c, Solid solid) {
    double room = probing_margin * contact::half_space_scales(c).contact_radius;
    const bool sharp = c.indenter.shape == Case::Shape::flat_punch;
    const double widest = sharp ? c.indenter.flat_radius : .99 * widest_patch(c);
    for (int k = 0; k < most_probes; ++k, room *= room_growth) {
        room = std::min(room, widest);
        const auto compliance =
            section_compliance(c, solid, section_patch(c, room, room / probing_elements));
        const double radius = pressed_radius(c, *compliance);
        if (radius == 0) {
            if (room >= widest) refuse_too_large(c, room);
            continue;
        }
        if (radius > room / 4) return radius;
        room = 2 * radius / room_growth;
    }
    throw contact::NotConverged("the radius of the contact was not found on coarse elements");
}

void require_bodies(const Case& c, const ModelKind& kind) {
    if (!c.has_rigid_substrate && !c.layer.thickness && !c.has_hole())
        throw contact::InputError(std::string(kind.name) +
                                  ": needs substrate.thickness, or substrate.rigid = true");
    if (c.has_rigid_substrate && !c.indenter.body)
        throw contact::InputError(std::string(kind.name) +
                                  ": on a rigid substrate the indenter needs an indenter.body");
}

Solid solid_of(const ModelKind& kind) {
    return kind.cut == ModelKind::Cut::plane_strain ? Solid::plane_strain : Solid::of_revolution;
}

double chosen_size(const Case& c, double radius) {
    const auto& accuracy = c.of<Settings>().accuracy;
    const int n = accuracy ? elements_for(*accuracy) : fewest_elements;
    return radius / (c.adhesion ? std::max(n, fewest_attracted) : n);
}

}  // namespace tricontact::fem
