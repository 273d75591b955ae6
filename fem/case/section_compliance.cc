#include "fem/case/section_compliance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "contact/base/error.h"
#include "contact/half_space_scales.h"
#include "contact/load_path.h"
#include "contact/solvers/contact_region.h"
#include "contact/solvers/normal_solver.h"
#include "fem/case/mesh_choice.h"
#include "fem/memory.h"
#include "fem/settings.h"

namespace tricontact::fem {

using contact::Case;
using contact::ModelKind;
using planar::Solid;

namespace {

constexpr double probing_margin = 1.15;
constexpr double room_growth = 1.5;  // of the room that is probed
constexpr int probing_elements = 8;  // across the half width that is expected
constexpr int most_probes = 20;
constexpr int fewest_elements = 24;
constexpr int fewest_attracted = 60;  // as a contact lets go its radius is about half of it

/// Elements across the contact whose force errs by no more: spheres and cylinders on meshes of 8 to
/// 60 of them err by less than .16/n^2 (tests/verification/fem/planar). No fewer than 24, since
/// they cost nothing.
int elements_for(double accuracy) {
    return std::max(fewest_elements, static_cast<int>(std::ceil(.4 / std::sqrt(accuracy))));
}

/// The radius is 0 where the contact reaches the edge of the points; of surfaces that attract each
/// other they are pressed as far as they do.
SectionProbe pressed_on(const Case& c, const contact::Compliance& compliance) {
    contact::NormalControl hardest = contact::press_step(c).normal;
    hardest.value *= contact::crest_factor(c);
    const contact::ContactPoints& points = compliance.points();
    const auto height = heights_over(points, *c.make_indenter(), {0, 0});
    const auto carries =
        c.adhesion ? attracted_by(c, compliance, height, hardest)
                   : contact::NormalSolver(compliance, 1e-6).solve(height, hardest).pressure;
    if (reaches_edge(points, carries)) return {};
    SectionProbe probe{c.adhesion ? counted_radius(points, carries)
                                  : contact_radius(points, carries, {0, 0})};
    for (std::size_t i = 0; i < carries.size(); ++i) probe.force += points.area[i] * carries[i];
    return probe;
}

}  // namespace

void refuse_too_large(const Case& c, double half_width) {
    throw contact::InputError(fmt::format(
        "load: the contact, more than {:.4g} m to either side, is too large for the indenter's "
        "body{}; reduce the load",
        half_width, c.has_hole() ? ", which the hole closes around" : ""));
}

/// Before a mesh is made that takes hours: by nested dissection the factor of n unknowns in a plane
/// has some 8 n log2(n) entries, and below the patch alone are eight unknowns an element.
void require_memory_for(const planar::Sizes& sizes) {
    const double unknowns = 8. * sizes.n * sizes.n_deep;
    const double needed = 64 * unknowns * std::log2(unknowns), available = available_bytes();
    if (needed > available)
        throw contact::InputError(fmt::format(
            "fem.size: elements of {:.4g} m, {} across the patch, need {:.1f} GB of memory, {:.1f} "
            "GB are there; choose a larger fem.size",
            sizes.size, sizes.n, needed / 1e9, available / 1e9));
}

planar::Sizes fitting_sizes(const Case& c, const SectionPatch& patch) {
    const planar::Sizes sizes = sizes_of(c, patch);
    require_memory_for(sizes);
    if (sizes.patch() > widest_patch(c) * (1 + 1e-9)) refuse_too_large(c, sizes.patch());
    return sizes;
}

planar::PairOptions pair_options(const Case& c, Solid solid, bool is_whole_face) {
    planar::PairOptions options;
    options.conforming = c.has_hole();
    options.with_friction = c.contact.coupling;
    options.radius = c.indenter.radius;
    const bool line = solid == Solid::plane_strain;
    options.length = line ? c.indenter.length : 1;
    options.local_ratio =
        line ? 1 : c.materials().effective_modulus() / c.materials().effective_shear_modulus();
    options.is_whole_face = is_whole_face;
    options.first_presses = c.indenter.body.has_value();
    return options;
}

std::unique_ptr<planar::SectionCompliance> section_compliance(const Case& c, Solid solid,
                                                              const SectionPatch& patch,
                                                              SectionPoints points) {
    const std::vector<planar::CondensedSection> bodies =
        bodies_of(c, solid, fitting_sizes(c, patch));
    const auto grid = [&] {
        if (points == SectionPoints::elements) return planar::elements_of(bodies);
        return c.adhesion ? planar::rings_on_nodes(bodies) : grid_between(bodies);
    };
    return pair_compliance(bodies, grid(), pair_options(c, solid, patch.is_whole_face));
}

SectionProbe probed_section(const Case& c, Solid solid) {
    double room = probing_margin * contact::half_space_scales(c).contact_radius;
    const bool sharp = c.indenter.shape == Case::Shape::flat_punch;
    const double widest = sharp ? c.indenter.flat_radius : .99 * widest_patch(c);
    for (int k = 0; k < most_probes; ++k, room *= room_growth) {
        room = std::min(room, widest);
        const auto compliance =
            section_compliance(c, solid, section_patch(c, room, room / probing_elements));
        const SectionProbe probe = pressed_on(c, *compliance);
        if (probe.radius == 0) {
            if (room >= widest) refuse_too_large(c, room);
            continue;
        }
        if (probe.radius > room / 4) return probe;
        room = 2 * probe.radius / room_growth;
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
