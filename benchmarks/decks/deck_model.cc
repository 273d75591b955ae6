#include "benchmarks/decks/deck_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "benchmarks/decks/graded_line.h"
#include "contact/base/error.h"

namespace tricontact::benchmarks {

namespace {

constexpr double to_mm = 1e3, to_mpa = 1e-6;
// Blocks of layers reach this many thicknesses to the sides; half models less, they are costly.
constexpr double layer_sides = 6, half_model_sides = 3.25;
// Blocks of half-spaces, in a. A bonded base at the distance H from the load lowers the depth under
// a force by about 0.6 a/H of it.
constexpr double half_space_size = 1000, half_space_half_model = 30;
constexpr double contact_reach = 1.5, indenter_reach = 2;  // in a

[[noreturn]] void refuse(const std::string& what, const std::string& help) {
    throw contact::InputError("deck: " + what + "; " + help);
}

void check_case(const contact::Case& c) {
    const std::string own = "compare results of an input of your own instead, or run tricontact";
    if (c.rolling || c.tractive_rolling) refuse("no deck has rolling contact", own);
    if (c.relaxation) refuse("no deck has a relaxing substrate", own);
    if (c.law != contact::Case::Law::linear) refuse("no deck has finite strains", own);
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

void set_load(DeckModel& model, const contact::Case& c) {
    using Normal = contact::NormalControl::Kind;
    using Tangential = contact::TangentialControl::Kind;
    const double per_length =
        model.shape == DeckModel::Shape::plane ? 1 / (c.indenter.length * to_mm) : 1;
    const auto normal = [&](DeckStep& step, bool is_force, double value) {
        step.is_force = is_force;
        step.normal = is_force ? value * per_length : value * to_mm;
    };
    const int press_steps =
        model.mu > 0 && c.load.press == contact::Case::Press::friction ? c.load.press_steps : 1;
    if (!c.prescribed_path) {
        DeckStep step;
        step.increments = std::max(press_steps, 1);
        normal(step, !c.load.indentation,
               c.load.indentation ? *c.load.indentation : c.load.normal_force.value_or(0));
        model.steps.push_back(step);
        return;
    }
    for (const contact::PrescribedPath::Row& row : c.prescribed_path->rows) {
        if (row.rotation != 0 || row.offset[0] != 0 || row.offset[1] != 0)
            refuse("no deck has a path that twists or rolls",
                   "paths of decks press and shift along x");
        for (const int k : {0, 1}) {
            const contact::TangentialControl& control = row.tangential[k];
            if (control.value == 0) continue;
            if (k == 1)
                refuse("no deck shifts along y", "half models are symmetric in y: shift along x");
            if (control.kind != Tangential::shift)
                refuse("no deck has a prescribed tangential force",
                       "prescribe shift_x in the case's path");
        }
        DeckStep step;
        normal(step, row.normal.kind == Normal::force, row.normal.value);
        step.shift = row.tangential[0].value * to_mm;
        step.increments = model.steps.empty() ? std::max(press_steps, 1) : row.steps;
        if (step.normal != 0 || !model.steps.empty()) model.steps.push_back(step);
    }
}

bool is_shifted(const DeckModel& model) {
    return std::ranges::any_of(model.steps, [](const DeckStep& step) { return step.shift != 0; });
}

void set_block(DeckModel& model, const contact::Case& c) {
    const bool is_half_model = model.shape == DeckModel::Shape::half;
    model.is_half_space = !c.layer.thickness;
    if (model.is_half_space) {
        model.width = model.thickness =
            model.a * (is_half_model ? half_space_half_model : half_space_size);
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
    model.contact_reach = contact_reach * model.a;
    model.indenter_reach = indenter_reach * model.a;
}

// Two significant digits, for numbers that somebody chose.
double rounded(double value) {
    const double unit = std::pow(10., std::floor(std::log10(value)) - 1);
    return std::round(value / unit) * unit;
}

// p0/K = 0.46 % of the depth: 260 MPa/mm for the pressed layer, which lowers its force by 0.42 %.
void set_stiffness(DeckModel& model, const Reference& reference) {
    const ReferenceValue* depth = reference.find(quantity_keys::indentation);
    const ReferenceValue* peak = reference.find(quantity_keys::peak_pressure);
    double d = depth ? depth->value * to_mm : 0, p = peak ? peak->value * to_mpa : 0;
    const double modulus = model.young / (1 - model.poisson * model.poisson);
    if (!(d > 0) || !std::isfinite(d)) d = std::max(model.height(model.a, 0), 1e-3 * model.a);
    if (!(p > 0) || !std::isfinite(p)) p = modulus * d / model.a / 2;
    model.depth_scale = d;
    model.stiffness = rounded(216 * p / d);
    if (model.mu > 0) model.stick_slope = model.stiffness;
}

}  // namespace

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
    const contact::MaterialPair pair = c.materials();
    model.young = c.substrate.young * to_mpa;
    model.poisson = c.substrate.poisson;
    const bool has_friction = c.contact.coupling && c.friction.coefficient > 0 &&
                              (c.load.press == contact::Case::Press::friction || c.prescribed_path);
    model.mu = has_friction ? c.friction.coefficient : 0;
    if (c.is_line_contact())
        model.shape = DeckModel::Shape::plane;
    else if (wishes.is_spatial || reference.geometry == Geometry::spatial)
        model.shape = DeckModel::Shape::half;
    if (c.indenter.material) {
        // Frictionless half-spaces: the same as a rigid body on a half-space of E*.
        if (c.layer.thickness || (model.mu > 0 && std::abs(pair.dundurs_beta()) > 1e-9))
            refuse("no deck has an elastic indenter on a layer or with coupled friction",
                   "take a rigid indenter");
        model.young = pair.effective_modulus() * to_mpa * (1 - model.poisson * model.poisson);
        model.remarks.push_back(fmt::format(
            "Both bodies are elastic half-spaces: the deck presses a rigid indenter of the same "
            "gap on one "
            "body with Young's modulus {:.6g} MPa, which has the effective modulus of both.",
            model.young));
    }
    set_load(model, c);
    if (is_shifted(model) && model.shape != DeckModel::Shape::half) {
        if (model.shape == DeckModel::Shape::axisymmetric) model.shape = DeckModel::Shape::half;
    }
    set_block(model, c);
    set_stiffness(model, reference);
    model.gap = gap_formula(c.indenter, model);
    return model;
}

DeckLines deck_lines(const DeckModel& model, int n, int level) {
    const double size = model.a / n;
    // As many equal elements as reach beyond the faces that may touch.
    const int equal = static_cast<int>(std::ceil(model.contact_reach / size - 1e-9));
    const double growth = model.is_half_space ? 2. : 1.6;
    DeckLines lines;
    const std::vector<double> out = graded_line(0, size, equal, model.width, growth);
    const double first = std::min(size, model.thickness / 2);
    lines.depth = refined_line(graded_line(0, first, 1, model.thickness, growth), level);
    const bool is_whole = model.shape == DeckModel::Shape::half ||
                          (model.shape == DeckModel::Shape::plane && is_shifted(model));
    lines.x = refined_line(is_whole ? mirrored_line(out) : out, level);
    if (model.shape == DeckModel::Shape::half) lines.y = refined_line(out, level);
    return lines;
}

}  // namespace tricontact::benchmarks
