#include "fem/case/mesh_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>

#include "contact/models/model_kind.h"
#include "contact/solvers/adhesive_normal.h"
#include "contact/solvers/contact_region.h"
#include "contact/solvers/normal_solver.h"
#include "contact/surface_model.h"
#include "fem/case/indenter_body.h"
#include "fem/settings.h"
#include "meshes/layer_mesh.h"

// How fine, and how far: docs/explanation/models/fem.md, "Mesh". The patch has to hold the contact
// along its path before anything is known of the contact on the layer, so it is probed:
//
//   half-space radius --> coarse mesh, 3 elements in it --> pressed --> radius on the layer
//                             ^                                |
//                             +-- larger patch, if the edge ---+
//                                 is reached
//
// With `fem.accuracy` two coarse meshes, 4 and 5.66 elements in the radius, give the error of the
// second by extrapolation with the order 1.5 (`assumed_order`), which is less than observed: the
// size is on the safe side. Memory decides last: the symbolic factor predicts what condensing
// takes, and an error names the size that fits.

namespace tricontact::fem {

using contact::Case;
using contact::Vector2;

namespace {

constexpr double probe_elements = 3;   // in the guessed contact radius
constexpr double probe_margin = 1.35;  // of the patch over the guess
constexpr double enlargement = 1.4;
constexpr double probe_tolerance = 1e-4;
constexpr double probe_ring = 1;    // elements that a tension without a range acts over
constexpr double end_fineness = 4;  // elements of a roller's ends in one of the patch

/// Half sides of the region that the contact centre sweeps [m].
Vector2 path_extent(const Case& c, double contact_radius) {
    const Vector2 reach = contact::path_reach(c, contact_radius);
    return {reach[0], contact::is_mirror_symmetric(c) ? 0 : reach[1]};
}

std::vector<double> carried_by(const Case& c, const contact::Compliance& compliance,
                               const std::vector<double>& height,
                               const contact::NormalControl& control) {
    if (c.adhesion) return attracted_by(c, compliance, height, control);
    return contact::NormalSolver(compliance, probe_tolerance).solve(height, control).pressure;
}

/// Largest distance of a point in contact, or held by attraction, from the centre [m]; 0 when the
/// edge is reached.
double pressed_radius(const Case& c, const contact::NormalControl& control,
                      const contact::Compliance& compliance) {
    const contact::ContactPoints& points = compliance.points();
    const auto height = heights_over(points, *c.make_indenter(), {0, 0});
    const auto carries = carried_by(c, compliance, height, control);
    if (reaches_edge(points, carries)) return 0;
    double radius = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (carries[i] > 0)
            radius =
                std::max(radius, std::hypot(points.x[i], c.is_cylindrical() ? 0 : points.y[i]));
    return radius;
}

double whole_elements(double length, double size) {
    return size * std::max(1., std::ceil(length / size - 1e-9));
}

/// Along y, of a body that ends there.
void lay_along(const Case& c, double reach, meshes::LayerMeshSpec& spec) {
    const double half_length = c.indenter.length / 2;
    spec.plane_strain = c.is_line_contact();
    spec.half_y = spec.plane_strain ? half_length
                  : c.layer.depth   ? *c.layer.depth / 2
                                    : half_length + reach;
    spec.patch_y = std::min(half_length, spec.half_y);
    if (spec.plane_strain) return;
    const double rounded = c.indenter.chamfer - (half_length - spec.patch_y);
    spec.ends = meshes::LayerMeshSpec::Ends{.size = spec.size / end_fineness,
                                            .length = std::max(0., rounded)};
}

constexpr double coarse_elements = 4, fine_elements = 5.657;  // in the contact radius
constexpr double assumed_order = 1.5;
constexpr double order_of_blocks = 1;  // by their sharp edges

/// A roller without its ends, where sharp ones have no finite pressure.
Case middle_of(const Case& c) {
    Case middle = c;
    if (!c.is_cylindrical()) return middle;
    middle.indenter.shape = Case::Shape::cylinder;
    middle.layer.depth.reset();
    return middle;
}

/// What the accuracy is about, on a mesh of elements of `size`.
std::array<double, 4> pressed_values(const Case& c, double size, double radius,
                                     LayerCondenser& condenser) {
    Case still = middle_of(c);
    still.rolling.reset();
    still.prescribed_path.reset();
    contact::SurfaceModel model(
        contact::models::fem, condenser.make_contact(spec_for(still, size, radius)),
        still.make_indenter(), c.friction.law(), c.of<Settings>().tolerance, c.contact);
    contact::LoadStep press = contact::press_step(c);
    press.friction = false;
    model.advance(press);
    const contact::Scales s = model.scales();
    // The pressure under a conical tip, and under a sharp edge, has no limit.
    const bool has_peak = !contact::has_conical_tip(c) && !is_block(c);
    const double tip = has_peak ? s.peak_pressure : 1;
    return {s.indentation, s.normal_force, tip, s.unit_shift};
}

/// Short over long half axis of the case's contact on the half-space, 1 of a circle.
double narrowness(const Case& c) {
    if (c.is_cylindrical()) return 1;
    const Vector2 half = half_space_scales(c).half_widths;
    return std::min(half[0], half[1]) / std::max(half[0], half[1]);
}

/// The same with elements of another size.
meshes::LayerMeshSpec resized(meshes::LayerMeshSpec spec, double size) {
    const bool square = !spec.plane_strain && !spec.ends;
    spec.patch_x = whole_elements(spec.patch_x, size);
    if (square) spec.patch_y = whole_elements(spec.patch_y, size);
    if (spec.ends) spec.ends->size *= size / spec.size;
    spec.size = size;
    return spec;
}

/// Of the larger of the case's bodies on the mesh of `spec`, and the compliance of the other.
double predicted_bytes_of(const Case& c, const meshes::LayerMeshSpec& spec) {
    const auto of_layer = [&] { return predicted_bytes(problem_of(c, make_layer_mesh(spec))); };
    if (!c.indenter.body) return of_layer();
    const double of_indenter = predicted_bytes(indenter_problem(c, spec));
    if (c.has_rigid_substrate) return of_indenter;
    const double n_x = 4 * spec.patch_x / spec.size + 1,
                 n_y = (spec.half_model ? 2 : 4) * spec.patch_y / spec.size + 1;
    return std::max(of_indenter, of_layer()) + 8 * std::pow(3 * n_x * n_y, 2);
}

/// The least size found whose condensation is predicted to fit [m]; 0: none was.
double size_that_fits(const Case& c, meshes::LayerMeshSpec spec, const MemoryShort& shortage) {
    // Factor and dense compliance of a layer grow with about h^-2.5.
    double ratio = shortage.needed_bytes > 0 ? shortage.needed_bytes / shortage.available_bytes : 4;
    const double first = spec.size;
    for (int attempt = 0; attempt < 4; ++attempt) {
        spec = resized(spec, std::min(1.05 * spec.size * std::pow(ratio, 0.4), 16 * first));
        try {
            ratio = (predicted_bytes_of(c, spec) + blas_buffer_bytes()) / shortage.available_bytes;
        } catch (const std::bad_alloc&) {
            ratio = 4;
        }
        if (ratio < 1) return spec.size;
    }
    return 0;
}

}  // namespace

// Sides are `far_sides` thicknesses away unless the case gives them; what a contact larger than
// that needs is half of it beyond the patch. Patches end on whole elements, since the mesh inside
// them is regular; that of a block is its face.
meshes::LayerMeshSpec spec_for(const Case& c, double size, double contact_radius, double shift) {
    const Vector2 extent = path_extent(c, contact_radius);
    meshes::LayerMeshSpec spec;
    spec.size = size;
    spec.growth = c.of<Settings>().growth;
    // Below a body on a rigid plane nothing is meshed but the patch.
    spec.thickness = c.has_rigid_substrate ? size : *c.layer.thickness;
    spec.lower_thickness = c.layer.lower.empty() ? 0 : c.layer.lower.front().thickness;
    spec.half_model = contact::is_mirror_symmetric(c);
    spec.patch_x = whole_elements(contact_radius + extent[0] + shift, size);
    const double total = spec.thickness + spec.lower_thickness;
    const double reach = c.has_rigid_substrate ? 0 : far_sides(c) * total;
    auto half_side = [&](const std::optional<double>& given, double patch) {
        return given ? *given / 2 : std::max(reach, patch + reach / 2);
    };
    spec.half_x = half_side(c.layer.width, spec.patch_x);
    if (is_block(c)) {
        const double half = c.indenter.flat_radius;
        spec.size = half / std::max(2., std::ceil(half / size - 1e-9));
        spec.patch_x = half;
        spec.half_x = half_side(c.layer.width, half);
    }
    if (c.is_cylindrical() || is_block(c)) {
        lay_along(c, reach, spec);
    } else {
        spec.patch_y = whole_elements(contact_radius + extent[1], size);
        spec.half_y = half_side(c.layer.depth, spec.patch_y);
    }
    return spec;
}

double probe_radius(const Case& c, const contact::NormalControl& control,
                    LayerCondenser& condenser) {
    if (is_block(c)) return c.indenter.flat_radius;
    Case still = c;  // pressed only
    still.rolling.reset();
    still.prescribed_path.reset();
    const Vector2 half = half_space_scales(c).half_widths;
    // The patch of a cylinder or roller is as long as it: only the width along x is asked for.
    const double widest = c.is_cylindrical() ? half[0] : std::max(half[0], half[1]);
    double guess = widest * std::sqrt(control.value / contact::press_step(c).normal.value);
    for (;; guess *= enlargement) {
        const double size = narrowness(c) * guess / probe_elements;
        const auto compliance = condenser.make_contact(spec_for(still, size, probe_margin * guess));
        const double radius = pressed_radius(c, control, *compliance);
        if (radius > 0) return radius + size / 2;
    }
}

// Of a value v(h) = v_0 + c h^p, p = `assumed_order`, the error on the fine mesh is the difference
// of both over (coarse/fine)^p - 1 (Richardson), and the size that has the accuracy follows from
// h^p. The worst of indentation or force, peak pressure and unit shift decides. Never coarser than
// the fine mesh: what was not computed is not known.
double size_for_accuracy(const Case& c, double radius, LayerCondenser& condenser) {
    const double narrow = narrowness(c) * radius;
    const double coarse = narrow / coarse_elements, fine = narrow / fine_elements;
    const auto at_coarse = pressed_values(c, coarse, radius, condenser);
    const auto at_fine = pressed_values(c, fine, radius, condenser);
    const double order = is_block(c) ? order_of_blocks : assumed_order;
    const double rest = 1 / (std::pow(coarse / fine, order) - 1);
    double error = 0;
    for (std::size_t k = 0; k < at_fine.size(); ++k)
        error = std::max(error, rest * std::abs(at_coarse[k] / at_fine[k] - 1));
    const double factor = std::pow(c.of<Settings>().accuracy.value_or(0.01) / error, 1 / order);
    return fine * std::min(1., factor);
}

namespace {

template <class Make>
auto made_or_size_named(const Case& c, const meshes::LayerMeshSpec& spec, const Make& make) {
    // Then another solver takes over.
    if (c.of<Settings>().solver == Solver::automatic && not_iterative(c).empty()) return make();
    try {
        return make();
    } catch (const MemoryShort& shortage) {
        const double size = size_that_fits(c, spec, shortage);
        throw contact::InputError(fmt::format(
            "fem: {}{}", shortage.what(),
            size > 0 ? fmt::format("; fem.size = \"{:.3g} mm\" would fit", 1e3 * size) : ""));
    }
}

}  // namespace

std::vector<double> attracted_by(const Case& c, const contact::Compliance& compliance,
                                 const std::vector<double>& height,
                                 const contact::NormalControl& control) {
    const double modulus = c.materials().effective_modulus();
    contact::AttractionLaw law = c.adhesion->attraction();
    contact::Attraction finite{
        .strength = 0, .distance = law.distance, .decays = law.decays, .is_short_ranged = false};
    if (law.distance > 0) finite.strength = law.work / law.distance;
    const auto settled = [&](double ring) {
        return contact::AdhesiveNormal(contact::models::fem, compliance,
                                       attraction_on(compliance.points(), law, modulus, ring),
                                       probe_tolerance)
            .settle(height, control, {});
    };
    contact::NormalSolution s;
    try {
        s = settled(probe_ring);
    } catch (const contact::InputError&) {
        law.distance = 0;
        s = settled(contact::least_points_of_range);
    }
    for (std::size_t i = 0; i < s.tension.size(); ++i) {
        const double gap = s.displacement[i] + height[i] - s.indentation;
        s.tension[i] = std::max(
            {s.tension[i], s.pressure[i], finite.strength > 0 ? finite.tension(gap, 0) : 0});
    }
    return s.tension;
}

std::unique_ptr<contact::Compliance> make_fitting(const Case& c, const meshes::LayerMeshSpec& spec,
                                                  LayerCondenser& condenser) {
    return made_or_size_named(c, spec, [&] { return condenser.make_contact(spec); });
}

std::unique_ptr<CondensedCompliance> make_fitting_layer(const Case& c,
                                                        const meshes::LayerMeshSpec& spec,
                                                        LayerCondenser& condenser) {
    return made_or_size_named(c, spec, [&] { return condenser.make(make_layer_mesh(spec)); });
}

}  // namespace tricontact::fem
