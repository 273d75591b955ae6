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
using planar::Solid;

namespace {

constexpr double section_margin = 1.15;
constexpr double section_growth = 1.5;  // of the room when the contact has reached its edge
constexpr int probing_elements = 8;     // across the half width that is expected
constexpr int most_probes = 20;
constexpr int fewest_elements = 6;
constexpr double section_accuracy = 3e-4;  // of the force, unless fem.accuracy is given
constexpr double far_side = 20;            // of the layer's side from the patch, in thicknesses

/// Elements across the contact whose force errs by no more: spheres and cylinders on meshes of 8 to
/// 60 of them err by less than .16/n^2 (tests/verification/fem/planar).
int elements_for(double accuracy) {
    return std::max(fewest_elements, static_cast<int>(std::ceil(.4 / std::sqrt(accuracy))));
}

struct Patch {
    double half_width, size;
};

planar::Sizes sizes_of(const Case& c, const Patch& patch) {
    const int n = std::max(2, static_cast<int>(std::ceil(patch.half_width / patch.size - 1e-9)));
    // Growth of fem.growth, which is meant for hexahedra, is too coarse for what costs nothing.
    const double growth = 1 + (c.of<Settings>().growth - 1) / 3;
    const double thickness = *c.layer.thickness;
    const int deep = std::max(1, std::min(n / 6, static_cast<int>(thickness / patch.size)));
    return {n, patch.size, growth, deep};
}

planar::CondensedBody layer_of(const Case& c, Solid solid, const Patch& patch) {
    const planar::Sizes sizes = sizes_of(c, patch);
    const double thickness = *c.layer.thickness;
    planar::BodyProblem problem;
    problem.mesh = layer_section(sizes, sizes.patch() + far_side * thickness, thickness);
    if (solid == Solid::plane_strain) problem.mesh = with_mirror_image(problem.mesh);
    problem.solid = solid;
    problem.material = c.substrate;
    problem.support = c.layer.base == Case::Base::frictionless ? planar::Support::sliding
                                                               : planar::Support::bonded;
    return condense(problem);
}

std::unique_ptr<DenseCompliance> compliance_of(const Case& c, Solid solid, const Patch& patch) {
    const std::vector<planar::CondensedBody> bodies{layer_of(c, solid, patch)};
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
    for (int k = 0; k < most_probes; ++k, room *= section_growth) {
        const auto compliance = compliance_of(c, solid, {room, room / probing_elements});
        const auto solution = press(c, *compliance);
        const contact::ContactPoints& points = compliance->points();
        if (reaches_edge(points, solution.pressure)) continue;
        const double radius = contact_radius(points, solution.pressure, {0, 0});
        if (radius > room / 4) return radius;
        room = 2 * radius / section_growth;
    }
    throw contact::NotConverged("the radius of the contact was not found on coarse elements");
}

void require(const Case& c, const std::string& name, Solid solid) {
    const auto refuse = [&](const std::string& what) {
        throw contact::InputError(name + ": " + what);
    };
    if (!c.layer.thickness) refuse("a section needs substrate.thickness");
    if (c.layer.base == Case::Base::half_space || !c.layer.lower.empty())
        refuse("one layer on a rigid ground is meshed; take fem or bem-layer for more");
    if (c.of<Settings>().mesh) refuse("has meshes of its own; leave out fem.mesh");
    if (c.of<Settings>().sides == Sides::fixed)
        refuse("the layer's sides are far away and free; leave out fem.sides");
    if (c.law != Case::Law::linear) refuse("strains are small; take fem at finite strains");
    if (c.interface.is_elastic()) refuse("knows rigid interfaces alone; leave out [interface]");
    if (solid == Solid::plane_strain) {
        if (!c.is_line_contact())
            refuse("plane strain is for indenter.shape = \"cylinder\"; take fem-axisymmetric");
        if (c.layer.base == Case::Base::frictionless)
            refuse("nothing holds a layer that glides; take base = \"bonded\"");
        return;
    }
    if (c.indenter.roughness) refuse("a rough body is none of revolution; take bem-layer");
    c.make_axisymmetric_indenter();  // throws for other bodies
    if (c.friction.map) refuse("friction that varies along x is none of revolution; take fem");
    if (c.rolling || c.tractive_rolling || c.prescribed_path)
        refuse("a section of revolution is pressed where it is; leave out rolling, or take fem");
    if (c.load.tangential_force.value_or(0) != 0 || c.load.tangential_ratio.value_or(0) != 0 ||
        c.load.is_by_limit())
        refuse("a section of revolution has no tangential load; leave it out, or take fem");
}

}  // namespace

double section_size(Solid solid, const Case& c) {
    const Settings& settings = c.of<Settings>();
    if (settings.size) return *settings.size;
    return probed_radius(c, solid) / elements_for(settings.accuracy.value_or(section_accuracy));
}

std::unique_ptr<contact::Model> make_section_model(const std::string& name, Solid solid,
                                                   const Case& c, const Say& say) {
    require(c, name, solid);
    const double radius = probed_radius(c, solid);
    const double size = section_size(solid, c);
    if (size > radius / 2)
        throw contact::InputError(fmt::format(
            "fem.size: {}: fewer than 2 elements across the contact's {:.4g} m; reduce it", name,
            radius));
    const double half = section_margin * radius + contact::path_reach(c, radius)[0];
    if (say && !c.of<Settings>().size)
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
    auto model = std::make_unique<contact::SurfaceModel>(name, *substrate(c, half),
                                                         c.make_indenter(), c.friction.law(),
                                                         c.of<Settings>().tolerance, c.contact);
    model->set_larger_grid(
        [=, room = half](const contact::ContactAtEdge&) mutable
        -> std::unique_ptr<contact::Substrate> { return substrate(c, room *= section_growth); });
    if (solid == Solid::plane_strain) return model;
    return std::make_unique<ModelOfRevolution>(std::move(model));
}

}  // namespace tricontact::fem
