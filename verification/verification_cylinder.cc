#include "contact/half_space_scales.h"
#include "contact/models/model_kind.h"
#include "fem/settings.h"
#include "theory/layer/line_contact.h"
#include "theory/oscillating_cylinder.h"
#include "verification/verification_rows.h"

namespace tricontact::verification {

namespace {

constexpr double cylinder_amplitude = 0.26, cylinder_force = 0.5;

/// The rig with a cylinder a hundred times as long under the same load per length, so that (a/L)^2
/// of the strip is nothing; no coupling, which the closed forms leave out.
Case cylinder_case() {
    Case c;
    c.indenter.shape = Case::Shape::cylinder;
    c.indenter.radius = 40e-3;
    c.indenter.length = 8;
    c.substrate = {3.6e6, 0.5};
    c.friction.coefficient = 0.79;
    c.contact.coupling = false;
    c.load.normal_force = 3230;
    c.load.tangential_ratio = cylinder_force;
    c.rolling.emplace();
    c.rolling->amplitude_ratio = cylinder_amplitude;
    c.rolling->steps = Case::Steps::turning_points;
    c.rolling->periods = 200;
    return c;
}

struct LineTolerances {
    Allowed width, others;
};

void add_half_space(const Levels& levels, const LineTolerances& allowed, Verification& all) {
    const Case c = cylinder_case();
    const contact::HalfSpaceScales hertz = contact::half_space_scales(c);
    const double length_ratio = c.indenter.length / hertz.contact_radius;
    const double lambda = contact::line_shift_factor(c.materials(), length_ratio);
    const double stick = theory::line_stick_half_width(cylinder_amplitude, cylinder_force).value();
    const char* const johnson = "Johnson, Contact Mechanics (1985), eq. 4.43 to 4.45 (Hertz)";
    const char* const strip = "Boussinesq (1885), Cerruti (1882) over a strip of the length L";
    const char* const punches = "flat punches superposed (theory/oscillating_cylinder.h)";
    Rows rows(levels, "Line contact, w = 0.26, f_T = 0.5", all);
    rows.add(radius, johnson, hertz.contact_radius * 1e3, allowed.width);
    rows.add(peak_pressure, johnson, hertz.peak_pressure * 1e-6, allowed.others);
    rows.add(indentation, strip, hertz.indentation * 1e3, allowed.others);
    rows.add(unit_shift, strip, hertz.unit_shift * 1e3, allowed.others);
    rows.add(static_ratio, "Cattaneo (1938), two ellipses over the strip",
             theory::line_static_shift_ratio(cylinder_force, lambda), allowed.others);
    rows.add(settled_ratio, punches,
             theory::line_settled_shift_ratio(cylinder_amplitude, stick, lambda), allowed.others);
    rows.add(limit, "the same; Wetter, thesis (TU Berlin 2016), eq. 3.5.27",
             theory::line_shakedown_limit(cylinder_amplitude), allowed.others);
}

void add_layer(const Levels& levels, const Case& c, const LineTolerances& allowed,
               Verification& all) {
    const theory::LineContact exact = theory::solve_line_contact(
        {c.substrate, *c.layer.thickness, theory::LayerBase::bonded}, c.indenter.radius,
        {theory::LineControl::Kind::load, *c.load.normal_force / c.indenter.length});
    const char* const source = "singular integral equation of the bonded layer in plane strain";
    const double path = cylinder_amplitude * contact::half_space_scales(c).contact_radius;
    Rows rows(levels, "Line contact, layer b = 2.6 a", all);
    rows.add(radius, source, exact.half_width * 1e3, allowed.width);
    rows.add(indentation, source, exact.indentation * 1e3, allowed.others);
    rows.add(peak_pressure, source, exact.centre_pressure * 1e-6, allowed.others);
    rows.add(limit, source, exact.load_beyond(path) / exact.load, allowed.others);
}

Case line_layer_case() {
    Case c = cylinder_case();
    c.layer.thickness = 5e-3;
    return c;
}

}  // namespace

void verify_fem_line(const Runner& runner, Verification& all) {
    Case c = line_layer_case();
    c.of<fem::Settings>().cache = "none";
    c.of<fem::Settings>().size = 4e-4;
    // Edges fall between nodes, a tenth of a tributary length of which is seen.
    add_layer(run_levels(contact::models::fem, c, runner), c, {{3e-3}, {1e-3}}, all);
}

void verify_cylinder(bool brief, const Runner& runner, Verification& all) {
    const double coarser = brief ? 8 : 1;
    const double cells = brief ? 10 : 40;
    // Second order but for edges between cells.
    const LineTolerances allowed{{5e-4 * coarser}, {2e-4 * coarser}};
    const Case c = with_cells(line_layer_case(), cells);
    add_half_space(run_levels(contact::models::bem, with_cells(cylinder_case(), cells), runner),
                   allowed, all);
    add_layer(run_levels(contact::models::bem_layer, c, runner), c, allowed, all);
}

}  // namespace tricontact::verification
