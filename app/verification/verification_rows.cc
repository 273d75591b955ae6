#include "app/verification/verification_rows.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "contact/run.h"

namespace tricontact::app {

using contact::Case;
using contact::History;

namespace {

void add_level(Levels& levels, const Case& c, double size, const Say& say) {
    say(fmt::format("{}, level {}", levels.model, levels.sizes.size() + 1));
    levels.sizes.push_back(size);
    levels.histories.push_back(contact::run(c, *make_model(levels.model, c, 1, say)));
}

/// The step that applies F_T.
auto loaded(const History& h) {
    auto step = h.steps.begin();
    while (std::next(step) != h.steps.end() && std::next(step)->phase == 0) ++step;
    return step;
}

}  // namespace

std::vector<Case> finer_cases(const Case& base, const SetLevel& set_level) {
    std::vector<Case> cases;
    for (int factor = 1; factor <= 4; factor *= 2) {
        cases.push_back(base);
        set_level(cases.back(), factor);
    }
    return cases;
}

Levels run_levels(const std::string& model, const Case& base, const SetLevel& set_level,
                  const Size& size, const Say& say) {
    Levels levels{model, {}, {}};
    for (const Case& c : finer_cases(base, set_level)) add_level(levels, c, size(c), say);
    return levels;
}

Levels run_level(const std::string& model, const Case& c, double size, const Say& say) {
    Levels levels{model, {}, {}};
    add_level(levels, c, size, say);
    return levels;
}

SetLevel cells_in_radius(double cells) {
    return [cells](Case& c, int factor) { c.bem.cells_per_radius = cells * factor; };
}
double cell_in_radius(const Case& c) {
    return 1 / *c.bem.cells_per_radius;
}

void add_row(comparisons::VerificationRow row, comparisons::Verification& all,
             const std::function<LevelValue(int factor)>& level) {
    for (const int factor : {1, 2, 4}) {
        const LevelValue found = level(factor);
        row.sizes.push_back(found.size);
        row.values.push_back(found.value);
    }
    all.rows.push_back(std::move(row));
}

Case rig_sphere(double poisson, double tangential_ratio) {
    Case c;
    c.indenter.radius = 40e-3;
    c.substrate = {5.2e6, poisson};
    c.friction_coefficient = 0.57;
    c.contact.coupling = false;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = tangential_ratio;
    return c;
}

double radius_mm(const History& h) {
    return h.scales.contact_radius * 1e3;
}
double indentation_mm(const History& h) {
    return h.scales.indentation * 1e3;
}
double peak_pressure_mpa(const History& h) {
    return h.scales.peak_pressure * 1e-6;
}
double unit_shift_mm(const History& h) {
    return h.scales.unit_shift * 1e3;
}
double limit(const History& h) {
    return h.limit_tangential_ratio;
}
double static_shift_mm(const History& h) {
    return h.static_shift * 1e3;
}
double static_ratio(const History& h) {
    return h.static_shift / h.scales.unit_shift;
}
double settled_ratio(const History& h) {
    return h.shift_per_period.back() / h.scales.unit_shift;
}
double stick_ratio(const History& h) {
    return std::sqrt(loaded(h)->stick_area / std::numbers::pi) / h.scales.contact_radius;
}
double pressed_energy_mj(const History& h) {
    return h.steps.front().stored_energy * 1e3;
}
double loading_energy_mj(const History& h) {
    const auto end = loaded(h);
    return (end->stored_energy - h.steps.front().stored_energy + end->dissipation) * 1e3;
}

}  // namespace tricontact::app
