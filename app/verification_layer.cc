#include <fmt/format.h>

#include "app/verification_problems.h"
#include "app/verification_rows.h"
#include "comparisons/layer.h"
#include "contact/run.h"
#include "mdr/layer_model.h"
#include "theory/layer_shakedown.h"

namespace tricontact::app {

namespace {

using comparisons::Verification;
using contact::Case;

/// The rig's layer under a rigid paraboloid; no coupling, which the limit of shakedown leaves out.
Case layer_case() {
    Case c;
    c.indenter.radius = 40e-3;
    c.substrate = {5.2e6, 0.5};
    c.layer.thickness = 8e-3;
    c.friction_coefficient = 0.57;
    c.contact.coupling = false;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = 0.56;
    c.rolling.emplace();
    c.rolling->amplitude_ratio = 0.24;
    c.rolling->steps = Case::Steps::turning_points;
    c.rolling->periods = 60;
    return c;
}

struct LayerTolerances {
    Allowed radius, others, limit;
};

void add_layer(const Levels& levels, const LayerTolerances& allowed, Verification& all) {
    const Case c = layer_case();
    const theory::LayerContact exact = comparisons::exact_layer_contact(c).value();
    const double amplitude = *c.rolling->amplitude_ratio * contact::hertz_scales(c).contact_radius;
    const char* const fredholm =
        "Lebedev and Ufliand (1958), Fredholm equation of the bonded layer";
    Rows rows(levels, all);
    rows.add("Layer b = 1.8 a", "a, mm", fredholm, exact.contact_radius * 1e3, allowed.radius,
             radius_mm);
    rows.add("Layer b = 1.8 a", "d, mm", fredholm, exact.indentation * 1e3, allowed.others,
             indentation_mm);
    rows.add("Layer b = 1.8 a", "p0, MPa", fredholm, exact.centre_pressure * 1e-6, allowed.others,
             peak_pressure_mpa);
    rows.add(
        "Layer b = 1.8 a", "U_max, mm", "displacement under the pressure of that equation along x",
        c.friction_coefficient * exact.unit_shift.value() * 1e3, allowed.others, unit_shift_mm);
    rows.add("Layer b = 1.8 a, limit of shakedown", "f_T,lim", "line load of that equation",
             theory::shakedown_limit(exact, amplitude / exact.contact_radius), allowed.limit,
             limit);
}

void verify_mdr_layer(const Say& say, Verification& all) {
    Levels levels{"mdr-layer", {}, {}};
    const Case c = layer_case();
    for (const int elements : {20, 40, 80}) {
        say(fmt::format("mdr-layer, level {}", levels.sizes.size() + 1));
        levels.sizes.push_back(1. / elements);
        levels.histories.push_back(contact::run(c, *mdr::make_layer_model(c, elements)));
    }
    // The overlap of pressures ends between elements.
    const Allowed allowed{1e-4, 1.6};
    add_layer(levels, {allowed, allowed, {1e-4}}, all);
}

}  // namespace

void verify_layer(bool brief, const Say& say, Verification& all) {
    verify_mdr_layer(say, all);
    const double hertz_radius = contact::hertz_scales(layer_case()).contact_radius;
    const double cells = brief ? 5 : 8, coarser = brief ? 4 : 1, order = brief ? 0 : 1.2;
    const auto set_spacing = [&](Case& c, int factor) {
        c.bem.spacing = hertz_radius / (cells * factor);
    };
    const auto size = [&](const Case& c) { return *c.bem.spacing / hertz_radius; };
    const Allowed allowed{2e-4 * coarser, order};
    add_layer(run_levels("bem-layer", layer_case(), set_spacing, size, say),
              {{5e-4 * coarser, order}, allowed, allowed}, all);
}

}  // namespace tricontact::app
