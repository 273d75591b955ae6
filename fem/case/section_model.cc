#include "fem/case/section_model.h"

#include <fmt/format.h>

#include <algorithm>

#include "contact/base/error.h"
#include "contact/bodies/upper_plate.h"
#include "contact/load_path.h"
#include "contact/relaxing_case.h"
#include "contact/surface_model.h"
#include "fem/case/conforming_friction.h"
#include "fem/case/conforming_model.h"
#include "fem/case/model_of_revolution.h"
#include "fem/case/plates_model.h"
#include "fem/case/section_compliance.h"
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
/// Of both contacts of a body between unlike plates the narrower and the wider one [m].
struct Radii {
    double least, most;
};
Radii probed_radii(const Case& c, Solid solid) {
    const SectionProbe lower = probed_section(c, solid);
    if (!c.kept.find<contact::UpperPlate>()) return {lower.radius, lower.radius};
    const double upper = probed_section(seen_from_above(c, lower.force), solid).radius;
    return {std::min(lower.radius, upper), std::max(lower.radius, upper)};
}

PlatesModel::Compliances between_plates(const Case& c, Solid solid, const SectionPatch& patch) {
    const OpposedSections all =
        opposed_sections(c, seen_from_above(c, 1), solid, fitting_sizes(c, patch));
    const auto of = [&](const std::vector<planar::CondensedSection>& bodies) {
        return pair_compliance(bodies, planar::points_on_nodes(bodies),
                               pair_options(c, solid, patch.is_whole_face));
    };
    return {of(all.lower), of(all.upper), of(all.across)};
}

std::unique_ptr<contact::Model> make_plates_model(const ModelKind& kind, const Case& c,
                                                  const SectionPatch& patch) {
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
        say(fmt::format(
            "{}: elements of {:.4g} mm, {:.3g} across the contact{}", name, 1e3 * size,
            radius / size,
            widest > 2 * radius
                ? fmt::format(", {:.3g} across that with the other plate", widest / size)
                : ""));
    if (c.kept.find<contact::UpperPlate>()) return make_plates_model(kind, c, {half, size});
    const auto substrate = [=](const Case& of, double room) {
        const SectionPatch patch = section_patch(of, room, size);
        const contact::ComplianceOf elastic = [=](const Case& other) {
            return section_compliance(other, solid, patch);
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
