#include "fem/case/section_model.h"

#include <fmt/format.h>

#include <algorithm>

#include "contact/base/error.h"
#include "contact/load_path.h"
#include "contact/relaxing_case.h"
#include "contact/surface_model.h"
#include "fem/case/conforming_friction.h"
#include "fem/case/conforming_model.h"
#include "fem/case/model_of_revolution.h"
#include "fem/case/section_bodies.h"
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

}  // namespace

double section_size(const ModelKind& kind, const Case& c) {
    require_bodies(c, kind);
    const Settings& settings = c.of<Settings>();
    return settings.size ? *settings.size : chosen_size(c, probed_radius(c, solid_of(kind)));
}

std::unique_ptr<contact::Model> make_section_model(const ModelKind& kind, const Case& c,
                                                   const Say& say) {
    require_bodies(c, kind);
    const Solid solid = solid_of(kind);
    const std::string name = kind.name;
    const double radius = probed_radius(c, solid);
    const Settings& settings = c.of<Settings>();
    const double size = settings.size ? *settings.size : chosen_size(c, radius);
    if (size > radius / 2)
        throw contact::InputError(fmt::format(
            "fem.size: {}: fewer than 2 elements across the contact's {:.4g} m; reduce it", name,
            radius));
    const double margin = solid == Solid::of_revolution ? corner * section_margin : section_margin;
    const double ring = c.adhesion ? contact::points_without_range * size : 0;
    const double half = std::min(margin * (radius + ring) + contact::path_reach(c, radius)[0],
                                 widest_patch(c) - size);
    if (say && !settings.size)
        say(fmt::format("{}: elements of {:.4g} mm, {:.3g} across the contact", name, 1e3 * size,
                        radius / size));
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
