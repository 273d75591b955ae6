#include "fem/case/meshed_bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/base/error.h"
#include "contact/half_space_scales.h"
#include "contact/models/model_kind.h"
#include "fem/case/mesh_choice.h"
#include "fem/mortar/pressure_grid.h"
#include "fem/mortar/surface_gap.h"
#include "fem/mortar/surface_heights.h"
#include "fem/settings.h"
#include "meshes/body_mesh.h"

// Files have z up and both bodies in one frame; a body is condensed as a substrate of its own, an
// indenter upside down. Which nodes the bodies have does not matter: pressures have a grid of their
// own (fem/mortar/pressure_grid.h), with the spacing of the coarser body's nodes.

namespace tricontact::fem {

using contact::Case;
using contact::ContactPoints;
using contact::InputError;
using contact::Vector2;

namespace {

/// A body before it is condensed.
struct MeshedBody {
    std::string name;  ///< of its file
    LayerProblem problem;
    ContactPoints points;        ///< of its contact surface
    std::vector<double> height;  ///< of these, z up [m]
};

MeshedBody body_of(std::string name, LayerProblem problem, bool is_upside_down) {
    const Q2Space space(problem.mesh);
    const ContactSurface surface = contact_surface(space);
    MeshedBody body{std::move(name), std::move(problem), surface.points, {}};
    for (const int node : surface.nodes)
        body.height.push_back(is_upside_down ? -space.nodes[node][2] : space.nodes[node][2]);
    return body;
}

MeshedBody indenter_of(const Case& c) {
    const contact::ElasticBody& given = *c.indenter.body;
    const meshes::HexMesh mesh = meshes::read_body_mesh(*given.mesh, given.mesh_unit);
    meshes::check_facing(mesh, false, *given.mesh);
    if (mesh.has_symmetry() && !contact::is_mirror_symmetric(c))
        throw InputError(*given.mesh +
                         ": the mesh has a plane of symmetry, but not all motions lie in it; mesh "
                         "the whole body, or leave out what moves it across");
    if (c.has_rigid_substrate || !c.of<Settings>().mesh)
        meshes::check_above_plane(mesh, *given.mesh);
    LayerProblem problem;
    problem.mesh = meshes::turned_over(mesh);
    problem.materials = {*c.indenter.material, *c.indenter.material};
    return body_of(*given.mesh, std::move(problem), true);
}

MeshedBody substrate_of_file(const Case& c, bool half) {
    const std::string& file = *c.of<Settings>().mesh;
    LayerProblem problem;
    problem.mesh = meshes::read_body_mesh(file, c.of<Settings>().mesh_unit);
    meshes::check_facing(problem.mesh, true, file);
    if (problem.mesh.has_symmetry() != half)
        throw InputError(file +
                         ": one body is a half with a surface \"symmetry\", the other is "
                         "whole; mesh both alike");
    problem.materials = {c.substrate, c.substrate};
    return body_of(file, std::move(problem), false);
}

/// A layer whose patch holds what the indenter's contact surface covers.
MeshedBody layer_under(const Case& c, const ContactPoints& indenter, const Rectangle& r) {
    double radius = 0;
    for (int d = 0; d < 2; ++d)
        radius = std::max({radius, std::abs(r.low[d]), std::abs(r.high[d])});
    const double size = c.of<Settings>().size.value_or(2 * node_spacing(indenter, r));
    meshes::LayerMeshSpec spec = spec_for(c, size, radius);
    spec.half_model = indenter.mirrored;
    if (std::min(spec.half_x, spec.half_y) < spec.patch_x + size)
        throw InputError(fmt::format(
            "substrate.width: the indenter's contact surface is {:.4g} m wide and must leave an "
            "element on either side of the block; enlarge width and depth, or name less "
            "\"contact\"",
            2 * spec.patch_x));
    return body_of("layer", problem_of(c, make_layer_mesh(spec)), false);
}

Rectangle shared_by(const std::vector<const MeshedBody*>& bodies) {
    std::vector<const ContactPoints*> surfaces;
    for (const MeshedBody* body : bodies) surfaces.push_back(&body->points);
    const auto shared = shared_rectangle(surfaces);
    const bool half = bodies.front()->points.mirrored;
    if (shared && shared->low[0] < 0 && shared->high[0] > 0 && shared->high[1] > 0 &&
        (half || shared->low[1] < 0))
        return *shared;
    throw InputError(
        bodies.back()->name +
        ": the contact surfaces do not face each other about the origin x = y = 0; move the "
        "bodies so that they touch there, and name surfaces without holes \"contact\"");
}

CondensedPart onto_grid(MeshedBody body, const ContactPoints& grid, const LayerCondenser& condenser,
                        const char* what) {
    CondensedPart part = condenser.part(std::move(body.problem), what);
    part.transfer = transfer_to(body.points, grid);
    part.layer = on_grid(std::move(part.layer), grid, *part.transfer);
    return part;
}

void say_grid(const Case& c, const ContactPoints& grid, const std::vector<double>& spacings,
              const LayerCondenser& condenser) {
    const double a = contact::half_space_scales(c).contact_radius;
    const double step = std::max(grid.spacing[0], grid.spacing[1]);
    condenser.say(
        fmt::format("pressures on a grid of {} x {} points, {:.4g} mm apart, {:.3g} in the "
                    "half-space's contact "
                    "radius; nodes of the bodies are up to {:.4g} mm apart",
                    grid.n_x, grid.n_y, 1e3 * step, a / step,
                    fmt::join(
                        [&] {
                            std::vector<double> mm = spacings;
                            for (double& x : mm) x *= 1e3;
                            return mm;
                        }(),
                        " and ")));
    constexpr double steep = .1, coarse = 4;
    if (a / step < coarse)
        condenser.say(
            "that is coarse: with less than 4 points in the radius pressures are off by "
            "several per cent; mesh the contact surfaces finer");
    if (a > steep * c.indenter.radius)
        condenser.say(fmt::format(
            "a/R = {:.2g}: above 0.1 the choice of z as direction of contact changes the force by "
            "1 % and more",
            a / c.indenter.radius));
}

/// How far the gap of the meshes is from the shape that other models press; `least` [m]: that gap
/// where they touch.
void say_shape(const Case& c, const ContactPoints& points, const SurfaceHeights& above,
               const SurfaceHeights* below, double least, const LayerCondenser& condenser) {
    const double a = contact::half_space_scales(c).contact_radius;
    const auto shape = c.make_indenter();
    double off = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double x = points.x[i], y = points.y[i];
        const auto lower = below ? below->at({x, y}) : std::optional(0.);
        if (std::hypot(x, y) > a || !lower) continue;
        const double gap = above.at_points()[i] - *lower - least;
        off = std::max(off, std::abs(gap - shape->height(x, y)));
    }
    condenser.say(
        fmt::format("the gap of the meshes differs from that of indenter.shape, which "
                    "half-space models take, by up to {:.3g} um within the half-space's "
                    "contact radius",
                    1e6 * off));
}

}  // namespace

MeshedContact make_meshed_contact(const Case& c, const LayerCondenser& condenser) {
    MeshedBody indenter = indenter_of(c);
    std::optional<MeshedBody> substrate;
    if (c.of<Settings>().mesh) {
        substrate = substrate_of_file(c, indenter.points.mirrored);
    } else if (!c.has_rigid_substrate) {
        substrate = layer_under(c, indenter.points, shared_by({&indenter}));
    }
    std::vector<const MeshedBody*> bodies{&indenter};
    if (substrate) bodies.insert(bodies.begin(), &*substrate);
    const Rectangle shared = shared_by(bodies);
    std::vector<double> spacings;
    for (const MeshedBody* body : bodies) spacings.push_back(node_spacing(body->points, shared));
    const ContactPoints grid =
        pressure_grid(shared, std::ranges::max(spacings), indenter.points.mirrored);
    const SurfaceHeights above(indenter.points, indenter.height);
    std::optional<SurfaceHeights> below;
    if (substrate) below.emplace(substrate->points, substrate->height);
    SurfaceGap gap(grid);
    gap.add(above, transfer_to(indenter.points, grid), 1);
    if (below) gap.add(*below, transfer_to(substrate->points, grid), -1);
    const SurfaceGap::Least least = gap.let_down(above, below ? &*below : nullptr);
    const double rounding = 1e-6 * grid.spacing[0];
    if (least.height < -rounding)
        throw InputError(fmt::format(
            "{}: the bodies overlap by {:.4g} m at x = {:.4g} m, y = {:.4g} m; move the indenter "
            "up: it is let down until it touches",
            indenter.name, -least.height, least.place[0], least.place[1]));
    say_grid(c, grid, spacings, condenser);
    condenser.say(
        fmt::format("the indenter is let down by {:.4g} mm until it touches at x = {:.3g} "
                    "mm, y = {:.3g} mm",
                    1e3 * std::max(0., least.height), 1e3 * least.place[0], 1e3 * least.place[1]));
    say_shape(c, indenter.points, above, below ? &*below : nullptr, least.height, condenser);

    MeshedContact contact;
    contact.indenter = std::make_unique<SurfaceGap>(std::move(gap));
    CondensedPart upper = onto_grid(std::move(indenter), grid, condenser, "indenter");
    if (!substrate) {
        contact.compliance = std::make_unique<PairCompliance>(ContactSurface{{}, grid, {}},
                                                              std::move(upper), c.interface);
        return contact;
    }
    CondensedPart lower = onto_grid(std::move(*substrate), grid, condenser,
                                    c.of<Settings>().mesh ? "substrate" : "layer");
    contact.compliance =
        std::make_unique<PairCompliance>(std::move(lower), std::move(upper), c.interface);
    return contact;
}

}  // namespace tricontact::fem
