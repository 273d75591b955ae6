#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "app/verification/verification_rows.h"
#include "theory/cattaneo_mindlin.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::app {

namespace {

using comparisons::Verification;
using contact::Case;

/// A paraboloid that rolls until it rests, all scales other than 1, at nu = 0, for which alone
/// Cattaneo and Mindlin are exact.
Case rolling_case(double w, double f) {
    Case c = rig_sphere(0, f);
    c.rolling.emplace();
    c.rolling->amplitude_ratio = w;
    c.rolling->steps = Case::Steps::turning_points;
    c.rolling->periods = 60;
    return c;
}

constexpr double amplitude = 0.24, force = 0.56;

struct HalfSpaceTolerances {
    Allowed radius, depth, pressure, energy, shift, stick, limit;
};

void add_closed_forms(const Levels& levels, const HalfSpaceTolerances& allowed, Verification& all) {
    const Case c = rolling_case(amplitude, force);
    const contact::HalfSpaceScales hertz = contact::half_space_scales(c);
    const char* const johnson = "Johnson, Contact Mechanics (1985), eq. 4.22 to 4.24 (Hertz)";
    Rows rows(levels, all);
    rows.add("Hertz", "a, mm", johnson, hertz.contact_radius * 1e3, allowed.radius, radius_mm);
    rows.add("Hertz", "d, mm", johnson, hertz.indentation * 1e3, allowed.depth, indentation_mm);
    rows.add("Hertz", "p0, MPa", johnson, hertz.peak_pressure * 1e-6, allowed.pressure,
             peak_pressure_mpa);
    rows.add("Hertz", "elastic energy, mJ",
             "Johnson, Contact Mechanics (1985), eq. 4.23 integrated",
             .4 * hertz.normal_force * hertz.indentation * 1e3, allowed.energy, pressed_energy_mj);
    rows.add("Cattaneo and Mindlin", "u_stat",
             "Johnson, Contact Mechanics (1985), eq. 7.42b (exact for nu = 0)",
             theory::static_shift_ratio(force), allowed.shift, static_ratio);
    rows.add("Cattaneo and Mindlin", "c/a",
             "Johnson, Contact Mechanics (1985), eq. 7.40; whole cells stick or slip",
             theory::stick_radius_ratio(force), allowed.stick, stick_ratio);
    const double friction_work = c.friction_coefficient * hertz.normal_force * hertz.unit_shift;
    const double rest = 1 - force;
    rows.add("Energy balance", "stored and dissipated under F_T, mJ",
             "work of F_T, Johnson, Contact Mechanics (1985), eq. 7.42b integrated",
             friction_work * (.6 - std::pow(rest, 2. / 3) + .4 * std::pow(rest, 5. / 3)) * 1e3,
             {allowed.energy.error}, loading_energy_mj);
    rows.add("Limit of shakedown", "f_T,lim, w = 0.24",
             "1 - 3/2 w + 1/2 w^3, the least pressures of Hertz' contact integrated "
             "(docs/limits.md)",
             theory::shakedown_limit(amplitude), allowed.limit, limit);
}

/// Dissipated [J] while F_T goes from f mu F_N to the opposite and back.
double cycle_dissipation(contact::Model& model, const Case& c, double f) {
    contact::LoadStep step = contact::press_step(c);
    model.advance(step);
    const auto dissipation_to = [&](double end) {
        step.tangential[0].value = end * c.friction_coefficient * *c.load.normal_force;
        return model.advance(step).dissipation;
    };
    dissipation_to(f);
    return dissipation_to(-f) + dissipation_to(f);
}

void add_cycle(const std::string& model, const SetLevel& set_level, const Size& size,
               const Allowed& allowed, const Say& say, Verification& all) {
    const double f = 0.6;
    const Case base = rolling_case(amplitude, f);
    const double exact =
        theory::cycle_dissipation({base.friction_coefficient, *base.load.normal_force,
                                   base.materials().effective_shear_modulus(),
                                   contact::half_space_scales(base).contact_radius, f});
    comparisons::VerificationRow row{
        .problem = "Oscillating F_T",
        .quantity = "work dissipated in a cycle, mJ, f_T = 0.6",
        .model = model,
        .source = "Mindlin and Deresiewicz (1953); Johnson, Contact Mechanics (1985), eq. 7.57",
        .reference = exact * 1e3,
        .tolerance = allowed.error,
        .least_order = allowed.order};
    for (const Case& c : finer_cases(base, set_level)) {
        row.sizes.push_back(size(c));
        row.values.push_back(cycle_dissipation(*make_model(model, c, 1, say), c, f) * 1e3);
    }
    all.rows.push_back(std::move(row));
}

void add_settled_mdr(const Levels& levels, double w, double f, double tolerance,
                     Verification& all) {
    Rows(levels, all)
        .add("Settled shift of MDR", fmt::format("u_sd, w = {}, f_T = {}", w, f),
             "Wetter, thesis (TU Berlin 2016), eq. 3.2.16 with kappa = 3/2",
             theory::settled_shift_ratio(w, f).value(), {tolerance}, settled_ratio);
}

void verify_mdr(bool brief, const Say& say, Verification& all) {
    const int springs = brief ? 500 : 2500;
    const SetLevel set_springs = [&](Case& c, int factor) { c.mdr.springs = springs * factor; };
    // Of the bed: the contact and the path on both sides.
    const Size size = [](const Case& c) {
        return 2 * (1 + *c.rolling->amplitude_ratio) / c.mdr.springs;
    };
    const auto run = [&](double w, double f) {
        return run_levels("mdr", rolling_case(w, f), set_springs, size, say);
    };
    const Levels levels = run(amplitude, force);
    const double tolerance = brief ? 2.5e-5 : 1e-6;  // of the second order
    const Allowed allowed{tolerance};
    add_closed_forms(
        levels, {allowed, allowed, allowed, allowed, allowed, {brief ? 5e-3 : 1e-3}, allowed}, all);
    add_cycle("mdr", set_springs, size, {10 * tolerance}, say, all);
    add_settled_mdr(levels, amplitude, force, tolerance, all);
    if (brief) return;
    // Kinks of the line load cost the more the less the shift is.
    for (const auto& [w, f] : {std::pair{.24, .24}, {.51, .09}, {.51, .24}})
        add_settled_mdr(run(w, f), w, f, 2e-6, all);
}

}  // namespace

void verify_half_space(bool brief, const Say& say, Verification& all) {
    verify_mdr(brief, say, all);
    const double cells = brief ? 5 : 8, coarser = brief ? 4 : 1;
    const SetLevel set_cells = cells_in_radius(cells);
    // Second order but for edges between cells.
    const Allowed allowed{2e-4 * coarser, brief ? 0 : 1.2};
    add_closed_forms(
        run_levels("bem", rolling_case(amplitude, force), set_cells, cell_in_radius, say),
        {{5e-4 * coarser, allowed.order},
         allowed,
         allowed,
         allowed,
         allowed,
         {.02 * coarser},
         allowed},
        all);
    add_cycle("bem", set_cells, cell_in_radius, {2e-3 * coarser, allowed.order}, say, all);
}

}  // namespace tricontact::app
