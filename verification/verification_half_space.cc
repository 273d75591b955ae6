#include <utility>

#include "contact/models/model_kind.h"
#include "mdr/settings.h"
#include "theory/cattaneo_mindlin.h"
#include "theory/rolling/oscillating_rolling.h"
#include "verification/verification_rows.h"

namespace tricontact::verification {

namespace {

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
    Allowed others, radius, stick;
};

void add_closed_forms(const Levels& levels, const HalfSpaceTolerances& allowed, Verification& all) {
    const Case c = rolling_case(amplitude, force);
    const contact::HalfSpaceScales hertz = contact::half_space_scales(c);
    const char* const johnson = "Johnson, Contact Mechanics (1985), eq. 4.22 to 4.24 (Hertz)";
    Rows pressed(levels, "Hertz", all);
    pressed.add(radius, johnson, hertz.contact_radius * 1e3, allowed.radius);
    pressed.add(indentation, johnson, hertz.indentation * 1e3, allowed.others);
    pressed.add(peak_pressure, johnson, hertz.peak_pressure * 1e-6, allowed.others);
    pressed.add(pressed_energy, "Johnson, Contact Mechanics (1985), eq. 4.23 integrated",
                .4 * hertz.normal_force * hertz.indentation * 1e3, allowed.others);
    Rows loaded(levels, "Cattaneo and Mindlin", all);
    loaded.add(static_ratio, "Johnson, Contact Mechanics (1985), eq. 7.42b (exact for nu = 0)",
               theory::static_shift_ratio(force), allowed.others);
    loaded.add(stick_ratio,
               "Johnson, Contact Mechanics (1985), eq. 7.40; whole cells stick or slip",
               theory::stick_radius_ratio(force), allowed.stick);
    const double friction_work = c.friction_coefficient() * hertz.normal_force * hertz.unit_shift;
    const double rest = 1 - force;
    Rows(levels, "Energy balance", all)
        .add(loading_energy, "work of F_T, Johnson, Contact Mechanics (1985), eq. 7.42b integrated",
             friction_work * (.6 - std::pow(rest, 2. / 3) + .4 * std::pow(rest, 5. / 3)) * 1e3,
             {allowed.others.error});
    Rows(levels, "Limit of shakedown", all)
        .add(limit + ", w = 0.24",
             "1 - 3/2 w + 1/2 w^3, the least pressures of Hertz' contact integrated "
             "(docs/how-to/limits.md)",
             theory::shakedown_limit(amplitude), allowed.others);
}

/// Dissipated [J] while F_T goes from f mu F_N to the opposite and back.
double cycle_dissipation(contact::Model& model, const Case& c, double f) {
    contact::LoadStep step = contact::press_step(c);
    model.advance(step);
    const auto dissipation_to = [&](double end) {
        step.tangential[0].value = end * c.friction_coefficient() * *c.load.normal_force;
        return model.advance(step).dissipation;
    };
    dissipation_to(f);
    return dissipation_to(-f) + dissipation_to(f);
}

/// `base`: on the coarsest level.
void add_cycle(const std::string& model, Case base, const Allowed& allowed, const Runner& runner,
               Verification& all) {
    const double f = 0.6;
    base.load.tangential_ratio = f;
    const double exact =
        theory::cycle_dissipation({base.friction_coefficient(), *base.load.normal_force,
                                   base.materials().effective_shear_modulus(),
                                   contact::half_space_scales(base).contact_radius, f});
    add_row(
        {"Oscillating F_T", "work dissipated in a cycle, mJ, f_T = 0.6", model,
         "Mindlin and Deresiewicz (1953); Johnson, Contact Mechanics (1985), eq. 7.57", exact * 1e3,
         allowed.error, allowed.order},
        all, [&](int factor) -> LevelValue {
            const Case c = refined(model, base, factor);
            return {relative_size(model, c), cycle_dissipation(*runner.make(model, c), c, f) * 1e3};
        });
}

void add_settled_mdr(const Levels& levels, double w, double f, double tolerance,
                     Verification& all) {
    Rows(levels, "Settled shift of MDR", all)
        .add(settled_ratio + fmt::format(", w = {}, f_T = {}", w, f),
             "Wetter, thesis (TU Berlin 2016), eq. 3.2.16 with kappa = 3/2",
             theory::settled_shift_ratio(w, f).value(), {tolerance});
}

void verify_mdr(bool brief, const Runner& runner, Verification& all) {
    const int springs = brief ? 500 : 2500;
    const auto coarsest = [&](double w, double f) {
        Case c = rolling_case(w, f);
        c.of<mdr::Settings>().springs = springs;
        return c;
    };
    const auto run = [&](double w, double f) {
        return run_levels(contact::models::mdr, coarsest(w, f), runner);
    };
    const Levels levels = run(amplitude, force);
    const double tolerance = brief ? 2.5e-5 : 1e-6;  // of the second order
    const Allowed allowed{tolerance};
    add_closed_forms(levels, {allowed, allowed, {brief ? 5e-3 : 1e-3}}, all);
    add_cycle(contact::models::mdr, coarsest(amplitude, force), {10 * tolerance}, runner, all);
    add_settled_mdr(levels, amplitude, force, tolerance, all);
    if (brief) return;
    // Kinks of the line load cost the more the less the shift is.
    for (const auto& [w, f] : {std::pair{.24, .24}, {.51, .09}, {.51, .24}})
        add_settled_mdr(run(w, f), w, f, 2e-6, all);
}

}  // namespace

void verify_half_space(bool brief, const Runner& runner, Verification& all) {
    verify_mdr(brief, runner, all);
    const double coarser = brief ? 4 : 1;
    const Case c = with_cells(rolling_case(amplitude, force), brief ? 5 : 8);
    // Second order but for edges between cells.
    const Allowed allowed{2e-4 * coarser, brief ? 0 : 1.2};
    const Levels levels = run_levels(contact::models::bem, c, runner);
    add_closed_forms(levels, {allowed, {5e-4 * coarser, allowed.order}, {.02 * coarser}}, all);
    add_cycle(contact::models::bem, c, {2e-3 * coarser, allowed.order}, runner, all);
}

}  // namespace tricontact::verification
