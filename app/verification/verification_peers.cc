#include <fmt/format.h>

#include <numbers>

#include "app/verification/verification_rows.h"
#include "comparisons/run/peer_shifts.h"

namespace tricontact::app {

namespace {

using comparisons::Verification;
using contact::Case;

constexpr double across = std::numbers::pi / 2;

/// The rig on the cells of those programs.
Case rig_case(double f) {
    Case c = rig_sphere(0.5, f);
    c.contact.coupling = true;
    c.bem.spacing = 2e-4;
    return c;
}

double cell_size(const Case& c) {
    return *c.bem.spacing / contact::half_space_scales(c).contact_radius;
}

void verify_half_space_shifts(const Say& say, Verification& all) {
    for (const auto& row : comparisons::half_space_peer_shifts)
        for (const double angle : {0., across}) {
            Case c = rig_case(row.f);
            c.contact.coupling = false;
            c.rolling.emplace();
            c.rolling->amplitude_ratio = row.w;
            c.rolling->angle = angle;
            c.rolling->steps = Case::Steps::turning_points;
            c.rolling->periods = 60;
            const Levels level = run_level("bem", c, cell_size(c), say);
            // Those programs place their grids differently under the contact.
            Rows(level, all)
                .add(angle == 0 ? "Settled shift, along F_T" : "Settled shift, across F_T",
                     fmt::format("u_sd, w = {}, f_T = {}", row.w, row.f), peer_programs,
                     angle == 0 ? row.parallel : row.perpendicular, {2e-3}, settled_ratio);
        }
}

Case layer_case(double f) {
    Case c = rig_case(f);
    c.layer.thickness = 8e-3;
    return c;
}

void verify_layer_static(const Say& say, Verification& all) {
    const auto add_row = [&](const Levels& level, const std::string& quantity, double shift,
                             double tolerance) {
        Rows(level, all)
            .add("Layer b = 1.8 a, f_T = 0.56", quantity, peer_programs, shift * 1e3, {tolerance},
                 static_shift_mm);
    };
    const auto add = [&](const std::string& quantity, double shift, const Case& c) {
        // Both programs to 1e-5 mm.
        add_row(run_level("bem-layer", c, cell_size(c), say), quantity, shift, 2e-4);
    };
    Case c = layer_case(.56);
    for (const auto& pressing : comparisons::layer_peer_pressings) {
        c.load.press_steps = pressing.steps;
        add(fmt::format("U_stat, mm, steps of pressing: {}", pressing.steps), pressing.static_shift,
            c);
    }
    c.load.press = Case::Press::frictionless;
    add("U_stat, mm, pressed without friction", comparisons::layer_peer_frictionless, c);
    c.contact.coupling = false;
    add("U_stat, mm, uncoupled", comparisons::layer_peer_uncoupled, c);
    // Without the traction across, which is its approximation; 100 elements in the radius.
    add_row(run_level("mdr-layer", c, .01, say), "U_stat, mm, uncoupled",
            comparisons::layer_peer_uncoupled, 3e-3);
}

void verify_layer_shifts(const Say& say, Verification& all) {
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
            const Levels level = run_level("bem-layer", c, cell_size(c), say);
            // The references have four digits and steps of their own.
            Rows(level, all)
                .add(angle == 0 ? "Layer b = 1.8 a, settled shift, along F_T"
                                : "Layer b = 1.8 a, settled shift, across F_T",
                     fmt::format("u_sd, w = {}, f_T = {}", row.w, row.f), peer_programs,
                     angle == 0 ? row.parallel : row.perpendicular, {3e-3},
                     [](const contact::History& h) {
                         return h.shift_per_period.back() / comparisons::layer_peer_unit_shift;
                     });
        }
}

}  // namespace

void verify_peer_shifts(const Say& say, Verification& all) {
    verify_half_space_shifts(say, all);
    verify_layer_static(say, all);
    verify_layer_shifts(say, all);
}

}  // namespace tricontact::app
