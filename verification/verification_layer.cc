#include <algorithm>

#include "comparisons/half_space/layer.h"
#include "comparisons/run/peer_shifts.h"
#include "contact/cells.h"
#include "contact/models/model_kind.h"
#include "contact/run.h"
#include "fem/settings.h"
#include "mdr/layer_model.h"
#include "verification/verification_rows.h"

namespace tricontact::verification {

namespace {

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
    Rows rows(levels, "Layer b = 1.8 a", all);
    rows.add(radius, fredholm, exact.contact_radius * 1e3, allowed.radius);
    rows.add(indentation, fredholm, exact.indentation * 1e3, allowed.others);
    rows.add(peak_pressure, fredholm, exact.centre_pressure * 1e-6, allowed.pressure);
    rows.add(unit_shift, "displacement under the pressure of that equation along x",
             c.friction_coefficient() * exact.unit_shift.value() * 1e3, allowed.others);
}

void add_layer(const Levels& levels, const LayerTolerances& allowed, Verification& all) {
    add_pressed(levels, allowed, all);
    const Case c = layer_case();
    const theory::LayerContact exact = comparisons::exact_layer_contact(c).value();
    const double rolled =
        *c.rolling->amplitude_ratio * contact::half_space_scales(c).contact_radius;
    Rows(levels, "Layer b = 1.8 a, limit of shakedown", all)
        .add(limit, "line load of that equation",
             theory::shakedown_limit(exact, rolled / exact.contact_radius), allowed.limit);
}

void verify_mdr_layer(const Runner& runner, Verification& all) {
    Levels levels{contact::models::mdr_layer, {}, {}};
    const Case c = layer_case();
    for (const int elements : {20, 40, 80}) {
        runner.say(fmt::format("mdr-layer, level {}", levels.sizes.size() + 1));
        levels.sizes.push_back(1. / elements);
        levels.histories.push_back(contact::run(c, *mdr::make_layer_model(c, elements)));
    }
    // The overlap of pressures ends between elements.
    const Allowed allowed{1e-4, 1.6};
    add_layer(levels, {allowed, allowed, allowed, {1e-4}}, all);
}

/// Pressed by the force, then F_T.
void verify_fem_layer(const Runner& runner, Verification& all) {
    Case base = layer_case();
    base.rolling.reset();
    base.of<fem::Settings>().cache = "none";
    base.of<fem::Settings>().size = 2.8e-3;
    const Levels levels = run_levels(contact::models::fem, base, runner);
    // Pressures of nodes come from row sums.
    add_pressed(levels, {{5e-3}, {8e-3}, {2e-3}, {}}, all);
    Rows(levels, "Layer b = 1.8 a, f_T = 0.56", all)
        .add(static_shift + ", uncoupled", peer_programs, comparisons::layer_peer_uncoupled * 1e3,
             {1.5e-3});
}

constexpr double across = std::numbers::pi / 2;

/// The rig on the cells of those programs.
Case rig_case(double f) {
    Case c = rig_sphere(0.5, f);
    c.contact.coupling = true;
    c.of<contact::Cells>().spacing = 2e-4;
    return c;
}

/// Rolled along F_T and across.
template <class Row>
void add_settled(const Levels& level, const std::string& problem, double angle, const Row& row,
                 double tolerance, double (*shift_ratio)(const contact::History&),
                 Verification& all) {
    Rows(level, problem + (angle == 0 ? ", along F_T" : ", across F_T"), all)
        .add({fmt::format("u_sd, w = {}, f_T = {}", row.w, row.f), shift_ratio}, peer_programs,
             angle == 0 ? row.parallel : row.perpendicular, {tolerance});
}

void verify_half_space_shifts(const Runner& runner, Verification& all) {
    for (const auto& row : comparisons::half_space_peer_shifts)
        for (const double angle : {0., across}) {
            Case c = rig_case(row.f);
            c.contact.coupling = false;
            c.rolling.emplace();
            c.rolling->amplitude_ratio = row.w;
            c.rolling->angle = angle;
            c.rolling->steps = Case::Steps::turning_points;
            c.rolling->periods = 60;
            const Levels level =
                run_level(contact::models::bem, c, relative_size(contact::models::bem, c), runner);
            // Those programs place their grids differently under the contact.
            add_settled(level, "Settled shift", angle, row, 2e-3, settled_ratio.of, all);
        }
}

Case layer_case(double f) {
    Case c = rig_case(f);
    c.layer.thickness = 8e-3;
    return c;
}

void verify_layer_static(const Runner& runner, Verification& all) {
    const auto add_row = [&](const Levels& level, const std::string& how, double shift,
                             double tolerance) {
        Rows(level, "Layer b = 1.8 a, f_T = 0.56", all)
            .add(static_shift + how, peer_programs, shift * 1e3, {tolerance});
    };
    const auto add = [&](const std::string& how, double shift, const Case& c) {
        // Both programs to 1e-5 mm.
        add_row(run_level(contact::models::bem_layer, c,
                          relative_size(contact::models::bem_layer, c), runner),
                how, shift, 2e-4);
    };
    Case c = layer_case(.56);
    for (const auto& pressing : comparisons::layer_peer_pressings) {
        c.load.press_steps = pressing.steps;
        add(fmt::format(", steps of pressing: {}", pressing.steps), pressing.static_shift, c);
    }
    c.load.press = Case::Press::frictionless;
    add(", pressed without friction", comparisons::layer_peer_frictionless, c);
    c.contact.coupling = false;
    add(", uncoupled", comparisons::layer_peer_uncoupled, c);
    // Without the traction across, which is its approximation; 100 elements in the radius.
    add_row(run_level(contact::models::mdr_layer, c, .01, runner), ", uncoupled",
            comparisons::layer_peer_uncoupled, 3e-3);
}

void verify_layer_shifts(const Runner& runner, Verification& all) {
    for (const auto& row : comparisons::layer_peer_shifts)
        for (const double angle : {0., across}) {
            Case c = layer_case(row.f);
            c.load.press_steps = 1;
            c.rolling.emplace();
            c.rolling->amplitude = row.w * comparisons::layer_peer_radius;
            c.rolling->angle = angle;
            c.rolling->steps = Case::Steps::increment;
            c.rolling->increment = 4e-4;
            c.rolling->periods = 60;
            const Levels level = run_level(contact::models::bem_layer, c,
                                           relative_size(contact::models::bem_layer, c), runner);
            // The references have four digits and steps of their own.
            add_settled(
                level, "Layer b = 1.8 a, settled shift", angle, row, 3e-3,
                [](const contact::History& h) {
                    return h.shift_per_period.back() / comparisons::layer_peer_unit_shift;
                },
                all);
        }
}

}  // namespace

void verify_fem(const Runner& runner, Verification& all) {
    if (!runner.makers.has(contact::models::fem)) return;
    verify_fem_layer(runner, all);
    verify_fem_line(runner, all);
}

void verify_layer(bool brief, const Runner& runner, Verification& all) {
    verify_mdr_layer(runner, all);
    const double cells = brief ? 5 : 8, coarser = brief ? 4 : 1, order = brief ? 0 : 1.2;
    Case c = layer_case();
    c.of<contact::Cells>().spacing = contact::half_space_scales(c).contact_radius / cells;
    const Allowed allowed{2e-4 * coarser, order};
    add_layer(run_levels(contact::models::bem_layer, c, runner),
              {{5e-4 * coarser, order}, allowed, allowed, allowed}, all);
}

void verify_peer_shifts(const Runner& runner, Verification& all) {
    verify_half_space_shifts(runner, all);
    verify_layer_static(runner, all);
    verify_layer_shifts(runner, all);
}

}  // namespace tricontact::verification
