#include "contact/load_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "contact/base/error.h"

namespace tricontact::contact {

namespace {

/// Step `k` of 4 `n` in a period as a triangular wave; the same offset has the same bits each time.
double triangle_of_step(int k, int n) {
    const double up = static_cast<double>(k % n) / n;
    const double down = static_cast<double>(n - k % n) / n;
    return std::array{up, down, -up, -down}[k / n % 4];
}

Vector2 direction(double angle) {
    // cos(pi/2) is 6e-17 in floating point; perpendicular rolling has no parallel part.
    auto clean = [](double value) { return std::abs(value) < 1e-15 ? 0.0 : value; };
    return {clean(std::cos(angle)), clean(std::sin(angle))};
}

/// From no load to that of `pressed`, all in proportion: with friction, or in time, step by step.
std::vector<LoadStep> pressing_steps(const Case& c, const LoadStep& pressed) {
    const bool friction = c.load.press == Case::Press::friction;
    const bool in_time = c.load.press_time && *c.load.press_time > 0;
    const int n = friction || in_time ? c.load.press_steps : 1;
    std::vector<LoadStep> steps(n, pressed);
    for (int k = 1; k <= n; ++k) {
        LoadStep& step = steps[k - 1];
        const double share = static_cast<double>(k) / n;
        step.normal.value *= share;
        for (TangentialControl& control : step.tangential) control.value *= friction ? share : 0;
        step.rotation *= friction ? share : 0;
        for (double& part : step.bulk.stress) part *= friction ? share : 0;
        for (double& part : step.bulk.strain) part *= friction ? share : 0;
        step.friction = friction;
        step.duration =
            c.load.press_time ? *c.load.press_time / n : std::numeric_limits<double>::infinity();
    }
    return steps;
}

/// The state at a row of a prescribed path.
LoadStep step_to(const Case& c, const PrescribedPath::Row& row, double phase) {
    LoadStep step;
    step.centre = c.prescribed_path->centre;
    step.bulk = c.bulk_state(row.bulk_stress);
    step.phase = phase;
    step.offset = row.offset;
    step.normal = row.normal;
    step.tangential = row.tangential;
    step.rotation = row.rotation;
    step.recurs = false;
    step.in_proportion = row.steps > 0;
    return step;
}

void check_carries(const Case& c, const LoadStep& step) {
    if (step.normal.kind == NormalControl::Kind::force)
        check_friction_limit(c, step.phase, prescribed_force(step.tangential), step.normal.value);
}

/// The first row by pressing, the others one after the other; phases count rows.
LoadPath prescribed(const Case& c) {
    const PrescribedPath& prescribed = *c.prescribed_path;
    LoadPath path;
    const LoadStep first = step_to(c, prescribed.rows.front(), 0);
    if (!prescribed.starts_unloaded()) {
        path.pressing = pressing_steps(c, first);
        // What has slid freely is loaded when it has been pressed.
        if (c.load.press == Case::Press::frictionless && prescribed.loads_first_row()) {
            path.loading.push_back(first);
            check_carries(c, first);
        }
    }
    for (std::size_t r = 1; r < prescribed.rows.size(); ++r) {
        const auto &from = prescribed.rows[r - 1], &to = prescribed.rows[r];
        const int n = std::max(1, to.steps);
        for (int k = 1; k <= n; ++k) {
            const double share = static_cast<double>(k) / n;
            LoadStep step = step_to(c, PrescribedPath::between(from, to, share),
                                    static_cast<double>(r - 1) + share);
            step.duration = prescribed.is_timed() ? (to.time - from.time) / n
                                                  : std::numeric_limits<double>::infinity();
            check_carries(c, step);
            path.loading.push_back(step);
        }
    }
    return path;
}

/// Waiting under constant loads: steps that grow as relaxation slows down.
std::vector<LoadStep> hold_steps(const LoadStep& loaded, double hold) {
    constexpr int n = 20;
    std::vector<LoadStep> steps;
    for (int k = 1; hold > 0 && k <= n; ++k) {
        const auto reached = [&](int i) { return hold * std::pow(static_cast<double>(i) / n, 3); };
        steps.push_back(loaded);
        steps.back().duration = reached(k) - reached(k - 1);
    }
    return steps;
}

}  // namespace

double check_friction_limit(const Case& c, double phase, double tangential_force,
                            double normal_force) {
    const double limit = c.friction.law()->limit({normal_force, infinity});
    if (tangential_force >= limit && tangential_force > 0)
        throw InputError(fmt::format(
            "load: the tangential force {:.6g} N reaches the friction limit mu F_N = {:.6g} N at "
            "phase {:.4g}; lower tangential_force, tangential_ratio or limit_fraction (or their "
            "amplitude)",
            tangential_force, limit, phase));
    return limit - tangential_force;
}

int steps_in_quarter(const Case::Rolling& rolling, double amplitude) {
    switch (rolling.steps) {
        case Case::Steps::turning_points:
            return 1;
        case Case::Steps::per_quarter:
            return rolling.steps_per_quarter;
        case Case::Steps::increment:
            break;
    }
    // Equal steps no longer than the increment; 1e-9 forgives the rounding of W / dW.
    return std::max(1, static_cast<int>(std::ceil(amplitude / rolling.increment - 1e-9)));
}

double triangle_wave(double phase) {
    const double p = phase - std::floor(phase);
    return p <= 0.25 ? 4 * p : (p <= 0.75 ? 2 - 4 * p : 4 * p - 4);
}

bool turning_points_suffice(const Case& c) {
    return !c.relaxation && pressure_falls(c) && c.load.normal_amplitude_ratio == 0 &&
           c.load.tangential_amplitude_ratio == 0;
}

bool ratio_of_loaded_step(const Case& c) {
    return c.load.indentation && c.load.tangential_ratio && !c.relaxation &&
           c.load.normal_amplitude_ratio == 0;
}

double crest_factor(const Case& c) {
    return 1 + std::abs(c.load.normal_amplitude_ratio);
}

double path_amplitude(const Case& c, double model_radius) {
    if (!c.rolling) return 0;
    const bool of_model = c.rolling->amplitude_reference == Case::AmplitudeReference::model;
    return rolling_amplitude(*c.rolling,
                             of_model ? model_radius : half_space_scales(c).contact_radius);
}

NormalControl mean_normal_control(const Case::Load& load) {
    if (load.normal_force) return {NormalControl::Kind::force, *load.normal_force};
    return {NormalControl::Kind::indentation, load.indentation.value()};
}

LoadStep press_step(const Case& c) {
    LoadStep step;
    step.normal = mean_normal_control(c.load);
    step.duration = std::numeric_limits<double>::infinity();
    return step;
}

Vector2 path_reach(const Case& c, double model_radius) {
    if (c.prescribed_path) return c.prescribed_path->reach();
    if (!c.rolling) return {0, 0};
    const double reach = path_amplitude(c, model_radius);
    const Vector2 along = direction(c.rolling->angle);
    return {std::abs(reach * along[0]), std::abs(reach * along[1])};
}

double path_direction(const Case& c) {
    if (c.prescribed_path) return c.prescribed_path->direction();
    return c.rolling ? c.rolling->angle : 0;
}

bool is_mirror_symmetric(const Case& c) {
    if (c.friction.map && c.friction.map->varies_along_y()) return false;
    if (c.prescribed_path) return c.prescribed_path->is_along_x();
    return !c.rolling || std::abs(std::sin(c.rolling->angle)) < 1e-12;
}

LoadPath make_load_path(const Case& c, double normal_force, double contact_radius,
                        double sliding_force) {
    if (c.prescribed_path) return prescribed(c);
    const double mean_force = c.load.tangential_force
                                  ? *c.load.tangential_force
                                  : c.friction.law()->limit({normal_force, sliding_force},
                                                            c.load.tangential_ratio.value());
    auto loads_at = [&](LoadStep& step) {
        auto factor = [&](double ratio, double shift) {
            return ratio == 0
                       ? 1
                       : 1 + ratio * triangle_wave(step.phase + shift / (2 * std::numbers::pi));
        };
        step.normal = mean_normal_control(c.load);
        step.normal.value *= factor(c.load.normal_amplitude_ratio, c.load.normal_phase);
        step.tangential[0].value =
            mean_force * factor(c.load.tangential_amplitude_ratio, c.load.tangential_phase);
        step.bulk = c.bulk_state(c.load.bulk_stress);
        if (step.normal.kind == NormalControl::Kind::force)
            check_friction_limit(c, step.phase, std::abs(step.tangential[0].value),
                                 step.normal.value);
    };

    LoadPath path;
    path.pressing = pressing_steps(c, press_step(c));
    path.loading.resize(1);
    loads_at(path.loading.front());
    const auto hold = hold_steps(path.loading.front(), c.load.hold);
    path.loading.insert(path.loading.end(), hold.begin(), hold.end());
    if (!c.rolling) return path;

    path.amplitude = path_amplitude(c, contact_radius);
    path.max_periods = c.rolling->periods;
    path.run_all = c.rolling->run_all;
    const int n = steps_in_quarter(*c.rolling, path.amplitude);
    const Vector2 along = direction(c.rolling->angle);
    const double duration = c.rolling->speed > 0 ? path.amplitude / n / c.rolling->speed
                                                 : std::numeric_limits<double>::infinity();
    for (int k = 1; k <= 4 * n; ++k) {
        LoadStep step;
        step.phase = k / (4.0 * n);
        const double distance = path.amplitude * triangle_of_step(k, n);
        step.offset = {distance * along[0], distance * along[1]};
        step.duration = duration;
        loads_at(step);
        path.period.push_back(step);
    }
    return path;
}

bool pressing_matters(const Case& c, bool coupled) {
    return coupled || c.relaxation.has_value() || is_nominally_flat(c);
}

std::vector<LoadStep> pressing_of_path(const Case& c, const LoadPath& path, bool coupled) {
    const bool all = pressing_matters(c, coupled) || c.prescribed_path->loads_first_row();
    const auto& steps = path.pressing;
    return {all || steps.empty() ? steps.begin() : steps.end() - 1, steps.end()};
}

}  // namespace tricontact::contact
