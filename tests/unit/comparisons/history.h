#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>

#include "comparisons/quantities/quantity.h"
#include "contact/case.h"
#include "contact/history.h"
#include "theory/cattaneo_mindlin.h"
#include "theory/rolling/oscillating_rolling.h"

/// Histories made from closed forms, so that tests of the comparison need no solver.
namespace tricontact::synthetic {

struct Options {
    double f = 0.56, w = 0.24, angle = 0;
    int periods = 12;
    bool rolling = true;
    int n_x = 57, n_y = 47;
    int springs = 401;
    int steps_per_quarter = 6;
};

/// R = d = a = E* = G* = U_max = mu = 1, F_N = 4/3: every ratio can be computed by hand.
inline contact::Case unit_case(const Options& options = {}) {
    contact::Case c;
    c.title = "Unit case";
    c.models = {"mdr", "bem"};
    c.indenter.radius = 1;
    c.substrate = {1, 0};  // nu = 0: E* = G* = E under a rigid indenter
    c.friction.coefficient = 1;
    c.load.indentation = 1;
    c.load.tangential_ratio = options.f;
    if (options.rolling) {
        c.rolling.emplace();
        c.rolling->amplitude_ratio = options.w;
        c.rolling->angle = options.angle;
        c.rolling->periods = options.periods;
    }
    return c;
}

/// Scales, loads and loading step of the unit case; no rolling yet.
inline contact::History loaded_history(const std::string& model, const Options& options = {}) {
    contact::History history;
    history.model = model;
    history.scales = {.normal_force = 4. / 3,
                      .contact_radius = 1,
                      .indentation = 1,
                      .peak_pressure = 2 / std::numbers::pi,
                      .unit_shift = 1};
    history.friction_limit = 4. / 3;
    history.tangential_force = options.f * history.friction_limit;
    history.static_shift = theory::static_shift_ratio(options.f);
    history.steps.resize(1);
    history.steps.front().normal_force = history.scales.normal_force;
    history.steps.front().indentation = history.scales.indentation;
    history.steps.front().shift = {history.static_shift, 0};
    history.steps.front().force_residual = 1e-12;
    history.audit.record("friction_bound", 1e-13, 1e-10);
    history.audit.record("p >= 0 & gap >= 0", 0, 1e-10);
    history.cpu_s = 0.5;
    history.wall_s = 0.6;
    return history;
}

/// Adds a period that ends at the shift u and dissipates `work`.
inline void add_period(contact::History& history, const Options& options, double u, double work) {
    const double before = history.steps.back().shift[0];
    const int n = 4 * options.steps_per_quarter;
    const double start = static_cast<double>(history.shift_per_period.size());
    for (int k = 1; k <= n; ++k) {
        contact::StepRecord step;
        step.phase = start + static_cast<double>(k) / n;
        step.shift = {before + (u - before) * k / n, 0};
        step.dissipation = work / n;
        step.force_residual = 1e-11;
        history.steps.push_back(step);
    }
    history.shift_per_period.push_back(u);
    history.dissipation_per_period.push_back(work);
}

/// Settles geometrically (factor 1/4 per period) at MDR's closed form; needs f below the limit.
inline contact::History settling_history(const std::string& model, const Options& options = {}) {
    contact::History history = loaded_history(model, options);
    history.amplitude = options.w;
    history.limit_tangential_ratio = theory::shakedown_limit(options.w);
    const double end = theory::settled_shift_ratio(options.w, options.f).value();
    double gap = end - history.static_shift;
    for (int n = 1; n <= options.periods; ++n) {
        gap = n == options.periods ? 0 : gap / 4;
        add_period(history, options, end - gap, 0.1 * std::pow(0.25, n));
    }
    history.verdict = {.state = contact::State::shakedown, .remaining_error = 0, .missing = {}};
    return history;
}

/// Grows by `increment` per period.
inline contact::History ratcheting_history(const std::string& model, const Options& options,
                                           double increment) {
    contact::History history = loaded_history(model, options);
    history.amplitude = options.w;
    history.limit_tangential_ratio = theory::shakedown_limit(options.w);
    for (int n = 1; n <= options.periods; ++n)
        add_period(history, options, history.static_shift + n * increment, 0.3);
    history.verdict.state = contact::State::ratcheting;
    return history;
}

/// Empty fields of the given layout, spacing such that they reach 1.3 (a + W).
inline contact::Surface empty_surface(const Options& options, bool line) {
    contact::Surface s;
    s.layout = line ? contact::Surface::Layout::line : contact::Surface::Layout::grid;
    s.n_x = line ? options.springs : options.n_x;
    s.n_y = line ? 1 : options.n_y;
    const double reach = 1.3 * (1 + options.w);
    s.spacing = {2 * reach / (s.n_x - 1), line ? 0 : 2 * reach / (s.n_y - 1)};
    s.first = {-reach, line ? 0 : -reach};
    const std::size_t n = s.size();
    for (auto* field : {&s.normal_traction, &s.tangential_traction_x, &s.tangential_traction_y,
                        &s.friction_bound, &s.displacement_x, &s.displacement_y, &s.displacement_z,
                        &s.gap, &s.slip_x, &s.slip_y, &s.dissipation})
        field->assign(n, 0);
    if (line) {
        s.normal_line_load.assign(n, 0);
        s.tangential_line_load.assign(n, 0);
    }
    s.contact_state.assign(n, contact::ContactState::open);
    return s;
}

/// Hertz' pressure at the offset and Cattaneo-Mindlin's traction about the origin, capped by mu p.
inline contact::Surface surface(const Options& options, bool line, const contact::Vector2& offset) {
    contact::Surface s = empty_surface(options, line);
    s.offset = offset;
    const double p0 = 2 / std::numbers::pi;
    for (int j = 0; j < s.n_y; ++j)
        for (int i = 0; i < s.n_x; ++i) {
            const std::size_t k = static_cast<std::size_t>(j) * s.n_x + i;
            const double r2 = std::pow(s.x(i) - offset[0], 2) + std::pow(s.y(j) - offset[1], 2);
            if (r2 >= 1) continue;
            const double p = p0 * std::sqrt(1 - r2), rho = std::hypot(s.x(i), s.y(j));
            const double t = p0 * theory::cattaneo_mindlin_traction(rho, options.f);
            s.normal_traction[k] = s.friction_bound[k] = p;
            s.tangential_traction_x[k] = std::min(t, p);
            s.displacement_x[k] = theory::static_shift_ratio(options.f);
            s.contact_state[k] =
                t >= p ? contact::ContactState::slip : contact::ContactState::stick;
            if (!line) continue;
            s.normal_line_load[k] = 1 - r2;
            s.tangential_line_load[k] = std::min(theory::static_shift_ratio(options.f), 1 - r2);
        }
    return s;
}

/// Snapshots after loading and at the quarters of the first and the last period.
inline void add_snapshots(contact::History& history, const Options& options, bool line) {
    const auto at = [&](double phase, double distance) {
        history.snapshots.push_back({phase, surface(options, line,
                                                    {distance * std::cos(options.angle),
                                                     distance * std::sin(options.angle)})});
    };
    at(0, 0);
    const int periods = static_cast<int>(history.shift_per_period.size());
    for (int n = 1; n <= periods; ++n) {
        if (n != 1 && n != periods) continue;
        at(n - 0.75, options.w);
        at(n - 0.5, 0);
        at(n - 0.25, -options.w);
        at(n, 0);
    }
}

/// The quantity with a key.
inline const comparisons::Quantity& quantity_of(std::string_view key) {
    return **std::ranges::find_if(comparisons::all_quantities(),
                                  [=](const comparisons::Quantity* q) { return q->key == key; });
}

/// MDR (line) and BEM (grid), with snapshots.
inline std::vector<contact::History> two_models(const Options& options = {}) {
    std::vector<contact::History> histories;
    for (const char* model : {"mdr", "bem"}) {
        contact::History history = !options.rolling ? loaded_history(model, options)
                                   : theory::settled_shift_ratio(options.w, options.f)
                                       ? settling_history(model, options)
                                       : ratcheting_history(model, options, 0.3);
        add_snapshots(history, options, history.model == "mdr");
        histories.push_back(std::move(history));
    }
    return histories;
}

}  // namespace tricontact::synthetic
