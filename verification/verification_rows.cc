#include "verification/verification_rows.h"

#include <iterator>
#include <utility>

#include "comparisons/resolution/fineness.h"
#include "contact/cells.h"
#include "contact/half_space_scales.h"
#include "contact/models/model_kind.h"
#include "contact/run.h"
#include "fem/settings.h"
#include "mdr/settings.h"

namespace tricontact::verification {

using contact::History;

namespace {

void add_level(Levels& levels, const Case& c, double size, const Runner& runner) {
    runner.say(fmt::format("{}, level {}", levels.model, levels.sizes.size() + 1));
    levels.sizes.push_back(size);
    levels.histories.push_back(contact::run(c, *runner.make(levels.model, c)));
}

/// The step that applies F_T.
auto loaded(const History& h) {
    auto step = h.steps.begin();
    while (std::next(step) != h.steps.end() && std::next(step)->phase == 0) ++step;
    return step;
}

}  // namespace

Case refined(const std::string& model, Case c, int factor) {
    comparisons::change_resolution(c, contact::model_kind(model),
                                   {.finer = static_cast<double>(factor)});
    return c;
}

double relative_size(const std::string& model, const Case& c) {
    const contact::ModelKind& kind = contact::model_kind(model);
    if (kind.is_on_line())
        return 2 * (1 + *c.rolling->amplitude_ratio) / c.of<mdr::Settings>().springs;
    if (kind.is_on_cells() && c.of<contact::Cells>().per_radius)
        return 1 / *c.of<contact::Cells>().per_radius;
    return (kind.is_meshed() ? *c.of<fem::Settings>().size : *c.of<contact::Cells>().spacing) /
           contact::half_space_scales(c).contact_radius;
}

Case with_cells(Case c, double cells_per_radius) {
    c.of<contact::Cells>().spacing.reset();
    c.of<contact::Cells>().per_radius = cells_per_radius;
    return c;
}

Levels run_levels(const std::string& model, const Case& coarsest, const Runner& runner) {
    Levels levels{model, {}, {}};
    for (const int factor : {1, 2, 4}) {
        const Case c = refined(model, coarsest, factor);
        add_level(levels, c, relative_size(model, c), runner);
    }
    return levels;
}

Levels run_level(const std::string& model, const Case& c, double size, const Runner& runner) {
    Levels levels{model, {}, {}};
    add_level(levels, c, size, runner);
    return levels;
}

void add_row(VerificationRow row, Verification& all,
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
    c.friction.coefficient = 0.57;
    c.contact.coupling = false;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = tangential_ratio;
    return c;
}

void Rows::add(const Observed& observed, const std::string& source, double reference,
               const Allowed& allowed) {
    auto& row =
        verification_.rows.emplace_back(problem_, observed.name, levels_.model, source, reference,
                                        allowed.error, allowed.order, levels_.sizes);
    for (const History& history : levels_.histories) row.values.push_back(observed.of(history));
}

const Observed radius{"a, mm", [](const History& h) { return h.scales.contact_radius * 1e3; }};
const Observed indentation{"d, mm", [](const History& h) { return h.scales.indentation * 1e3; }};
const Observed peak_pressure{"p0, MPa",
                             [](const History& h) { return h.scales.peak_pressure * 1e-6; }};
const Observed unit_shift{"U_max, mm", [](const History& h) { return h.scales.unit_shift * 1e3; }};
const Observed limit{"f_T,lim", [](const History& h) { return h.limit_tangential_ratio; }};
const Observed static_shift{"U_stat, mm", [](const History& h) { return h.static_shift * 1e3; }};
const Observed static_ratio{"u_stat",
                            [](const History& h) { return h.static_shift / h.scales.unit_shift; }};
const Observed settled_ratio{
    "u_sd", [](const History& h) { return h.shift_per_period.back() / h.scales.unit_shift; }};
const Observed pressed_energy{"elastic energy, mJ",
                              [](const History& h) { return h.steps.front().stored_energy * 1e3; }};
const Observed loading_energy{
    "stored and dissipated under F_T, mJ", [](const History& h) {
        const auto end = loaded(h);
        return (end->stored_energy - h.steps.front().stored_energy + end->dissipation) * 1e3;
    }};
const Observed stick_ratio{"c/a", [](const History& h) {
                               return std::sqrt(loaded(h)->stick_area / std::numbers::pi) /
                                      h.scales.contact_radius;
                           }};

Verification verify(bool brief, const Runner& runner) {
    Verification all;
    verify_half_space(brief, runner, all);
    verify_layer(brief, runner, all);
    verify_cylinder(brief, runner, all);
    verify_creep(brief, runner, all);
    verify_subsurface(brief, runner, all);
    verify_rolling(brief, runner, all);
    if (brief) return all;
    verify_friction_pressing(runner, all);
    verify_peer_shifts(runner, all);
    verify_fem(runner, all);
    verify_walking(runner.say, all);
    return all;
}

}  // namespace tricontact::verification
