#include "comparisons/strength/body_strength.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <tuple>
#include <utility>

#include "contact/half_space_scales.h"
#include "contact/load_path.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;
using contact::StepRecord;

/// Nothing but sliding is that close to the friction limit.
constexpr double slides_from = 1 - 1e-9;
constexpr double no_force = 1e-9;  // over F_N

/// F_T/(mu F_N), 1 of what slides.
double force_ratio(const Case& c, const ContactLoads& loads) {
    const double limit = c.friction_coefficient() * loads.normal_force;
    const double ratio = limit > 0 ? std::clamp(loads.tangential_force / limit, -1., 1.) : 0;
    if (std::abs(ratio) <= slides_from) return ratio;
    return ratio < 0 ? -1 : 1;
}

/// Where a bulk stress moves the circle that sticks under a ball: as of a line contact, by the
/// gradients that both have along x, of full sliding pi mu p0 (4 - 3 nu)/(16 G a) in either body
/// (Johnson 1985, eq. 7.35). Exact at nu = 0, where nothing moves along y; within 3 % of bem at .3.
double stick_centre_of_ball(const Case& c, const Strength& s, double ratio) {
    const auto gives_way = [](const contact::Material& m) {
        return m.is_rigid() ? 0 : (4 - 3 * m.poisson) / m.shear_modulus();
    };
    const double both =
        gives_way(c.substrate) + gives_way(c.indenter.material.value_or(contact::rigid_material));
    return (ratio < 0 ? -1 : 1) * 16 * s.contact_radius * s.loads.bulk_stress /
           (c.substrate.young * std::numbers::pi * c.friction_coefficient() * s.peak_pressure *
            both);
}

void add_body(const Case& c, const char* name, const contact::Material& material,
              std::optional<double> yield_stress, bool is_substrate, Strength& s) {
    if (!yield_stress) return;
    BodyStrength body{name, *yield_stress, {}};
    if (s.line) {
        theory::BulkStressLine line = *s.line;
        if (!is_substrate) {
            line.bulk_stress = 0;
            line.force_ratio *= -1;
        }
        body.peak = theory::line_stress_peak(line, material);
    } else {
        const double ratio = force_ratio(c, s.loads);
        body.peak = theory::sphere_stress_peak(
            material, s.contact_radius, s.peak_pressure, c.friction_coefficient(),
            is_substrate ? ratio : -ratio, is_substrate ? s.loads.bulk_stress : 0, s.stick_centre);
    }
    s.bodies.push_back(body);
}

Strength computed_strength(const Case& c, const ContactLoads& loads) {
    Case pressed = c;
    pressed.load.normal_force = loads.normal_force;
    pressed.load.indentation.reset();
    const contact::HalfSpaceScales hertz = contact::half_space_scales(pressed);
    Strength s{.loads = loads,
               .contact_radius = hertz.contact_radius,
               .peak_pressure = hertz.peak_pressure};
    const double ratio = force_ratio(c, loads);
    if (c.is_line_contact()) {
        s.line = theory::bulk_stress_line(c.materials().effective_modulus(), c.substrate,
                                          c.indenter.radius, loads.normal_force / c.indenter.length,
                                          c.friction_coefficient(), ratio, loads.bulk_stress);
        s.stick_centre = s.line->stick_centre;
        s.edges_hold = s.line->holds();
    } else if (loads.bulk_stress != 0 && std::abs(ratio) < 1) {
        s.stick_centre = stick_centre_of_ball(c, s, ratio);
        s.edges_hold =
            std::abs(s.stick_centre) < s.contact_radius * (1 - std::cbrt(1 - std::abs(ratio)));
    }
    if (!s.is_known()) return s;
    add_body(c, "substrate", c.substrate, c.yield_stress.substrate, true, s);
    if (c.indenter.material)
        add_body(c, "indenter", *c.indenter.material, c.yield_stress.indenter, false, s);
    if (s.line && !s.bodies.empty())
        s.shakedown_pressure = theory::line_shakedown_pressure(
            c.friction_coefficient(), s.softest().body == std::string_view("indenter")
                                          ? c.indenter.material->poisson
                                          : c.substrate.poisson);
    return s;
}

/// The largest normal force, and the largest tangential one with what acts together with it.
void enlarge(ContactLoads& largest, const ContactLoads& by) {
    largest.normal_force = std::max(largest.normal_force, by.normal_force);
    if (std::tuple(std::abs(by.tangential_force), std::abs(by.bulk_stress)) <=
        std::tuple(std::abs(largest.tangential_force), std::abs(largest.bulk_stress)))
        return;
    largest.tangential_force = by.tangential_force;
    largest.bulk_stress = by.bulk_stress;
}

/// All that computed_strength() depends on.
using Key = std::array<double, 14>;
Key key_of(const Case& c, const ContactLoads& loads) {
    const contact::Material indenter = c.indenter.material.value_or(contact::rigid_material);
    return {loads.normal_force,
            loads.tangential_force,
            loads.bulk_stress,
            c.indenter.radius,
            c.indenter.length,
            static_cast<double>(c.indenter.shape),
            indenter.young,
            indenter.poisson,
            c.substrate.young,
            c.substrate.poisson,
            c.friction_coefficient(),
            c.yield_stress.indenter.value_or(0),
            c.yield_stress.substrate.value_or(0),
            c.layer.thickness.value_or(0)};
}

}  // namespace

ContactLoads largest_loads(const Case& c, const contact::History& history) {
    ContactLoads loads;
    for (const StepRecord& step : history.steps)
        enlarge(loads, {step.normal_force, step.tangential_force[0], c.bulk_stress_at(step.phase)});
    // What the balance of forces leaves is none.
    if (std::abs(loads.tangential_force) < no_force * loads.normal_force)
        loads.tangential_force = 0;
    return loads;
}

double largest_bulk_stress(const Case& c) {
    double largest = c.load.bulk_stress;
    if (c.prescribed_path)
        for (const auto& row : c.prescribed_path->rows)
            if (std::abs(row.bulk_stress) > std::abs(largest)) largest = row.bulk_stress;
    return largest;
}

std::optional<ContactLoads> prescribed_loads(const Case& c, double tangential_ratio) {
    if (!c.prescribed_path && !std::isfinite(tangential_ratio)) return {};
    Case known = c;
    if (!c.prescribed_path) known.load.set_tangential_ratio(tangential_ratio);
    const contact::HalfSpaceScales hertz = contact::half_space_scales(known);
    const contact::LoadPath path =
        contact::make_load_path(known, hertz.normal_force, hertz.contact_radius);
    ContactLoads loads;
    double depth = 0;  // [m]
    for (const auto* steps : {&path.pressing, &path.loading, &path.period})
        for (const contact::LoadStep& step : *steps) {
            const contact::TangentialControl& along = step.tangential[0];
            if (along.kind != contact::TangentialControl::Kind::force) return {};
            const bool by_force = step.normal.kind == contact::NormalControl::Kind::force;
            if (!by_force) depth = std::max(depth, step.normal.value);
            enlarge(loads, {by_force ? step.normal.value : 0, along.value, step.bulk.stress[0]});
        }
    if (depth > 0) {
        known.load.normal_force.reset();
        known.load.indentation = depth;
        loads.normal_force = contact::half_space_scales(known).normal_force;
    }
    return loads;
}

const BodyStrength* Strength::weakest() const {
    const auto first = std::ranges::min_element(bodies, {}, &BodyStrength::factor);
    return first == bodies.end() ? nullptr : &*first;
}

std::optional<double> Strength::first_yield_force() const {
    const BodyStrength* body = weakest();
    if (!body || loads.bulk_stress != 0) return {};
    // p0 ~ F_N^(1/2) of a line contact, F_N^(1/3) of a sphere.
    return loads.normal_force * std::pow(body->factor(), line ? 2 : 3);
}

const BodyStrength& Strength::softest() const {
    return *std::ranges::min_element(bodies, {}, &BodyStrength::yield_stress);
}

std::optional<double> Strength::pressure_over_k() const {
    if (bodies.empty()) return {};
    return peak_pressure * std::numbers::sqrt3 / softest().yield_stress;
}

std::optional<Strength> strength_of(const Case& c, const ContactLoads& loads) {
    const bool asked = c.yield_stress.any() || c.has_bulk_stress();
    const bool is_hertz = contact::is_hertz_round(c) || c.indenter.shape == Case::Shape::cylinder;
    if (!asked || !is_hertz || !c.friction.is_coulomb() || c.has_hole() ||
        !(loads.normal_force > 0))
        return {};
    // Each quantity of a run asks for the same one.
    static thread_local std::pair<Key, std::optional<Strength>> last;
    const Key key = key_of(c, loads);
    if (!last.second || last.first != key) last = {key, computed_strength(c, loads)};
    return last.second;
}

}  // namespace tricontact::comparisons
