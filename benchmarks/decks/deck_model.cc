#include "benchmarks/decks/deck_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "benchmarks/decks/graded_line.h"
#include "benchmarks/decks/ring_mesh.h"
#include "contact/base/error.h"
#include "contact/bodies/upper_plate.h"
#include "contact/rig_stiffness.h"
#include "contact/wearing_contact.h"

namespace tricontact::benchmarks {

namespace {

constexpr double to_mm = 1e3, to_mpa = 1e-6;
// Blocks of layers reach this many thicknesses to the sides; half models less, they are costly.
constexpr double layer_sides = 6, half_model_sides = 3.25;
// Blocks of half-spaces, in a. A bonded base at the distance H from the load lowers the depth under
// a force by about 0.6 a/H of it.
constexpr double half_space_size = 1000, half_space_half_model = 30;
// In a: nodes of the coarsest mesh, of four elements and of a half model's three.
constexpr double contact_reach = 1.5, half_model_reach = 5. / 3, indenter_reach = 2;

[[noreturn]] void refuse(const std::string& what, const std::string& help) {
    throw contact::InputError("deck: " + what + "; " + help);
}

void check_case(const contact::Case& c) {
    const std::string own = "compare results of an input of your own instead, or run tricontact";
    if (c.kept.find<contact::Wear>()) contact::refuse_wear(c);
    if (c.rolling || c.tractive_rolling) refuse("no deck has rolling contact", own);
    if (c.relaxation) refuse("no deck has a relaxing substrate", own);
    if (c.law != contact::Case::Law::linear) refuse("no deck has finite strains", own);
    if (c.of<contact::RigStiffness>().yields())
        refuse("no deck has a rig in series with the contact", own);
    if (c.interface.is_elastic())
        refuse("no deck has springs between the surfaces, but for its own penalty", own);
    if (c.has_bulk_stress()) refuse("no deck has a bulk stress", own);
    if (c.adhesion) refuse("no deck has surfaces that attract each other", own);
    if (c.indenter.roughness) refuse("no deck has a rough indenter", own);
    if (c.period) refuse("no deck has a periodic contact", own);
    if (!c.layer.lower.empty() || c.layer.ground) refuse("no deck has several layers", own);
    if (c.layer.thickness && c.layer.base == contact::Case::Base::frictionless)
        refuse("no deck has a layer on a frictionless base", own);
}

// The profile as FreeFem++ and Python read it, "^" of powers as FreeFem++ has it.
std::string gap_formula(const contact::IndenterData& data, const DeckModel& model) {
    using Shape = contact::IndenterData::Shape;
    const double radius = data.radius * to_mm;
    switch (data.shape) {
        case Shape::paraboloid:
        case Shape::cylinder:
            return fmt::format("r*r/(2*{:.12g})", radius);
        case Shape::sphere:
            return fmt::format("r*r/({0:.12g}+sqrt({0:.12g}*{0:.12g}-r*r))", radius);
        case Shape::cone:
            return fmt::format("{:.12g}*r", model.height(1, 0));
        case Shape::rounded_punch:
            return fmt::format(
                "0.5*(r-{0:.12g}+abs(r-{0:.12g}))*0.5*(r-{0:.12g}+abs(r-{0:.12g}))/"
                "(2*{1:.12g})",
                data.flat_radius * to_mm, radius);
        default:
            return {};
    }
}

// What forces of a case are divided by: those of plane decks act on a millimetre.
double force_length(const DeckModel& model, const contact::Case& c) {
    return model.shape == DeckModel::Shape::plane ? c.indenter.length * to_mm : 1;
}

int press_increments(const DeckModel& model, const contact::Case& c) {
    const bool is_gradual = model.mu > 0 && c.load.press == contact::Case::Press::friction;
    return is_gradual ? std::max(c.load.press_steps, 1) : 1;
}

void set_static_load(DeckModel& model, const contact::Case& c) {
    if (c.load.is_by_limit())
        refuse("no deck has a load that a model's own limit prescribes",
               "give load.tangential_ratio");
    DeckStep step;
    step.increments = press_increments(model, c);
    step.is_force = !c.load.indentation;
    step.normal = c.load.indentation ? *c.load.indentation * to_mm
                                     : c.load.normal_force.value_or(0) / force_length(model, c);
    model.steps.push_back(step);
    const double ratio = c.load.tangential_ratio.value_or(0);
    double force = c.load.tangential_force.value_or(0) / force_length(model, c);
    if (ratio != 0 && !step.is_force)
        refuse("no deck has a tangential force in shares of a normal force that is not prescribed",
               "prescribe the shift in the case's path");
    if (ratio != 0) force = ratio * c.friction_coefficient() * step.normal;
    if (force == 0) return;
    step.increments = 5;
    step.is_tangential_force = true;
    step.shift = force;
    model.steps.push_back(step);
}

void set_path(DeckModel& model, const contact::Case& c) {
    using Normal = contact::NormalControl::Kind;
    using Tangential = contact::TangentialControl::Kind;
    for (const contact::PrescribedPath::Row& row : c.prescribed_path->rows) {
        if (row.rotation != 0 || row.offset[0] != 0 || row.offset[1] != 0)
            refuse(
                "no deck has a path that twists or rolls: displacements of decks are small, and "
                "nothing turns",
                "paths of decks press and shift along x");
        if (row.tangential[1].value != 0)
            refuse("no deck is loaded along y", "half models are symmetric in y: load along x");
        const contact::TangentialControl& along = row.tangential[0];
        if (along.kind == Tangential::ratio && along.value != 0)
            refuse("no deck has a tangential force in shares of the normal force",
                   "prescribe shift_x or tangential_force_x in the case's path");
        if (row.normal.value == 0 && model.steps.empty()) continue;
        DeckStep step;
        step.is_force = row.normal.kind == Normal::force;
        step.normal =
            step.is_force ? row.normal.value / force_length(model, c) : row.normal.value * to_mm;
        step.is_tangential_force = along.kind == Tangential::force && along.value != 0;
        step.shift =
            step.is_tangential_force ? along.value / force_length(model, c) : along.value * to_mm;
        const bool is_first = model.steps.empty() && !c.prescribed_path->starts_unloaded();
        step.increments = is_first ? press_increments(model, c) : row.steps;
        model.steps.push_back(step);
    }
}

// Friction acts where bodies in contact would move along each other.
void set_friction(DeckModel& model, const contact::Case& c) {
    const bool is_coupled = c.contact.coupling && c.load.press == contact::Case::Press::friction &&
                            (c.layer.thickness || std::abs(c.materials().dundurs_beta()) > 1e-9);
    if (!is_coupled && !model.is_shifted()) return;
    model.mu = c.friction_coefficient();
    if (model.mu > 0 && !c.contact.coupling && c.indenter.body && model.steps.size() > 1) {
        model.presses_frictionless = true;
        model.steps.front().increments = 1;
        return;
    }
    // Only now it is known that friction acts while a path's first row presses.
    if (model.mu > 0 && !(c.prescribed_path && c.prescribed_path->starts_unloaded()))
        model.steps.front().increments = press_increments(model, c);
    if (!c.contact.coupling)
        model.remarks.push_back(
            "The case has no coupling of normal and tangential contact; the deck has, as any code "
            "of finite elements.");
}

// On a rigid plane: the body lies with its pole up, and the plane presses it.
void set_round_body(DeckModel& model, const contact::Case& c) {
    using Body = contact::ElasticBody;
    const Body& body = *c.indenter.body;
    const bool is_round = body.form == Body::Form::hemisphere || body.form == Body::Form::ball ||
                          body.form == Body::Form::cylinder;
    const bool is_on_hub = body.support == Body::Support::hub,
               is_roller = is_on_hub && body.form == Body::Form::cylinder &&
                           !c.has_rigid_substrate && c.layer.thickness;
    if (!is_round || (is_on_hub && !is_roller) || body.is_loose() ||
        c.kept.find<contact::UpperPlate>())
        refuse(
            "bodies of decks are hemispheres on holders, balls and cylinders between equal plates, "
            "and cylinders on hubs that press a block",
            "take one of these, or compare results of an input of your own");
    if (model.shape == DeckModel::Shape::half || (model.mu > 0 && c.has_rigid_substrate))
        refuse(
            "bodies of finite size are pressed along their axis, on a rigid plane without friction",
            "remove the tangential load, and set contact.coupling = false");
    const double radius = c.indenter.radius * to_mm, young = c.indenter.material->young * to_mpa,
                 poisson = c.indenter.material->poisson;
    if (!c.has_rigid_substrate) {
        if (!is_roller && (!c.layer.thickness || body.form != Body::Form::hemisphere ||
                           model.shape == DeckModel::Shape::plane))
            refuse(
                "two bodies of a deck are a hemisphere and a layer, or a cylinder on a hub and "
                "a block",
                "take one of them rigid, or compare results of an input of your own");
        model.upper = {radius, young, poisson};
        return;
    }
    model.round_radius = radius;
    model.has_sliding_base = body.support == Body::Support::plates;
    model.young = young;
    model.poisson = poisson;
}

void set_materials(DeckModel& model, const contact::Case& c) {
    if (c.indenter.body) return set_round_body(model, c);
    const contact::MaterialPair pair = c.materials();
    if (c.has_rigid_substrate)
        refuse("no deck has a rigid substrate", "give the elastic body as the substrate");
    if (c.indenter.material) {
        // Frictionless half-spaces: the same as a rigid body on a half-space of E*.
        if (c.layer.thickness)
            refuse("no deck has an elastic indenter on a layer", "take a rigid indenter");
        if (model.mu > 0)
            refuse("no deck has two elastic bodies with friction",
                   "take a rigid indenter, or compare results of an input of your own");
        model.young = pair.effective_modulus() * to_mpa * (1 - model.poisson * model.poisson);
        model.remarks.push_back(
            fmt::format("Both bodies of the case are elastic half-spaces. The deck presses a rigid "
                        "indenter with "
                        "the same gap on one body, whose Young's modulus {:.6g} MPa gives it the "
                        "effective modulus "
                        "of both: without friction the pressures are the same.",
                        model.young));
    }
    // Codes with displacements alone cannot have an incompressible body.
    constexpr double largest = .4999;
    if (model.poisson <= largest) return;
    model.young *= (1 - largest * largest) / (1 - model.poisson * model.poisson);
    model.poisson = largest;
    model.remarks.push_back(
        fmt::format("The case's body is incompressible. That of the deck has nu = {} and E = "
                    "{:.6g} MPa, and so the "
                    "same effective modulus.",
                    largest, model.young));
}

void set_block(DeckModel& model, const contact::Case& c) {
    const bool is_half_model = model.shape == DeckModel::Shape::half;
    model.is_half_space = !c.layer.thickness && !c.indenter.body;
    if (model.round_radius > 0) {
        model.width = model.thickness = model.round_radius;
        if (model.width < 2.5 * model.a)
            refuse("the body is narrower than 2.5 contact radii", "reduce the load");
    } else if (model.is_half_space) {
        model.width = model.thickness =
            model.a * (is_half_model ? half_space_half_model : half_space_block);
    } else {
        model.thickness = *c.layer.thickness * to_mm;
        model.width = std::max((is_half_model ? half_model_sides : layer_sides) * model.thickness,
                               4 * model.a);
        if (c.layer.width) model.width = *c.layer.width * to_mm / 2;
        if (c.layer.width && !is_half_model)
            refuse("a block of a finite width has a half model only", "ask for a spatial deck");
        if (model.width < 2.5 * model.a)
            refuse("the block is narrower than 2.5 contact radii", "widen substrate.width");
    }
    model.contact_reach = (is_half_model ? half_model_reach : contact_reach) * model.a;
    model.indenter_reach = indenter_reach * model.a;
}

// Two significant digits, for numbers that somebody chose.
double rounded(double value) {
    const double unit = std::pow(10., std::floor(std::log10(value)) - 1);
    return std::round(value / unit) * unit;
}

// 260 MPa/mm for the pressed layer, which lowers its force by 0.42 %.
void set_stiffness(DeckModel& model, const Reference& reference) {
    const ReferenceValue* depth = reference.find(quantity_keys::indentation);
    const ReferenceValue* peak = reference.find(quantity_keys::peak_pressure);
    double d = depth ? depth->value * to_mm : 0, p = peak ? peak->value * to_mpa : 0;
    const double modulus = model.young / (1 - model.poisson * model.poisson);
    if (!(d > 0) || !std::isfinite(d)) d = std::max(model.height(model.a, 0), 1e-3 * model.a);
    if (!(p > 0) || !std::isfinite(p)) p = modulus * d / model.a / 2;
    model.depth_scale = d;
    model.stiffness = rounded(stiffness_factor * p / d);
    // Without it the indenter under a force has nothing that it rests on when the load begins.
    if (model.has_force()) model.overlap = .02 * d;
    // A force once, a force always: 0 where there is none yet.
    if (model.has_tangential_force())
        for (DeckStep& step : model.steps) step.is_tangential_force = true;
    if (model.mu > 0) model.stick_slope = model.stiffness;
}

}  // namespace

bool DeckModel::has_force() const {
    return std::ranges::any_of(steps, &DeckStep::is_force);
}

bool DeckModel::has_tangential_force() const {
    return std::ranges::any_of(steps, &DeckStep::is_tangential_force);
}

bool DeckModel::is_shifted() const {
    return std::ranges::any_of(steps, [](const DeckStep& step) { return step.shift != 0; });
}

double DeckModel::height(double x, double y) const {
    return indenter->height(x / to_mm, y / to_mm) * to_mm;
}

DeckModel make_deck_model(const Reference& reference, const DeckWishes& wishes) {
    const contact::Case& c = reference.c;
    check_case(c);
    if (!(reference.contact_radius > 0) || !std::isfinite(reference.contact_radius))
        refuse("the reference has no contact radius", "elements are counted in it");
    DeckModel model;
    model.name = wishes.problem.empty() ? "case" : wishes.problem;
    model.title = c.title;
    model.a = reference.contact_radius * to_mm;
    model.indenter = c.make_indenter();
    model.young = c.substrate.young * to_mpa;
    model.poisson = c.substrate.poisson;
    if (c.is_line_contact())
        model.shape = DeckModel::Shape::plane;
    else if (wishes.is_spatial || reference.geometry == Geometry::spatial)
        model.shape = DeckModel::Shape::half;
    c.prescribed_path ? set_path(model, c) : set_static_load(model, c);
    if (model.is_shifted() && model.shape == DeckModel::Shape::axisymmetric)
        model.shape = DeckModel::Shape::half;
    set_friction(model, c);
    set_materials(model, c);
    set_block(model, c);
    set_stiffness(model, reference);
    model.gap = gap_formula(c.indenter, model);
    if (model.round_radius > 0) model.indenter = flat_face();
    if (model.upper && model.shape == DeckModel::Shape::plane)
        set_cylinder_on_block(model, c.indenter.body->hub_radius * to_mm);
    return model;
}

std::vector<double> heights_of(const DeckLines& lines) {
    std::vector<double> heights;
    for (auto depth = lines.depth.rbegin(); depth != lines.depth.rend(); ++depth)
        heights.push_back(0 - *depth);
    return heights;
}

DeckLines deck_lines(const DeckModel& model, int n, int level) {
    const double a = model.lattice_edge();
    const double width =
        model.round_radius > 0 ? model.round_radius * std::numbers::pi / 2 : model.width;
    const double size = a / n;
    // As many equal elements as reach beyond the faces that may touch.
    const double equal_reach = std::max(model.contact_reach / model.a, contact_reach) * a;
    const int equal = static_cast<int>(std::ceil(equal_reach / size - 1e-9));
    const bool is_half_model = model.shape == DeckModel::Shape::half;
    const double growth = model.is_half_space ? 2. : is_half_model ? 1.8 : 1.6;
    DeckLines lines;
    const std::vector<double> out = graded_line(0, size, equal, width, growth);
    const double first = std::min(size, model.thickness / 2);
    lines.depth = refined_line(graded_line(0, first, 1, model.thickness, growth), level);
    const bool is_whole = model.shape == DeckModel::Shape::half ||
                          (model.shape == DeckModel::Shape::plane && model.is_shifted());
    lines.x = refined_line(is_whole ? mirrored_line(out) : out, level);
    if (model.shape == DeckModel::Shape::half) lines.y = refined_line(out, level);
    return lines;
}

}  // namespace tricontact::benchmarks
