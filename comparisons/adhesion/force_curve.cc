#include "comparisons/adhesion/force_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "comparisons/adhesion/adhesion_forms.h"
#include "report/format.h"
#include "report/plot_style.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;
using contact::History;
using contact::StepRecord;

constexpr std::size_t most_force_points = 3000;  // of a line: more than the picture has pixels

/// An empty curve with the name and colour of the model.
report::Curve curve_of_model(const History& history) {
    return {.name = report::display_name(history.model),
            .colour = report::model_style(history.model)};
}

double radius_of(const StepRecord& step) {
    return std::sqrt(step.contact_area / std::numbers::pi);
}

struct Units {
    report::Unit force, depth, radius;
};

Units units_of(const std::vector<History>& histories) {
    double force = 0, depth = 0, radius = 0;
    for (const History& history : histories)
        for (const StepRecord& step : history.steps) {
            force = std::max(force, std::abs(step.normal_force));
            depth = std::max(depth, std::abs(step.indentation));
            radius = std::max(radius, radius_of(step));
        }
    return {report::fitting_unit(force, "N"), report::fitting_unit(depth, "m"),
            report::fitting_unit(radius, "m")};
}

/// Stable and unstable, up to the widest contact of the runs.
void add_theory(const Case& c, const std::vector<History>& histories, const Units& units,
                report::Figure& curve, report::Figure& radii) {
    const auto forms = adhesive_forms(c);
    if (!forms) return;
    double widest = forms->contact_radius;
    for (const History& history : histories)
        for (const StepRecord& step : history.steps) widest = std::max(widest, radius_of(step));
    for (const AdhesiveEquilibria& exact : adhesive_equilibria(c)) {
        report::Curve by_depth{.name = exact.theory, .theory = true}, by_force = by_depth;
        constexpr int n = 200;
        for (int k = 1; k <= n; ++k) {
            const double radius = widest * k / n;
            const auto [depth, force] = exact.at(radius);
            by_depth.add(depth / units.depth.factor, force / units.force.factor);
            by_force.add(force / units.force.factor, radius / units.radius.factor);
        }
        curve.curves.push_back(std::move(by_depth));
        radii.curves.push_back(std::move(by_force));
    }
}

}  // namespace

std::vector<report::Figure> force_curve_figures(const Case& c,
                                                const std::vector<History>& histories) {
    if (!c.adhesion || !c.prescribed_path) return {};
    const Units units = units_of(histories);
    const report::FigureAxis force{"normal force F_N [" + units.force.symbol + "]"},
        depth{"indentation d [" + units.depth.symbol + "]"};
    report::Figure curve{
        .id = "force_curve",
        .title = "Force over depth",
        .caption =
            "All steps of the path; below zero the bodies are pulled. Where contact jumps "
            "in or lets go the line is straight. Dashed: equilibria of the half-space, "
            "those between the jumps unstable; of a range also those of none and of a long one.",
        .x = depth,
        .y = force};
    report::Figure radii{.id = "radius_curve",
                         .title = "Contact radius over force",
                         .caption = "Of a disc with the area of the contact; all steps.",
                         .x = force,
                         .y = {"contact radius [" + units.radius.symbol + "]"}};
    for (const History& history : histories) {
        report::Curve by_depth = curve_of_model(history), by_force = by_depth;
        for (const std::size_t k : report::thinned(history.steps.size(), most_force_points)) {
            const StepRecord& step = history.steps[k];
            by_depth.add(step.indentation / units.depth.factor,
                         step.normal_force / units.force.factor);
            by_force.add(step.normal_force / units.force.factor,
                         radius_of(step) / units.radius.factor);
        }
        curve.curves.push_back(std::move(by_depth));
        radii.curves.push_back(std::move(by_force));
    }
    add_theory(c, histories, units, curve, radii);
    return {std::move(curve), std::move(radii)};
}

report::DocumentTable jump_table(const std::vector<History>& histories) {
    report::DocumentTable table{
        .id = "jumps",
        .title = "Jumps",
        .note =
            "At the end of the step with the jump. E: energy that is lost in it; what the "
            "force works along a path that returns is the sum of all.",
        .columns = {
            {"model"}, {"row of the path"}, {"d [µm]"}, {"F_N [mN]"}, {"a [µm]"}, {"E [nJ]"}}};
    for (const History& history : histories)
        for (const StepRecord& step : history.steps) {
            if (!(step.released_energy > 0)) continue;
            table.rows.push_back({report::display_name(history.model), step.phase,
                                  step.indentation / 1e-6, step.normal_force / 1e-3,
                                  radius_of(step) / 1e-6, step.released_energy / 1e-9});
        }
    return table;
}

}  // namespace tricontact::comparisons
