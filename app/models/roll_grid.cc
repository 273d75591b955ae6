#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "app/models/make_model.h"
#include "app/models/roll_elements.h"
#include "app/models/roll_models.h"
#include "bem/steady_model.h"
#include "contact/base/stopped.h"
#include "contact/heat.h"
#include "contact/model_makers.h"
#include "contact/models/model_kind.h"
#include "io/keys/toml_document.h"
#include "rolling/creep_theory.h"
#include "rolling/rolling_document.h"
#include "rolling/run.h"
#include "theory/creep_law.h"
#include "theory/rolling/kalker.h"

namespace tricontact::app {

namespace {

using rolling::centre_line;
using rolling::drive_sign;
using rolling::RollingProblem;
using rolling::RollingRun;

/// F_N [N] of the pressed contact, which a prescribed indentation does not tell.
double normal_force(const Case& c, const contact::Substrate& substrate,
                    const RollingProblem& problem) {
    if (c.load.normal_force) return *c.load.normal_force;
    RollingProblem pressing = problem;
    pressing.drive = {};
    return rolling::TransientRolling(substrate, pressing).press().normal_force;
}

RollingProblem problem_of(const std::string& model, const Case& c,
                          const contact::Substrate& substrate) {
    const Case::TractiveRolling& given = *c.tractive_rolling;
    RollingProblem problem{
        .indenter = c.make_indenter(),
        .friction = c.friction.law(),
        .normal = contact::press_step(c).normal,
        .drive = {.creepage = {given.longitudinal_creepage, given.lateral_creepage},
                  .force = {},
                  .force_ratio = {},
                  .spin = given.spin},
        .coupling = c.contact.coupling,
        .tolerance = model_makers().solver_tolerance(model, c),
        .speed = given.speed,
        .rate = c.friction.rate};
    if (const auto* heat = c.kept.find<contact::ContactHeat>()) problem.heat = *heat;
    if (const auto& law = c.friction.temperature) problem.friction_temperature = *law;
    if (given.longitudinal_creepage) return problem;
    // What another law than Coulomb's carries in all, the loaded contact itself tells.
    const bool by_contact = contact::ratio_of_loaded_step(c) || !c.friction.is_coulomb();
    if (c.load.tangential_ratio && *c.load.tangential_ratio != 0 && by_contact) {
        problem.drive.force_ratio = c.load.tangential_ratio;
        return problem;
    }
    problem.drive.force[0] = c.load.tangential_force
                                 ? *c.load.tangential_force
                                 : *c.load.tangential_ratio * c.friction_coefficient() *
                                       normal_force(c, substrate, problem);
    return problem;
}

/// Rolls from rest.
void roll_on(const Case& c, rolling::TransientRolling& rolling, RollRecorder& recorder) {
    const double a = contact::half_space_scales(c).contact_radius, cell = rolling.cell();
    const int n_steps = static_cast<int>(std::lround(c.tractive_rolling->distance * a / cell));
    const auto surface = [&] { return rolling.surface(); };
    const auto note = [&](const rolling::RollingState& state) {
        recorder.note(state, state.distance / a, surface, cell / a / 2);  // the nearest step
    };
    note(rolling.press());
    for (int step = 1; step <= n_steps; ++step) {
        note(rolling.roll());
        recorder.tell(step, n_steps);
    }
}

/// At which all slides, about: by the stiffness of a circle of this area, or Carter's plane.
double sliding_creepage(const Case& c) {
    if (c.is_line_contact()) return rolling::creepage_unit(c);
    const theory::CombinedMaterial material = theory::combined_material(c.materials());
    const contact::HalfSpaceScales scales = contact::half_space_scales(c);
    return theory::sliding_creepage(scales.friction_limit, material.shear_modulus,
                                    scales.half_widths[0] * scales.half_widths[1],
                                    theory::vermeulen_johnson_coefficient(material.poisson));
}

/// `aside`: see bem::case_compliance.
RollingRun roll_on_grid(const std::string& model, const Case& c, const RollRuns& runs,
                        double aside) {
    const contact::ModelKind& kind = contact::model_kind(model);
    const bem::Body body = kind.is_half_space() ? bem::Body::half_space : bem::Body::layer;
    RollRecorder recorder{{model, {}, {}, {}}, runs, c.friction};
    RolledElements elements;
    if (kind.is_meshed()) elements = rolled_elements(model, c, runs, aside);
    recorder.run.variation = elements.variation;
    const auto substrate = kind.is_meshed() ? std::move(elements.substrate)
                                            : bem::make_substrate(c, runs.threads, body, aside);
    RollingProblem problem = problem_of(model, c, *substrate);
    rolling::TransientRolling rolling(*substrate, problem);
    roll_on(c, rolling, recorder);
    contact::require_sound(rolling.audit(), model);
    const auto crept =
        substrate->relaxes() ? bem::steady_compliance(c, runs.threads, body, aside) : nullptr;
    const auto steady_at = [&] {
        return crept ? rolling::steady_rolling(*crept, problem)
                     : rolling::steady_rolling(*substrate, problem);
    };
    rolling::SteadyRolling steady =
        crept || !substrate->relaxes()
            ? steady_at()
            : rolling::roll_until_steady(rolling, recorder.run.history.transient);
    contact::require_sound(steady.audit, model);
    recorder.run.history.temperatures = std::move(steady.temperatures);
    recorder.note_steady(steady.state, std::move(steady.surface));
    if (runs.both_ends && rolling::friction_changes(c) && problem.drive.creepage[0]) {
        problem.slip_start = rolling::SlipStart::fast;
        rolling::RollingHistory& history = recorder.run.history;
        problem.other_state = &history.surface;
        history.why_no_fast_slip = contact::why_it_stopped([&] {
            const auto fast = steady_at();
            contact::require_sound(fast.audit, model);
            history.from_fast_slip = fast.state;
        });
        problem.slip_start = rolling::SlipStart::slow;
        problem.other_state = nullptr;
    }
    // Who rolls freely has a curve about the creepage that it has by itself.
    const bool free =
        !problem.drive.creepage[0] && !problem.drive.force_ratio && problem.drive.force[0] == 0;
    recorder.add_curve(free ? recorder.run.history.steady.creepage.longitudinal : 0,
                       drive_sign(c) * sliding_creepage(c), [&](double creepage) {
                           problem.drive.creepage[0] = creepage;
                           const auto point = steady_at();
                           contact::require_sound(point.audit, model);
                           return point.state;
                       });
    return std::move(recorder.run);
}

}  // namespace

RollingRun roll(const std::string& model, const Case& c, const RollRuns& runs) {
    if (contact::model_kind(model).is_on_line()) return roll_springs(c, runs);
    // Friction moves a coupled contact aside. How far, its solution tells.
    for (double aside = 0;;) {
        try {
            return roll_on_grid(model, c, runs, aside);
        } catch (const contact::ContactAtEdge& reached) {
            aside = bem::more_room(aside, reached);
        }
        if (runs.begin_again) runs.begin_again();
    }
}

std::string roll_summary(const rolling::RollingReport& report, const std::string& resolved) {
    nlohmann::ordered_json json{{"version", report.version}, {"case", io::case_json(resolved)}};
    json.update(rolling::rolling_json(report));
    return json.dump(2) + '\n';
}

void RollRecorder::note(const rolling::RollingState& state, double way, const Surface& surface,
                        double tolerance) {
    using rolling::line_distances;
    run.history.transient.push_back(state);
    const std::size_t before = next_line;
    while (next_line < std::size(line_distances) && way + tolerance >= line_distances[next_line])
        ++next_line;
    const bool line = next_line > before;
    const auto frame = [&](double at) { return std::floor((at + tolerance) * runs.frames); };
    const bool shown = runs.show && (line || frame(way) > frame(last_shown));
    if (!line && !shown) return;
    const contact::Surface now = surface();
    if (line) run.lines.push_back(centre_line(now, friction, state));
    if (!shown) return;
    last_shown = way;
    runs.show(way, state, now);
}

void RollRecorder::note_steady(const rolling::RollingState& state, contact::Surface surface) {
    run.lines.push_back(centre_line(surface, friction, state));
    run.history.steady = state;
    run.history.surface = std::move(surface);
    if (runs.show_steady) runs.show_steady(run.history);
}

void RollRecorder::add_curve(double begin, double sliding,
                             const std::function<rolling::RollingState(double)>& steady_at) {
    constexpr double beyond = 1.25;  // the cubic law ends early for most
    const int n = runs.points, n_steps = static_cast<int>(run.history.transient.size()) - 1;
    for (int i = 1; i <= n; ++i) {
        const double creepage = beyond * sliding * (1 - std::cbrt(1 - i / static_cast<double>(n)));
        run.creep_curve.push_back(steady_at(begin + creepage));
        tell(n_steps + i, n_steps);
    }
}

}  // namespace tricontact::app
