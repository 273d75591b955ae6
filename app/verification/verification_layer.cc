#include <fmt/format.h>

#include <algorithm>

#include "app/verification/verification_rows.h"
#include "comparisons/half_space/layer.h"
#include "comparisons/run/peer_shifts.h"
#include "contact/run.h"
#include "mdr/layer_model.h"
#include "theory/layer/layer_shakedown.h"

namespace tricontact::app {

namespace {

using comparisons::Verification;
using contact::Case;

/// The rig's layer under a rigid paraboloid; no coupling, which the limit of shakedown leaves out.
Case layer_case() {
    Case c = rig_sphere(0.5, 0.56);
    c.layer.thickness = 8e-3;
    c.rolling.emplace();
    c.rolling->amplitude_ratio = 0.24;
    c.rolling->steps = Case::Steps::turning_points;
    c.rolling->periods = 60;
    return c;
}

struct LayerTolerances {
    Allowed radius, pressure, others, limit;
};

void add_pressed(const Levels& levels, const LayerTolerances& allowed, Verification& all) {
    const Case c = layer_case();
    const theory::LayerContact exact = comparisons::exact_layer_contact(c).value();
    const char* const fredholm =
        "Lebedev and Ufliand (1958), Fredholm equation of the bonded layer";
    Rows rows(levels, all);
    rows.add("Layer b = 1.8 a", "a, mm", fredholm, exact.contact_radius * 1e3, allowed.radius,
             radius_mm);
    rows.add("Layer b = 1.8 a", "d, mm", fredholm, exact.indentation * 1e3, allowed.others,
             indentation_mm);
    rows.add("Layer b = 1.8 a", "p0, MPa", fredholm, exact.centre_pressure * 1e-6, allowed.pressure,
             peak_pressure_mpa);
    rows.add(
        "Layer b = 1.8 a", "U_max, mm", "displacement under the pressure of that equation along x",
        c.friction_coefficient * exact.unit_shift.value() * 1e3, allowed.others, unit_shift_mm);
}

void add_layer(const Levels& levels, const LayerTolerances& allowed, Verification& all) {
    add_pressed(levels, allowed, all);
    const Case c = layer_case();
    const theory::LayerContact exact = comparisons::exact_layer_contact(c).value();
    const double amplitude =
        *c.rolling->amplitude_ratio * contact::half_space_scales(c).contact_radius;
    Rows(levels, all)
        .add("Layer b = 1.8 a, limit of shakedown", "f_T,lim", "line load of that equation",
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
    add_layer(levels, {allowed, allowed, allowed, {1e-4}}, all);
}

/// Pressed by the force, then F_T.
void verify_fem_layer(const Say& say, Verification& all) {
    Case base = layer_case();
    base.rolling.reset();
    base.fem.cache = "none";
    const double hertz_radius = contact::half_space_scales(base).contact_radius;
    const Levels levels = run_levels(
        "fem", base, [](Case& c, int factor) { c.fem.size = 2.8e-3 / factor; },
        [&](const Case& c) { return *c.fem.size / hertz_radius; }, say);
    // Pressures of nodes come from row sums.
    add_pressed(levels, {{5e-3}, {8e-3}, {2e-3}, {}}, all);
    Rows(levels, all)
        .add("Layer b = 1.8 a, f_T = 0.56", "U_stat, mm, uncoupled", peer_programs,
             comparisons::layer_peer_uncoupled * 1e3, {1.5e-3}, static_shift_mm);
}

}  // namespace

void verify_fem(const Say& say, Verification& all) {
    const auto& models = known_models();
    if (std::none_of(models.begin(), models.end(), [](const auto& m) { return m.name == "fem"; }))
        return;
    verify_fem_layer(say, all);
    verify_fem_line(say, all);
}

void verify_layer(bool brief, const Say& say, Verification& all) {
    verify_mdr_layer(say, all);
    const double hertz_radius = contact::half_space_scales(layer_case()).contact_radius;
    const double cells = brief ? 5 : 8, coarser = brief ? 4 : 1, order = brief ? 0 : 1.2;
    const auto set_spacing = [&](Case& c, int factor) {
        c.bem.spacing = hertz_radius / (cells * factor);
    };
    const auto size = [&](const Case& c) { return *c.bem.spacing / hertz_radius; };
    const Allowed allowed{2e-4 * coarser, order};
    add_layer(run_levels("bem-layer", layer_case(), set_spacing, size, say),
              {{5e-4 * coarser, order}, allowed, allowed, allowed}, all);
}

}  // namespace tricontact::app
