#include <array>
#include <boost/math/tools/minima.hpp>

#include "contact/cells.h"
#include "contact/compliances/interior.h"
#include "contact/models/model_kind.h"
#include "contact/run.h"
#include "theory/friction_pressing.h"
#include "theory/half_space_interior.h"
#include "verification/verification_rows.h"

namespace tricontact::verification {

namespace {

using contact::StepRecord;

Case pressing_case(double nu, double friction) {
    Case c;
    c.indenter.radius = 40e-3;
    c.substrate = {5e6, nu};
    c.friction.coefficient = friction;
    c.load.normal_force = 20;
    c.load.tangential_force = 0;
    return c;
}

/// F_N rises with friction in equal steps.
std::vector<StepRecord> press(const Case& c, int n_steps, const Runner& runner) {
    const auto model = runner.make(contact::models::bem, c);
    contact::LoadStep step = contact::press_step(c);
    std::vector<StepRecord> records;
    for (int k = 1; k <= n_steps; ++k) {
        step.normal.value = *c.load.normal_force * k / n_steps;
        records.push_back(model->advance(step));
    }
    return records;
}

/// Cells and steps halve together: a ring that has just come into contact starts undragged.
void add_pressing(VerificationRow row, const Case& base, int cells, int steps, const Runner& runner,
                  Verification& all, double (*value)(const Case&, const std::vector<StepRecord>&)) {
    add_row(std::move(row), all, [&](int factor) -> LevelValue {
        const Case c = with_cells(base, cells * factor);
        return {relative_size(contact::models::bem, c), value(c, press(c, steps * factor, runner))};
    });
}

double stuck_ratio(const Case&, const std::vector<StepRecord>& records) {
    return std::sqrt(records.back().stick_area / records.back().contact_area);
}

/// dF/dd over 4 G a of the last quarter.
double stiffness_ratio(const Case& c, const std::vector<StepRecord>& records) {
    const StepRecord &last = records.back(), &before = records[records.size() * 3 / 4];
    const double a = std::sqrt((last.contact_area + before.contact_area) / 2 / std::numbers::pi);
    return (last.normal_force - before.normal_force) / (last.indentation - before.indentation) /
           (4 * c.substrate.shear_modulus() * a);
}

constexpr double ratio = 1.7, relaxes_in = .3, time = 3 * relaxes_in;

Case rubber() {
    Case c;
    c.indenter.radius = 40e-3;
    c.substrate = {4.5e6, .5};
    c.relaxation = contact::Relaxation{{{ratio, relaxes_in}}, {}};
    c.friction.coefficient = .5;
    c.contact.coupling = false;
    c.load.normal_force = 21.1;
    c.load.tangential_force = 0;
    return c;
}

/// d [mm] under F_N that was applied at once and stays.
double creep(contact::Model& model, const Case& c, int n_steps) {
    contact::LoadStep step = contact::press_step(c);
    step.duration = 0;
    model.advance(step);
    step.duration = time / n_steps;
    double d = 0;
    for (int k = 0; k < n_steps; ++k) d = model.advance(step).indentation;
    return d * 1e3;
}

/// Von Mises' stress over p0 on the axis of Hertz' contact, at the depth z.
double on_axis(const Case& c, const contact::HalfSpaceScales& hertz, double z) {
    const double a = hertz.contact_radius, p0 = hertz.peak_pressure;
    const auto line_load = [&](double t) {
        return std::numbers::pi / 2 * p0 * (a - t) * (a + t) / a;
    };
    const auto response = theory::axisymmetric_interior(c.substrate, line_load, a, 0, 0, z);
    std::array<double, 6> stress{};
    for (int k = 0; k < 6; ++k) stress[k] = response.stress[k][2] / p0;
    return contact::von_mises(stress);
}

}  // namespace

void verify_friction_pressing(const Runner& runner, Verification& all) {
    const double nu = .45, beta = (1 - 2 * nu) / (2 - 2 * nu), beta_over_mu = 1.4;
    add_pressing({"Pressed with friction", "c/a, nu = 0.45, beta/mu = 1.4", contact::models::bem,
                  "Goodman (1962), Spence (1968); Johnson, Contact Mechanics "
                  "(1985), section 5.4, weak coupling",
                  theory::spence_stick_ratio(beta_over_mu), .02, .8},
                 pressing_case(nu, beta / beta_over_mu), 12, 10, runner, all, stuck_ratio);
    add_pressing(
        {"Pressed without slip", "dF/dd over 4 G a, nu = 0", contact::models::bem,
         "Mossakovskii (1954), Spence (1968)", theory::stuck_normal_stiffness_ratio(0), 8e-3},
        pressing_case(0, 5), 12, 8, runner, all, stiffness_ratio);
}

void verify_creep(bool brief, const Runner& runner, Verification& all) {
    const Case base = rubber();
    // d^(3/2) follows the creep function 1 - g/(1+g) exp(-t/((1+g) tau)).
    const double crept = 1 - ratio / (1 + ratio) * std::exp(-time / ((1 + ratio) * relaxes_in));
    const double exact =
        contact::half_space_scales(base).indentation * std::pow(crept, 2. / 3) * 1e3;
    const int steps = brief ? 3 : 8, coarser = brief ? 8 : 1;
    for (const char* const model : {contact::models::mdr, contact::models::bem}) {
        add_row({"Creep under F_N", "d, mm, after 3 tau", model,
                 "Lee and Radok (1960), J. Appl. Mech. 27, 438", exact, 5e-4 * coarser, 1.6},
                all, [&](int factor) -> LevelValue {
                    Case c = base;
                    c.of<contact::Cells>().per_radius = (brief ? 5 : 8) * factor;
                    const int n = steps * factor;
                    runner.say(fmt::format("{}, creep in {} steps", model, n));
                    return {time / n / relaxes_in, creep(*runner.make(model, c), c, n)};
                });
    }
}

void verify_subsurface(bool brief, const Runner& runner, Verification& all) {
    const Case base = rig_sphere(0.3, 0);  // nu as in the textbooks
    const auto hertz = contact::half_space_scales(base);
    const double a = hertz.contact_radius;
    const auto lowest = boost::math::tools::brent_find_minima(
        [&](double z) { return -on_axis(base, hertz, z); }, .2 * a, a, 40);
    // No order: points lie a/25 apart, wherever the peak is.
    add_row(
        {"Below Hertz' contact", "largest von Mises stress over p0, nu = 0.3", contact::models::bem,
         "Huber (1904); Johnson, Contact Mechanics (1985), eq. 3.45; at 0.48 a", -lowest.second,
         brief ? 4e-3 : 1e-3},
        all, [&](int factor) -> LevelValue {
            Case c = base;
            c.of<contact::Cells>().per_radius = (brief ? 4 : 8) * factor;
            runner.say("bem, inside");
            const auto model = runner.make(contact::models::bem, c);
            contact::run(c, *model);
            const auto inside = contact::subsurface_of(*model->interior(), 0, {0, 0});
            return {relative_size(contact::models::bem, c),
                    inside.peak_von_mises / model->scales().peak_pressure};
        });
}

}  // namespace tricontact::verification
