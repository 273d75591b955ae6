#include "fem/case/section_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/base/error.h"
#include "contact/bodies/upper_plate.h"
#include "contact/half_space_scales.h"
#include "contact/load_path.h"
#include "contact/relaxing_case.h"
#include "contact/solvers/contact_region.h"
#include "contact/surface_model.h"
#include "fem/case/conforming_friction.h"
#include "fem/case/conforming_model.h"
#include "fem/case/mesh_choice.h"
#include "fem/case/model_of_revolution.h"
#include "fem/case/plates_model.h"
#include "fem/case/section_bodies.h"
#include "fem/planar/pair.h"
#include "fem/settings.h"

// From a case to a model of a section, as fem/case/model.cc to one in three dimensions:
//
//   radius of the contact (probed) --> size of elements --> patch = contact + path + margin
//       --> sections of both bodies --> condensed --> pair --> Substrate --> SurfaceModel
//
// Sections are small: nothing is kept between runs.

namespace tricontact::fem {

using contact::Case;
using contact::ModelKind;
using planar::Solid;

namespace {

constexpr double section_margin = 1.15;
constexpr double corner = 1.4143;       // a square of revolution's surface is shown, to its corners
constexpr double section_growth = 1.5;  // of the room when the contact has reached its edge
constexpr int probing_elements = 8;     // across the half width that is expected
constexpr int most_probes = 20;
constexpr int fewest_elements = 24;
constexpr int fewest_attracted = 60;  // as a contact lets go its radius is about half of it

/// Elements across the contact whose force errs by no more: spheres and cylinders on meshes of 8 to
/// 60 of them err by less than .16/n^2 (tests/verification/fem/planar). No fewer than 24, since
/// they cost nothing.
int elements_for(double accuracy) {
    return std::max(fewest_elements, static_cast<int>(std::ceil(.4 / std::sqrt(accuracy))));
}

[[noreturn]] void refuse_too_large(const Case& c, double half_width) {
    throw contact::InputError(fmt::format(
        "load: the contact, more than {:.4g} m to either side, is too large for the indenter's "
        "body{}; reduce the load",
        half_width, c.has_hole() ? ", which the hole closes around" : ""));
}

planar::Sizes fitting_sizes(const Case& c, const Patch& patch) {
    const planar::Sizes sizes = sizes_of(c, patch);
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

std::unique_ptr<planar::SectionCompliance> compliance_of(const Case& c, Solid solid,
                                                         const Patch& patch) {
    const std::vector<planar::CondensedSection> bodies =
        bodies_of(c, solid, fitting_sizes(c, patch));
    return pair_compliance(bodies,
                           c.adhesion ? planar::rings_on_nodes(bodies) : grid_between(bodies),
                           pair_options(c, solid, patch.is_whole_face));
}

/// Half width or radius of a contact [m], and its force [N].
struct Probe {
    double radius = 0, force = 0;
};

/// The radius is 0 where the contact reaches the edge of the points; of surfaces that attract each
/// other they are pressed as far as they do.
Probe pressed_on(const Case& c, const contact::Compliance& compliance) {
    contact::NormalControl hardest = contact::press_step(c).normal;
    hardest.value *= contact::crest_factor(c);
    const contact::ContactPoints& points = compliance.points();
    const auto height = heights_over(points, *c.make_indenter(), {0, 0});
    const auto carries =
        c.adhesion ? attracted_by(c, compliance, height, hardest)
                   : contact::NormalSolver(compliance, 1e-6).solve(height, hardest).pressure;
    if (reaches_edge(points, carries)) return {};
    Probe probe{c.adhesion ? counted_radius(points, carries)
                           : contact_radius(points, carries, {0, 0})};
    for (std::size_t i = 0; i < carries.size(); ++i) probe.force += points.area[i] * carries[i];
    return probe;
}

/// The contact under the case's hardest load, on coarse elements.
Probe probed(const Case& c, Solid solid) {
    double room = section_margin * contact::half_space_scales(c).contact_radius;
    const bool sharp = c.indenter.shape == Case::Shape::flat_punch;
    const double widest = sharp ? c.indenter.flat_radius : .99 * widest_patch(c);
    for (int k = 0; k < most_probes; ++k, room *= section_growth) {
        room = std::min(room, widest);
        const auto compliance = compliance_of(c, solid, patch_of(c, room, room / probing_elements));
        const Probe probe = pressed_on(c, *compliance);
        if (probe.radius == 0) {
            if (room >= widest) refuse_too_large(c, room);
            continue;
        }
        if (probe.radius > room / 4) return probe;
        room = 2 * probe.radius / section_growth;
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

/// Of elements, if the case does not give it, for a contact of this radius [m].
double chosen_size(const Case& c, double radius) {
    const auto& accuracy = c.of<Settings>().accuracy;
    const int n = accuracy ? elements_for(*accuracy) : fewest_elements;
    return radius / (c.adhesion ? std::max(n, fewest_attracted) : n);
}

/// Of both contacts of a body between unlike plates the narrower and the wider one [m].
struct Radii {
    double least, most;
};
Radii probed_radii(const Case& c, Solid solid) {
    const Probe lower = probed(c, solid);
    if (!c.kept.find<contact::UpperPlate>()) return {lower.radius, lower.radius};
    const double upper = probed(seen_from_above(c, lower.force), solid).radius;
    return {std::min(lower.radius, upper), std::max(lower.radius, upper)};
}

PlatesModel::Compliances between_plates(const Case& c, Solid solid, const Patch& patch) {
    const OpposedSections all =
        opposed_sections(c, seen_from_above(c, 1), solid, fitting_sizes(c, patch));
    const auto of = [&](const std::vector<planar::CondensedSection>& bodies) {
        return pair_compliance(bodies, planar::points_on_nodes(bodies),
                               pair_options(c, solid, patch.is_whole_face));
    };
    return {of(all.lower), of(all.upper), of(all.across)};
}

std::unique_ptr<contact::Model> make_plates_model(const ModelKind& kind, const Case& c,
                                                  const Patch& patch) {
    const Solid solid = solid_of(kind);
    PlatesModel::Setup setup{kind.name, c.make_indenter(), c.friction.law(),
                             c.of<Settings>().tolerance, c.contact};
    if (solid == Solid::of_revolution)
        setup.shear_modulus = c.materials().effective_shear_modulus();
    setup.compliances = [=](double growth) {
        return between_plates(c, solid, {growth * patch.half_width, patch.size});
    };
    setup.growth = section_growth;
    return std::make_unique<PlatesModel>(std::move(setup));
}

}  // namespace

double section_size(const ModelKind& kind, const Case& c) {
    require_bodies(c, kind);
    const Settings& settings = c.of<Settings>();
    return settings.size ? *settings.size : chosen_size(c, probed_radii(c, solid_of(kind)).least);
}

std::unique_ptr<contact::Model> make_section_model(const ModelKind& kind, const Case& c,
                                                   const Say& say) {
    require_bodies(c, kind);
    const Solid solid = solid_of(kind);
    const std::string name = kind.name;
    const auto [radius, widest] = probed_radii(c, solid);
    const Settings& settings = c.of<Settings>();
    const double size = settings.size ? *settings.size : chosen_size(c, radius);
    if (size > radius / 2)
        throw contact::InputError(fmt::format(
            "fem.size: {}: fewer than 2 elements across the contact's {:.4g} m; reduce it", name,
            radius));
    const double margin = solid == Solid::of_revolution ? corner * section_margin : section_margin;
    const double ring = c.adhesion ? contact::points_without_range * size : 0;
    const double half = std::min(margin * (widest + ring) + contact::path_reach(c, radius)[0],
                                 widest_patch(c) - size);
    if (say && !settings.size)
        say(fmt::format("{}: elements of {:.4g} mm, {:.3g} across the contact", name, 1e3 * size,
                        radius / size));
    if (c.kept.find<contact::UpperPlate>()) return make_plates_model(kind, c, {half, size});
    const auto substrate = [=](const Case& of, double room) {
        const Patch patch = patch_of(of, room, size);
        const contact::ComplianceOf elastic = [=](const Case& other) {
            return compliance_of(other, solid, patch);
        };
        auto relaxed = contact::relaxes_as_one(of) ? elastic(of) : nullptr;
        return contact::make_substrate(of, false, std::move(relaxed), elastic);
    };
    std::shared_ptr<const contact::FrictionLaw> friction = c.friction.law();
    std::shared_ptr<const ConformingFriction> conforming;
    if (c.has_hole() && c.contact.coupling)
        friction = conforming =
            std::make_shared<const ConformingFriction>(friction, c.indenter.radius);
    auto model =
        std::make_unique<contact::SurfaceModel>(name, *substrate(c, half), c.make_indenter(),
                                                std::move(friction), settings.tolerance, c.contact);
    model->set_larger_grid(
        [=, room = half](const contact::ContactAtEdge&) mutable
        -> std::unique_ptr<contact::Substrate> { return substrate(c, room *= section_growth); });
    if (c.has_hole())
        return std::make_unique<ConformingModel>(std::move(model), c.indenter.radius,
                                                 std::move(conforming));
    if (solid == Solid::plane_strain) return model;
    if (c.adhesion) model->attract(c.adhesion->attraction(), c.materials().effective_modulus());
    return std::make_unique<ModelOfRevolution>(std::move(model),
                                               c.materials().effective_shear_modulus());
}

}  // namespace tricontact::fem
