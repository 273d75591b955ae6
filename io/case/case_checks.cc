#include "io/case/case_checks.h"

#include <cmath>

#include "contact/cells.h"
#include "contact/load_path.h"
#include "contact/substrates/normal_tangential.h"
#include "mdr/settings.h"

namespace tricontact::io {

namespace {

using contact::Case;
using contact::HalfSpaceScales;
using contact::ModelKind;

constexpr double fewest_cells = 2;     // per Hertz radius
constexpr double fewest_springs = 10;  // in the contact
constexpr double most_cells = 4096;    // along one side of the grid: 16.8 million cells
constexpr double most_steps = 1e6;
constexpr double most_point_steps = 1e11;  // days of computing

void check_scales(const HalfSpaceScales& s, const Document& document) {
    for (const double scale :
         {s.contact_radius, s.indentation, s.normal_force, s.peak_pressure, s.unit_shift})
        if (!(scale > 0) || !std::isfinite(scale))
            refuse(document, load_key(document),
                   "contact radius, force or pressure on the half-space overflow double precision",
                   "check the units of radius, moduli and load");
}

void check_sphere(const Case& c, const HalfSpaceScales& s, const Document& document) {
    if (c.indenter.shape != Case::Shape::sphere) return;
    const std::string load = load_key(document);
    // A force presses less deep into a layer than into a half-space.
    const bool layer_only = all_have(c, &ModelKind::is_meshed) && c.layer.thickness;
    const double a = layer_only ? contact_radius_bounds(c).low : s.contact_radius;
    if (s.indentation >= c.indenter.radius && !(layer_only && c.load.normal_force))
        refuse(document, load,
               "the indentation " + rounded(s.indentation) + " m must be less than the radius " +
                   rounded(c.indenter.radius) + " m of the sphere",
               "check the units of the load and of indenter.radius; no model goes further");
    if (a > largest_sphere_ratio * c.indenter.radius)
        refuse(document, load,
               "the contact radius " + rounded(a) + " m exceeds " + rounded(largest_sphere_ratio) +
                   " of the sphere's radius " + rounded(c.indenter.radius) +
                   " m: small deformations are assumed",
               "check the units of the load and of indenter.radius; no model goes further");
}

auto find_mdr(const Case& c) {
    return std::ranges::find_if(c.models, &ModelKind::is_on_line, contact::model_kind);
}

void check_revolution(const Case& c, const Document& document) {
    const auto mdr = find_mdr(c);
    if (mdr == c.models.end() || c.indenter.shape != Case::Shape::ellipsoid) return;
    refuse(
        document, "indenter.shape",
        "the contact of an ellipsoid is no disc, which the method of dimensionality reduction (" +
            *mdr + ") needs",
        "leave out " + *mdr + ", or take a body of revolution");
}

void check_coupling(const Case& c, const Document& document) {
    const auto mdr = find_mdr(c);
    const double beta = c.materials().dundurs_beta();
    if (mdr == c.models.end() || !c.contact.coupling || !contact::half_spaces_couple(c.materials()))
        return;
    refuse(document, "substrate.poisson",
           "Dundurs' beta = " + rounded(beta) + " exceeds " + rounded(contact::negligible_beta) +
               " in magnitude: normal and tangential contact are coupled, which " + *mdr +
               " does not model",
           "leave out " + *mdr +
               " (bem and bem-layer do), or set contact.coupling = false: the "
               "coupling is then left out, as the report states");
}

void check_oscillation(const Case& c, const Document& document) {
    const bool turning_points = c.rolling && c.rolling->steps == Case::Steps::turning_points;
    for (const auto& [key, ratio] :
         {std::pair("load.normal_amplitude_ratio", c.load.normal_amplitude_ratio),
          std::pair("load.tangential_amplitude_ratio", c.load.tangential_amplitude_ratio)}) {
        if (ratio == 0) continue;
        if (!c.rolling)
            refuse(document, key, "loads oscillate in the phase of the rolling, and there is none",
                   "add a section [rolling] (its amplitude may be 0), or omit the oscillation");
        if (!c.load.is_tangential() && std::string_view(key) == "load.tangential_amplitude_ratio")
            refuse(
                document, key, "is a part of F_T, which is 0: nothing would oscillate",
                "give load.tangential_ratio or load.tangential_force; a [path] prescribes forces "
                "that oscillate about 0");
        if (turning_points)
            refuse(document, key,
                   "oscillating loads need small steps, but rolling.steps = \"turning-points\"",
                   "give rolling.steps_per_quarter or rolling.increment instead of rolling.steps");
    }
}

double steps_per_period(const Case::Rolling& rolling, double amplitude) {
    if (rolling.steps == Case::Steps::turning_points) return 4;
    if (rolling.steps == Case::Steps::per_quarter) return 4. * rolling.steps_per_quarter;
    return 4 * std::max(1., std::ceil(amplitude / rolling.increment));
}

double check_steps(const Case& c, const HalfSpaceScales& s, const Document& document) {
    const auto& cells = c.of<contact::Cells>();
    if (c.tractive_rolling)  // loading, then one per cell
        return 2 + c.tractive_rolling->distance *
                       (cells.spacing ? s.contact_radius / *cells.spacing : *cells.per_radius);
    if (c.prescribed_path) return c.load.press_steps + c.prescribed_path->n_steps();
    if (!c.rolling) return 2;
    const double amplitude = contact::path_amplitude(c, s.contact_radius);
    const bool increment = c.rolling->steps == Case::Steps::increment;
    if (increment && c.rolling->increment > s.contact_radius)
        refuse(document, "rolling.increment",
               "a step is longer than the contact radius of " + rounded(s.contact_radius) + " m",
               "reduce it, or use rolling.steps = \"turning-points\"");
    const double per_period = steps_per_period(*c.rolling, amplitude);
    const double steps = 2 + c.rolling->periods * per_period;
    if (steps > most_steps)
        refuse(document,
               per_period < c.rolling->periods ? "rolling.periods"
               : increment                     ? "rolling.increment"
                                               : "rolling.steps_per_quarter",
               rounded(steps) + " steps exceed " + rounded(most_steps),
               "use fewer periods or larger steps");
    return steps;
}

void check_bem(const Case& c, const HalfSpaceScales& s, double steps, const Document& document) {
    const std::string key = used(document, "bem.cells_per_radius", "bem.spacing");
    const auto& cells = c.of<contact::Cells>();
    const double h = cells.side(s.contact_radius);
    const double h_y = c.is_cylindrical() ? h : h * cells.ratio.value_or(1);
    const double radius = std::min(s.half_widths[0], s.half_widths[1]);
    if (cells.ratio && std::min(s.half_widths[0] / h, s.half_widths[1] / h_y) < fewest_cells)
        refuse(document, "bem.cell_ratio",
               "fewer than " + rounded(fewest_cells) + " cells of " + rounded(h) + " m x " +
                   rounded(h_y) + " m in the half axes of the contact: too coarse",
               "use smaller cells, or omit it");
    // On its own nodes a height map says itself what touches, if it is a single cell.
    const bool on_own_nodes = c.indenter.height_map && h == c.indenter.spacing;
    if (!cells.ratio && !on_own_nodes && radius < fewest_cells * h)
        refuse(document, key,
               "fewer than " + rounded(fewest_cells) + " cells in the contact radius of " +
                   rounded(radius) + " m: too coarse",
               "use a spacing of at most " + rounded(radius / 10) + " m");
    const contact::Vector2 reach = contact::path_reach(c, s.contact_radius);
    const bool whole_period = c.period && contact::is_nominally_flat(c);
    const double crest = 1 + c.load.normal_amplitude_ratio;
    const double grown = c.load.normal_force ? std::cbrt(crest) : std::sqrt(crest);
    const double n_x = whole_period ? *c.period / h : 2 * (grown * s.half_widths[0] + reach[0]) / h;
    const double n_y = whole_period          ? n_x
                       : c.is_line_contact() ? 1
                       : c.is_cylindrical()  ? c.indenter.length / h
                                             : 2 * (grown * s.half_widths[1] + reach[1]) / h_y;
    if (std::max(n_x, n_y) > most_cells)
        refuse(document, key,
               "contact and rolling path need a grid of " + rounded(std::ceil(n_x)) + " x " +
                   rounded(std::ceil(n_y)) + " cells, more than " + rounded(most_cells) +
                   " along a side",
               "use larger cells or a smaller rolling amplitude");
    if (n_x * n_y * steps > most_point_steps)
        refuse(document, key,
               rounded(n_x * n_y) + " cells times " + rounded(steps) + " steps would take days",
               "use larger cells, fewer periods or larger steps");
}

void check_mdr(const Case& c, const HalfSpaceScales& s, double steps, const Document& document) {
    const double a = s.contact_radius;
    const int springs = c.of<mdr::Settings>().springs;
    const double in_contact = springs * a / (a + contact::norm(contact::path_reach(c, a)));
    if (in_contact < fewest_springs)
        refuse(document, "mdr.springs",
               "fewer than " + rounded(fewest_springs) + " springs in the contact: too coarse",
               "use more springs or a smaller rolling amplitude");
    if (springs * steps > most_point_steps)
        refuse(
            document, "mdr.springs",
            std::to_string(springs) + " springs times " + rounded(steps) + " steps would take days",
            "use fewer springs, fewer periods or larger steps");
}

}  // namespace

void check_case(const Case& c, const Document& document) {
    check_friction(c, document);
    check_interface(c, document);
    check_adhesion(c, document);
    check_line_contact(c, document);
    check_rough_bodies(c, document);
    check_revolution(c, document);
    // What is wrong with the scales of the body is a matter of its load.
    const HalfSpaceScales scales =
        told_at(document, load_key(document), [&] { return contact::half_space_scales(c); });
    check_scales(scales, document);
    check_coupling(c, document);
    check_sphere(c, scales, document);
    check_prescribed_path(c, document);
    check_bulk_stress(c, document);
    check_yield_stress(c, document);
    check_wear(c, document);
    check_tractive_rolling(c, document);
    check_oscillation(c, document);
    check_relaxation(c, document);
    check_heat(c, scales, document);
    check_ground(c, document);
    check_friction_limit(c, scales, document);
    const double steps = check_steps(c, scales, document);
    check_bem_options(c, document);
    for (const std::string& model : c.models) {
        const ModelKind& kind = contact::model_kind(model);
        if (kind.is_layer()) check_layer(model, c, document);
        if (kind.is_on_cells()) check_bem(c, scales, steps, document);
        if (mdr::springs_are_independent(kind, c.interface)) check_mdr(c, scales, steps, document);
        if (kind.is_section())
            check_section(kind, c, document);
        else if (kind.is_meshed())
            check_fem(c, steps, document);
    }
}

}  // namespace tricontact::io
