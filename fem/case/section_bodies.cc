#include "fem/case/section_bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/base/error.h"
#include "contact/bodies/upper_plate.h"
#include "fem/case/indenter_body.h"
#include "fem/planar/sections.h"
#include "fem/settings.h"

namespace tricontact::fem {

using contact::Case;
using contact::ElasticBody;
using planar::Solid;

namespace {

constexpr double widest_angle = 88 * std::numbers::pi / 180;  // of a contact in a hole
constexpr double far_side = 20;  // of the layer's side from the patch, in thicknesses

/// Of the bodies below their contact [m].
double least_depth(const Case& c) {
    if (c.has_hole() && !c.indenter.body) return c.hole.outer_radius - c.hole.radius;
    const contact::ElasticBody& body = *c.indenter.body;
    if (c.indenter.is_punch()) return body.height;
    return body.support == ElasticBody::Support::hub ? c.indenter.radius - body.hub_radius
                                                     : c.indenter.radius / 2;
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

planar::CondensedSection body_held(const Case& c, Solid solid, const planar::Sizes& sizes,
                                   planar::Support support) {
    return condense(problem_of(indenter_mesh(c, sizes), solid, *c.indenter.material, support,
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

/// Half of its compliance.
planar::CondensedSection half_of(planar::CondensedSection body) {
    for (double& entry : body.compliance) entry /= 2;
    return body;
}

}  // namespace

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

std::vector<planar::CondensedSection> bodies_of(const Case& c, Solid solid,
                                                const planar::Sizes& sizes) {
    if (c.has_hole()) return pin_and_hole(c, sizes);
    std::vector<planar::CondensedSection> bodies;
    if (c.indenter.body)
        bodies.push_back(body_held(c, solid, sizes, support_of(c.indenter.body->support)));
    if (!c.has_rigid_substrate) bodies.push_back(layer_of(c, solid, sizes));
    return bodies;
}

// Loads on both sides of the middle plane, p below and q above it, are equal ones of (p + q)/2 and
// opposite ones of (p - q)/2, under which that plane slides along itself, and across itself with
// its mean at rest: displacements below are those of C_s and C_a, (C_s + C_a)/2 of p and
// (C_s - C_a)/2 of q.
OpposedSections opposed_sections(const Case& c, const Case& upper, Solid solid,
                                 const planar::Sizes& sizes) {
    const planar::CondensedSection alike =
        half_of(body_held(c, solid, sizes, planar::Support::sliding));
    planar::CondensedSection opposite =
        half_of(body_held(c, solid, sizes, planar::Support::opposite));
    // Opposite loads have no resultant: what holds the body takes nothing of them.
    std::ranges::fill(opposite.missing_reaction, 0.);
    OpposedSections all{{alike, opposite}, {alike, opposite}, {alike, opposite}};
    if (!c.has_rigid_substrate) all.lower.push_back(layer_of(c, solid, sizes));
    if (!upper.has_rigid_substrate) all.upper.push_back(layer_of(upper, solid, sizes));
    for (double& entry : all.across.back().compliance) entry = -entry;
    return all;
}

Case seen_from_above(const Case& c, double force) {
    const auto& plate = *c.kept.find<contact::UpperPlate>();
    Case upper = c;
    upper.kept.reset<contact::UpperPlate>();
    upper.has_rigid_substrate = plate.is_rigid;
    upper.substrate = plate.is_rigid ? contact::rigid_material : plate.material;
    upper.layer = {};
    if (!plate.is_rigid) upper.layer.thickness = plate.thickness;
    upper.prescribed_path.reset();
    upper.load.indentation.reset();
    upper.load.normal_force = force;
    return upper;
}

}  // namespace tricontact::fem
