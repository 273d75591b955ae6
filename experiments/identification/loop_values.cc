#include "experiments/identification/loop_values.h"

#include <algorithm>
#include <map>

#include "contact/base/error.h"
#include "experiments/identification/friction_values.h"
#include "io/case/measurement_models.h"

namespace tricontact::experiments {

namespace {

using Table = IdentificationInput::Table;

// Mindlin's shift is straight over the nodes; of a strength, and of springs of the interface, so
// many leave 1e-5 of the force.
constexpr int n_nodes = 32;
constexpr int n_nodes_of_lines = 256;  // (1 - f) ln(1 - f) bends at sliding
constexpr double least_friction_of_drift = .05;

}  // namespace

LoopRows rows_of(const Table& table, const MeasuredLoop& loop) {
    const auto part = [&](const std::vector<double>& values) {
        return values.empty() ? std::span<const double>()
                              : std::span(values).subspan(loop.first, loop.n);
    };
    const auto begin = table.loops.rises.begin() + static_cast<std::ptrdiff_t>(loop.first);
    return {loop,
            part(table.given),
            part(table.observed),
            part(table.standard_errors.empty() ? table.row_errors.relative : table.standard_errors),
            {begin, begin + static_cast<std::ptrdiff_t>(loop.n)}};
}

LoopRows rows_of(const Table& table, const MeasuredLoop& loop, const std::vector<double>& errors) {
    LoopRows rows = rows_of(table, loop);
    rows.errors = std::span(errors).subspan(loop.first, loop.n);
    return rows;
}

double load_of(const MeasuredLoop& loop, const contact::Case& rig) {
    return loop.normal_force > 0 ? loop.normal_force : *rig.load.normal_force;
}

double friction_in(const Table& table, const MeasuredLoop& loop, const IdentifiedRig& rig) {
    const double range = table.loops.cycle_range();
    if (!(range > 0)) return 1;
    const double way = (loop.cycle - table.loops.mean_cycle()) / range;
    return std::max(least_friction_of_drift, 1 + rig.friction_drift * way);
}

bool has_loops_on_layer(const IdentificationInput& input) {
    return input.find(IdentificationInput::Measurement::friction_loop) &&
           io::measurement_model(input.models.front()).is_layer;
}

LoopCurve loop_curve(const IdentifiedRig& rig, double normal_force) {
    contact::Case c = relaxed(rig.as_case);
    c.load.normal_force = normal_force;
    const double limit = sliding_forces(rig.loops_on_layer, c, {normal_force}).front();
    std::vector<double> forces;
    const int n = c.is_line_contact() ? n_nodes_of_lines : n_nodes;
    for (int i = 0; i <= n; ++i)
        forces.push_back(LoopCurve::force_at(limit, static_cast<double>(i) / n));
    return {limit, rig.rig_compliance, theory_shifts(rig.loops_on_layer, c, forces)};
}

std::vector<LoopCurve> loop_curves(const Table& table, const IdentifiedRig& rig) {
    std::map<double, LoopCurve> made;
    std::vector<LoopCurve> curves;
    for (const MeasuredLoop& loop : table.loops.loops) {
        const double load = load_of(loop, rig.as_case);
        auto found = made.find(load);
        if (found == made.end()) found = made.emplace(load, loop_curve(rig, load)).first;
        curves.push_back(found->second);
    }
    return curves;
}

std::vector<FittedLoop> fitted_loops(const Table& table, const IdentifiedRig& rig,
                                     std::vector<LoopState>& starts) {
    const auto curves = loop_curves(table, rig);
    std::vector<FittedLoop> fits;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const MeasuredLoop& loop = table.loops.loops[i];
        fits.push_back(fit_loop(rows_of(table, loop), curves[i], friction_in(table, loop, rig),
                                false, starts.empty() ? nullptr : &starts[i]));
    }
    starts.clear();
    for (const FittedLoop& fit : fits) starts.push_back(fit.state);
    return fits;
}

std::vector<double> loop_forces(const Table& table, const IdentifiedRig& rig,
                                std::vector<LoopState>& starts) {
    std::vector<double> forces;
    for (const FittedLoop& fit : fitted_loops(table, rig, starts))
        forces.insert(forces.end(), fit.forces.begin(), fit.forces.end());
    return forces;
}

std::vector<std::vector<double>> loop_slopes(const Table& table, const IdentifiedRig& rig) {
    std::vector<std::vector<double>> columns;
    std::vector<LoopState> starts;
    const auto fits = fitted_loops(table, rig, starts);
    for (std::size_t i = 0; i < fits.size(); ++i)
        for (std::size_t k = 0; k < n_of_loop; ++k) {
            auto& column = columns.emplace_back(table.observed.size(), 0.);
            std::ranges::copy(fits[i].slopes[k], column.begin() + static_cast<std::ptrdiff_t>(
                                                                      table.loops.loops[i].first));
        }
    return columns;
}

}  // namespace tricontact::experiments
