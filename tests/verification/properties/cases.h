#pragma once

#include <rapidcheck.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "bem/model.h"
#include "contact/cells.h"
#include "contact/load_path.h"
#include "contact/run.h"
#include "mdr/model.h"
#include "mdr/settings.h"

namespace tricontact::properties {

/// Uniform in [low, high], a thousand values.
inline double drawn(double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 1001) / 1000.;
}
/// Uniform in the logarithm.
inline double drawn_scale(double low, double high) {
    return std::exp(drawn(std::log(low), std::log(high)));
}

/// Scales of a case that must not matter once w, f_T and nu are given.
inline void draw_scales(contact::Case& c) {
    c.indenter.radius = drawn_scale(1e-3, 1);
    c.substrate.young = drawn_scale(1e5, 1e11);
    c.friction.coefficient = drawn_scale(.05, 1.5);
    const double a = c.indenter.radius * drawn_scale(.02, .3);
    c.load.normal_force =
        4. / 3 * c.materials().effective_modulus() * a * a * a / c.indenter.radius;
}

/// Rolling under constant loads on a coarse grid.
inline contact::Case random_case() {
    contact::Case c;
    c.substrate.poisson = drawn(0, .5);
    draw_scales(c);
    c.load.tangential_ratio = drawn(.05, .95);
    c.rolling.emplace();
    c.rolling->amplitude_ratio = drawn(.05, 1.1);
    c.rolling->angle = drawn(0, 2 * std::numbers::pi);
    c.rolling->periods = 2;
    c.rolling->run_all = true;
    c.rolling->steps_per_quarter = *rc::gen::inRange(1, 4);
    c.of<contact::Cells>().per_radius = drawn(5, 8);
    c.of<mdr::Settings>().springs = 300;
    return c;
}

/// The same with an elastic indenter, a ball or loads that oscillate, now and then.
inline contact::Case random_richer_case() {
    contact::Case c = random_case();
    if (*rc::gen::arbitrary<bool>()) c.indenter.material = c.substrate;  // equal: not coupled
    if (*rc::gen::arbitrary<bool>()) c.indenter.shape = contact::Case::Shape::sphere;
    if (*rc::gen::arbitrary<bool>()) {
        c.load.normal_amplitude_ratio = drawn(0, .5);
        c.load.normal_phase = drawn(0, 6);
        c.load.tangential_amplitude_ratio = drawn(0, 2);
        c.load.tangential_phase = drawn(0, 6);
        // F_T stays below mu F_N everywhere
        *c.load.tangential_ratio *=
            (1 - c.load.normal_amplitude_ratio) / (1 + c.load.tangential_amplitude_ratio);
    }
    return c;
}

inline std::unique_ptr<contact::Model> make_model(const std::string& name, const contact::Case& c) {
    return name == "mdr" ? mdr::make_model(c) : bem::make_model(c, 1);
}

inline contact::History run(const std::string& name, const contact::Case& c) {
    const auto model = make_model(name, c);
    return contact::run(c, *model);
}

/// Shift after each step over U_max, x and y.
inline std::vector<contact::Vector2> shift_ratios(const contact::History& h) {
    std::vector<contact::Vector2> u;
    for (const auto& step : h.steps)
        u.push_back({step.shift[0] / h.scales.unit_shift, step.shift[1] / h.scales.unit_shift});
    return u;
}

}  // namespace tricontact::properties
